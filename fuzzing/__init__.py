"""Mutated files for everything that SwiftTailor reads from strangers; see README.md."""
