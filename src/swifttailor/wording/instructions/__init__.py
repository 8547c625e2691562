"""Instructions: words for what becomes true, grows or shrinks by an edit."""
