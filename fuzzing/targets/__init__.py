"""What is fuzzed: the sound files to begin with, how they are damaged, and what reads them."""
