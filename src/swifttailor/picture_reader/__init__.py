"""What a picture shows of a garment: statements and measures, with certainty.

May import describing, body, render, networks and what lies below them.
"""
