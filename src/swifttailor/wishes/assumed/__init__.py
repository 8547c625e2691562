"""What goes without saying: what is assumed of a garment where nobody speaks of it."""
