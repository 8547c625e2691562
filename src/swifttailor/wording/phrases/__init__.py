"""Phrases: bits of language, each with the claims that it makes."""
