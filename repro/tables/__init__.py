"""Printed tables: reading them, exact arithmetic, every check that a table alone allows."""
