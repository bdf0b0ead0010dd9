"""The papers of this house, found once for all tests that only read them."""

from repro.commands.catalogue import all_papers

PAPERS = all_papers()
