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


def test_option_that_no_check_uses_says_so() -> None:
    (found,) = audit_text(ZERO_SPREAD, AuditOptions(runs=2, alpha=0.01))

    assert "alpha is told, but no check of a file uses it yet" in [g.says for g in found.guesses]
