"""What a text wants sewn on: pockets, buttons, belts, and where."""
