"""What the page shows, built by pure functions: charts, tables and drawings."""
