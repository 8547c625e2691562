"""Edits: pairs of patterns with an instruction that leads from one to the other."""
