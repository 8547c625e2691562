"""The garments, one module each: an options dataclass and a draft function."""
