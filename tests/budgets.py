"""How many examples a test tries whose single example costs more than most."""

from hypothesis import settings

SHORT = settings.get_profile("tests").max_examples


def examples(few: int) -> int:
    """Return a few in the profile "tests", and as many times more as another profile asks for."""
    return few * settings().max_examples // SHORT
