"""Making a pattern as a person would have drawn it: even sides and seams, no slivers, closed slits opened."""
