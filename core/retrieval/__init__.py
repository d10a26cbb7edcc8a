"""Search by example: motions like this one, over the whole body or the parts that matter (PCR; docs/search.md)."""
