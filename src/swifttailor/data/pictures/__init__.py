"""Pictures of people in garments to read from: drawn anew each time, with what is true of them."""
