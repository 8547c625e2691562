"""What the networks learn from: drapes in shards, captions, edits, renders (paper, Sec. 5.1).

May import tailor's floor and everything below it.
"""
