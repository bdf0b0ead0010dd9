"""What makes the same bits come out again: seeds, draws, compilation, digests, provenance."""
