"""What a description of a garment asks for, by words and network together."""
