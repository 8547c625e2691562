"""What is asked of the studio's server, and what it answers: the same types as studio-ui/src/api/types.ts."""
