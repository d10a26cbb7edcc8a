"""Search by example: motions like this one, by the whole body or the parts that matter (docs/methods/search.md)."""
