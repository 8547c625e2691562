"""What a picture shows of a garment: the statements and measures that are made about patterns, with certainty.

May import describing, body, render, networks and what lies below them.
"""
