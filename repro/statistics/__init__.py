"""Statistics of tables of runs: summaries that survive tiny values, resampling, rank tests."""
