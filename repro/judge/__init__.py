"""Conclusions as data: findings, readings, certificates, standings."""
