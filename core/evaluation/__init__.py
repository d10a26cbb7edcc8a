"""Results against labels."""
