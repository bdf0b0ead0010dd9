"""Write the lists of expected verdicts anew, from reports/results.json: `nox -s expect`.

Do so only with a line in CHANGELOG.md that says which verdict changed and why. On what machine the
listed values came out stands beside, since another one may give other last digits.
"""

import csv
import json
from pathlib import Path

from repro.commands.catalogue import expected_file
from repro.commands.expected_verdicts import COLUMNS, verdict_rows
from repro.determinism.provenance import DECISIVE

MACHINE = Path(__file__).with_name("expected_machine.json")


def main(reports: Path = Path("reports")) -> None:
    """Write every list, and the machine."""
    results = json.loads((reports / "results.json").read_text(encoding="utf-8"))
    for entry in results["papers"]:
        with expected_file(entry["key"]).open("w", encoding="utf-8", newline="") as file:
            csv.writer(file, lineterminator="\n").writerows([COLUMNS, *verdict_rows(entry)])
    provenance = json.loads((reports / "provenance.json").read_text(encoding="utf-8"))
    environments = next(iter(provenance["papers"].values()))["environments"]
    decisive = {name: environments[0][name] for name in DECISIVE}
    MACHINE.write_text(json.dumps(decisive, indent=1) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
