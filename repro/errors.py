"""What can go wrong, and the exit code that the command line gives for it."""

SOME_RUN_FAILED = 1
INTERRUPTED = 130
TERMINATED = 143


class ReproError(Exception):
    """An error whose message names the place, the value and the alternatives."""

    exit_code = 2


class DeclarationError(ReproError, ValueError):
    """A paper module declares something that cannot be."""


class InputError(ReproError, ValueError):
    """A caller asked for something that cannot be done."""


class NotProvedError(ReproError):
    """No motion could be proved to obey, or no bound be proved."""


class StoreError(ReproError):
    """The store is locked, newer than this program, or damaged."""

    exit_code = 3


class Terminated(KeyboardInterrupt):
    """Somebody asked this process to end, by SIGTERM."""


class DamageError(StoreError):
    """A row of the store, or its file, is not what was written."""


class ClusterLostError(ReproError):
    """The cluster went away; what is finished is stored and the next call goes on from there."""

    exit_code = 75
