"""Cuts by given amounts; each returns None where the pattern does not allow it."""
