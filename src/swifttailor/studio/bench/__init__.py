"""What the worker processes do: from plain values to plain values, by the pipeline of the command line."""
