"""What the networks read in a text, put right by its words."""
