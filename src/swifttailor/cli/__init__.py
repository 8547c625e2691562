"""The command line: one module per command, each a frozen dataclass of its options with a `run` method.

May import every room.
"""
