"""How an instruction wants a garment to be changed."""
