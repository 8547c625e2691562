"""Levers: what can be moved on a pattern, each with what it would do to what the pattern shows."""
