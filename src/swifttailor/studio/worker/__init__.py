"""Processes that do the work of the server: asked one thing at a time, killed where they overrun."""
