"""Exact lower bounds of times."""
