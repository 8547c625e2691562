"""Stage 1 (paper, Sec. 4.1): from words and pictures to a sewing pattern. See docs/pattern-maker.md.

May import pattern, networks and what lies below wishes.
"""
