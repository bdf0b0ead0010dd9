"""The engine: plans, runs, judges and shows re-runs of published papers; it knows no paper."""
