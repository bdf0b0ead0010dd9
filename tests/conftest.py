"""How many examples property-based tests try: HYPOTHESIS_PROFILE is "tests" or "fuzz"."""

import os

from hypothesis import settings

# compiled kernels make the first example slow, so no example has a deadline
settings.register_profile("tests", max_examples=200, deadline=None)
settings.register_profile("fuzz", max_examples=10_000, deadline=None)
settings.load_profile(os.environ.get("HYPOTHESIS_PROFILE", "tests"))
