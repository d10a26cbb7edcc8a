"""Library: datasets, clips, the import report, uploads."""
