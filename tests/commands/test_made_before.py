from dataclasses import replace
from pathlib import Path

import pytest

from repro.__main__ import main
from repro.commands.listing_text import in_words
from repro.commands.made_before import changed_since, remember, unreadable
from tests.small_papers import EXPERIMENT, PAPER, Bowl, Guessing, let_be_known

WIDER = replace(EXPERIMENT, algorithms={**EXPERIMENT.algorithms, "wide": Guessing(width=5.0)})


def test_nothing_is_said_of_what_is_as_it_was_or_never_ran(tmp_path: Path) -> None:
    assert changed_since(tmp_path, PAPER) == {}
    remember(tmp_path, [PAPER])

    assert changed_since(tmp_path, PAPER) == {}


def test_a_changed_field_is_named_for_the_runs_that_it_decides(tmp_path: Path) -> None:
    remember(tmp_path, [PAPER])

    changed = changed_since(tmp_path, replace(PAPER, experiments=(WIDER,)))

    assert changed == {("search", "bowl", "wide"): ("algorithm.width",)}


def test_what_is_remembered_of_other_papers_stays(tmp_path: Path) -> None:
    moved = replace(EXPERIMENT, problems={"bowl": Bowl(centre=(0.0, 0.0))})
    remember(tmp_path, [PAPER])
    remember(tmp_path, [replace(PAPER, key="other2020", experiments=(moved,))])

    (first, second) = changed_since(tmp_path, replace(PAPER, experiments=(moved,))).values()

    assert first == second
    assert "problem.centre" in first


def test_a_memory_that_cannot_be_read_says_nothing(tmp_path: Path) -> None:
    for text in ("", "[]", '{"parts": [], "cells": {"a/b/c/d": [3]}}'):
        (tmp_path / "made-of.json").write_text(text)

        assert changed_since(tmp_path, PAPER) == {}
        assert unreadable(tmp_path)


def test_a_memory_that_cannot_be_read_is_set_aside_and_not_replaced(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "made-of.json").write_text("somebody's")

    remember(tmp_path, [PAPER])

    assert (tmp_path / "made-of-set-aside-1.json").read_text() == "somebody's"
    assert "made-of.json cannot be read; it is set aside as " in capsys.readouterr().err
    assert not unreadable(tmp_path)


def test_a_few_names_are_shown_and_the_others_counted() -> None:
    assert in_words("abcdef") == "a, b, c, d and 2 more"


def test_list_says_which_runs_are_missing_and_why(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    let_be_known(monkeypatch, PAPER)
    assert main(["reproduce", "--repeats", "1", "--protocol-only"]) == 0
    let_be_known(monkeypatch, replace(PAPER, experiments=(WIDER,)))
    capsys.readouterr()

    assert main(["list", "--repeats", "1"]) == 0

    assert "changed since they ran: algorithm.width (of wide on bowl)" in capsys.readouterr().out
