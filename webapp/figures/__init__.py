"""Pure builders: results in, what the components show out. Nothing here knows about callbacks or disks."""
