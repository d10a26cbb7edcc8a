"""What a recording is, and how it gets in."""
