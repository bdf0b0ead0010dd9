"""What `repro compare` accepts besides what other commands do."""

import argparse

_NARROW = (
    ("--experiment", "experiments", "an experiment, by its name on the page"),
    ("--problem", "problems", "a problem"),
    ("--algorithm", "against", "an algorithm or baseline to stand beside"),
)


def add_compare_options(parser: argparse.ArgumentParser) -> None:
    """Add searches, papers, and what narrows the work."""
    parser.add_argument(
        "given", nargs="+", metavar="MODULE:OBJECT… [PAPER…]",
        help="searches, each in a module or a FILE.py: a callable, an object with minimise or with "
        "ask and tell; then papers, each a key, a file or folder, or the key of an installed "
        "package (default: all)",
    )  # fmt: skip
    parser.set_defaults(several="given")
    parser.add_argument(
        "--name", action="append", default=[], dest="names",
        help="what the pages call it (default: OBJECT); once for each search",
    )  # fmt: skip
    for option, place, text in _NARROW:
        parser.add_argument(
            option, action="append", default=[], dest=place, metavar="NAME",
            help=f"{text}; may be given again (default: all)",
        )  # fmt: skip
    parser.add_argument(
        "--runs", type=int, metavar="N", help="runs of each repeat (default: the protocol's)"
    )
    parser.add_argument(
        "--timeout", type=float, metavar="SECONDS", help="give a run up after so long"
    )
    parser.add_argument(
        "--no-centre-bias", action="store_false", dest="centre_bias",
        help="run nothing with optima moved off the centre of the box, which is three runs for one",
    )  # fmt: skip
    parser.add_argument("--quiet", action="store_true", help="no progress")
