"""How fast it runs: `nox -s bench` measures and writes RESULTS.md and cost.svg."""
