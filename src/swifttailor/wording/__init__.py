"""Putting what a garment shows into words: captions, instructions, wishes read back to people.

May import describing and what lies below it.
"""
