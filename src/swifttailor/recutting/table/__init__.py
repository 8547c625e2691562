"""The cutting table: a pattern taken apart, what is known of it, and whether a recut one can be kept."""
