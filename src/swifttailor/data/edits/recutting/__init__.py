"""Recutting patterns: longer, shorter, wider, with parts added or removed, all seams still fitting."""
