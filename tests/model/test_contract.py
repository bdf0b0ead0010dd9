from dataclasses import replace

from repro.model.assumptions import Alternative, Assumption
from repro.model.contract import contract_faults, house_notes
from repro.model.open_points import Erratum, Gap
from tests.small_papers import PAPER, TABLE

CHOICE = Assumption(
    what="box", chosen="wide", where="p. 3", because="none is printed",
    alternatives=(Alternative(says="narrow", untried="no size is printed"),),
)  # fmt: skip


def test_a_paper_that_keeps_the_contract_has_no_fault() -> None:
    assert list(contract_faults(replace(PAPER, assumptions=(CHOICE,)))) == []


def test_each_fault_is_named_with_its_place() -> None:
    silent = replace(CHOICE, because=" ", chosen="narrow", where="")
    wrong = replace(
        PAPER,
        assumptions=(silent,),
        errata=(Erratum(where="p. 1", printed="1OO", used="100", because=""),),
        gaps=(Gap(what="a field", where="", because="x"),),
        inputs=(replace(TABLE, where=TABLE.label),),
    )

    assert list(contract_faults(wrong)) == [
        "2 tables are called 'Table 1': a label names one table",
        "Table 1: it does not say where it stands, as in 'Table 1, p. 3'",
        "assumption 'box': it does not say where it stands in the paper (where)",
        "gap 'a field': it does not say where it stands in the paper (where)",
        "assumption 'box': it has no reason (because)",
        "assumption 'box': 'narrow' is both chosen and an alternative",
        "erratum '1OO': it has no reason (because)",
    ]


def test_what_this_house_asks_besides_is_said_apart() -> None:
    notes = list(house_notes(PAPER))

    assert "its tables were not transcribed a second time, blind (read_twice)" in notes
    assert list(contract_faults(PAPER)) == []
