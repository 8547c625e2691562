"""Captions written from the pattern itself: measured facts, claims about them, and words for the claims."""
