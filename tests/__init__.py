"""Tests of the engine, and the contract that every paper module meets."""
