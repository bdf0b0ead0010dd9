import importlib

import pytest

from repro.commands.arguments import DEFAULT_REPEATS, parsed, parser

NAMES = (
    *("reproduce", "report", "list", "compare", "again", "audit", "certify", "references"),
    *("verify", "flips"),
)


@pytest.mark.parametrize("name", ["reproduce", "report", "list", "audit", "certify", "references"])
def test_command_takes_any_papers_and_knows_what_to_call(name: str) -> None:
    options = parser().parse_args([name, "doe2021", "roe2022"])

    assert options.keys == ["doe2021", "roe2022"]
    assert callable(importlib.import_module(f"repro.commands.{options.command}").run)


@pytest.mark.parametrize(
    ("call", "place"),
    [
        (("compare", "mine:f", "--runs", "3", "doe2021", "--quiet", "roe2022"), "given"),
        (("reproduce", "doe2021", "--repeats", "3", "roe2022"), "keys"),
        (("motion", "a.toml", "--seconds", "3", "b.toml"), "files"),
    ],
)
def test_options_may_stand_between_names(call: tuple[str, ...], place: str) -> None:
    names = [name for name in call[1:] if not name.startswith("-") and name != "3"]

    assert getattr(parsed(call), place) == names


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
