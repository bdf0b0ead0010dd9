"""The command line: one command is found by its name and called."""

import importlib
import sys
from collections.abc import Sequence

from repro.commands.arguments import parsed
from repro.commands.kept_output import told
from repro.commands.streams import one_line, shown_streams
from repro.commands.surroundings import prepare
from repro.errors import INTERRUPTED, TERMINATED, ReproError, Terminated


def main(arguments: Sequence[str] | None = None) -> int:
    """Run one command and return its exit code; bad input is one line on stderr."""
    prepare()
    with shown_streams():
        try:
            return _called(arguments)
        except ReproError as error:
            sys.stderr.writelines(f"repro: {line}\n" for line in str(error).splitlines() or [""])
            return error.exit_code
        except OSError as error:  # of a folder or a file that nobody looked at before
            place = f"{error.filename}: " if error.filename else ""
            sys.stderr.write(f"repro: {one_line(f'{place}{error.strerror or error}')}\n")
            return ReproError.exit_code
        except KeyboardInterrupt as interrupt:
            sys.stderr.write(
                "\nrepro: interrupted; finished runs are kept, the same call goes on\n"
            )
            return TERMINATED if isinstance(interrupt, Terminated) else INTERRUPTED


def _called(arguments: Sequence[str] | None) -> int:
    options = parsed(arguments)
    if told(options):
        return 0  # no paper is loaded where nothing changed
    # of all commands this one alone is loaded
    code: int = importlib.import_module(f"repro.commands.{options.command}").run(options)
    faulty = getattr(options, "faulty", False)  # a paper that was asked for, beside others
    return code or (ReproError.exit_code if faulty else 0)


if __name__ == "__main__":
    sys.exit(main())
