"""Ways to damage a file. Each is a function of what it is given and a `random.Random`, and of nothing else."""
