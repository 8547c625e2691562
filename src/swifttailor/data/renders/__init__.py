"""Pictures of garments to learn from: backdrops, cloths, cameras, and a split's pictures in files."""
