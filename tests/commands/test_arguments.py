import importlib

import pytest

from repro.commands.arguments import DEFAULT_REPEATS, parser

NAMES = (
    *("reproduce", "report", "list", "compare", "again", "audit", "certify", "references"),
    *("verify", "flips"),
)


@pytest.mark.parametrize("name", ["reproduce", "report", "list", "audit", "certify", "references"])
def test_command_takes_any_papers_and_knows_what_to_call(name: str) -> None:
    options = parser().parse_args([name, "doe2021", "roe2022"])

    assert options.keys == ["doe2021", "roe2022"]
    assert callable(importlib.import_module(f"repro.commands.{options.command}").run)


def test_usual_call_needs_no_option() -> None:
    options = parser().parse_args(["reproduce"])

    assert (options.keys, options.repeats, options.workers) == ([], DEFAULT_REPEATS, None)
    assert (str(options.store), str(options.reports)) == (".repro", "reports")
    assert (options.master_seed, options.protocol_only, options.dask) == ("", False, None)


def test_private_report_is_never_written_among_the_public_ones() -> None:
    options = parser().parse_args(["compare", "mine:Search"])

    assert str(options.reports) == "reports-private"
    assert options.repeats == 1


def test_every_command_is_described(capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit):
        parser().parse_args(["--help"])

    text = capsys.readouterr().out
    assert all(name in text for name in NAMES)
