"""What a text says, word by word: its numbers, its clauses, slips of the fingers, what nothing came of."""
