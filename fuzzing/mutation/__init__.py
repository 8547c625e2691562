"""Ways to damage a file. Each depends on what it is given and a `random.Random`, and on nothing else."""
