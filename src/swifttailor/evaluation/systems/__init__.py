"""Systems that make garments: any generator of patterns with any way to sew them, in the paper's tables.

May import what `evaluation` may.
"""
