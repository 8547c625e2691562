"""How well pictures are read: statements, panels and masks, by look and view."""
