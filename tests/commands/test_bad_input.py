"""Every bad input is refused with its exit code or exception, and by name."""

import re
from collections import Counter
from pathlib import Path

import pytest

from repro.__main__ import main
from repro.errors import DeclarationError, InputError
from tests.bad_inputs import (
    API,
    COMMANDS,
    DECLARATIONS,
    STORES,
    USAGES,
    bytes_in,
    rewritten,
)
from tests.small_papers import PAPER, let_be_known
from tests.small_stores import read

pytestmark = pytest.mark.faults


@pytest.fixture
def here(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Go to a folder with a file and stores of several kinds; only the small paper is known."""
    let_be_known(monkeypatch, PAPER)
    monkeypatch.chdir(tmp_path)
    Path("file").write_text("in the way")
    bytes_in("runs.sqlite", b"a poem " * 999)(Path("foreign"))
    rewritten("pragma user_version = 3")(Path("newer"))
    rewritten("update run set cost = 0 where id = 2")(Path("harmed"))
    Path("hollow/runs.sqlite").mkdir(parents=True)
    return tmp_path


@pytest.mark.usefixtures("here")
@pytest.mark.parametrize("kind", COMMANDS)
def test_bad_command_is_one_line_with_its_exit_code(
    kind: str, capsys: pytest.CaptureFixture[str], tally: Counter[str]
) -> None:
    arguments, code, message = COMMANDS[kind]

    assert main(arguments) == code

    err = capsys.readouterr().err
    assert message in err
    assert err.startswith("repro: ")
    assert (err.count("\n"), "\x1b" in err) == (1, False)
    tally["bad inputs refused"] += 1


@pytest.mark.parametrize("kind", USAGES)
def test_bad_usage_is_explained_with_exit_code_2(
    kind: str, capsys: pytest.CaptureFixture[str], tally: Counter[str]
) -> None:
    arguments, message = USAGES[kind]

    with pytest.raises(SystemExit) as end:
        main(arguments)

    assert end.value.code == 2
    assert message in capsys.readouterr().err
    tally["bad inputs refused"] += 1


@pytest.mark.parametrize("kind", DECLARATIONS)
def test_bad_declaration_is_refused_by_name(kind: str, tally: Counter[str]) -> None:
    declare, message = DECLARATIONS[kind]

    with pytest.raises(DeclarationError, match=re.escape(message)):
        declare()
    tally["bad inputs refused"] += 1


@pytest.mark.parametrize("kind", API)
def test_bad_call_is_refused_by_name(kind: str, tally: Counter[str]) -> None:
    call, message = API[kind]
    pattern = message if "|" in message else re.escape(message)

    with pytest.raises(InputError, match=pattern):
        call()
    tally["bad inputs refused"] += 1


@pytest.mark.parametrize("kind", STORES)
def test_bad_store_is_refused_by_its_readers(
    kind: str, tmp_path: Path, tally: Counter[str]
) -> None:
    spoil, error, message = STORES[kind]
    spoil(tmp_path / "store")

    with pytest.raises(error, match=re.escape(message)):
        read(tmp_path / "store")
    tally["bad inputs refused"] += 1


def test_the_tables_hold_sixty_bad_inputs_and_more() -> None:
    assert len([*COMMANDS, *USAGES, *DECLARATIONS, *API, *STORES]) >= 60
