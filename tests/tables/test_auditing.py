from repro.tables.audit_options import AuditOptions
from repro.tables.auditing import audit_text

ZERO_SPREAD = "F,Best,Worst,Std\nF1,0,1.00E-25,0.00E+00\n"


def test_single_precision_takes_back_what_needs_doubles() -> None:
    (open_one,) = audit_text(ZERO_SPREAD, AuditOptions(runs=2))
    (single,) = audit_text(ZERO_SPREAD, AuditOptions(runs=2, precision="single"))
    (double,) = audit_text(ZERO_SPREAD, AuditOptions(runs=2, precision="double"))

    assert open_one.rows
    assert not open_one.proofs
    assert not single.rows
    assert len(double.rows) == len(open_one.rows)


def test_digits_that_are_told_change_nothing_and_it_is_said() -> None:
    (found,) = audit_text(ZERO_SPREAD, AuditOptions(runs=2, significant=4))

    says = "significant is told; whole numbers may be rounded to three digits anyway"
    assert says in [guess.says for guess in found.guesses]
