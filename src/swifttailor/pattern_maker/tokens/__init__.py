"""Patterns as tokens and numbers, and back (AIpparel's scheme); the grammar that keeps them patterns."""
