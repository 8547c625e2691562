"""Asking the network: prompt, pictures, the loop that writes the answer, and how far to trust it."""
