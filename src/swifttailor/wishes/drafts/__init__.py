"""The drafts that a text begins from, changed to what else it asks for."""
