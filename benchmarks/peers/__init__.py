"""The peers, each run by a Python of its own environment."""
