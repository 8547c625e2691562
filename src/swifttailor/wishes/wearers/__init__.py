"""Who is to wear a garment, as a text says it: sizes, heights, girths and ages."""
