"""Texts that ask for two garments, and those that speak of others than the one asked for."""
