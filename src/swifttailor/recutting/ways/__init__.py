"""Ways to cut: longer, shorter, wider, with parts added or removed, all seams still fitting."""
