"""Search by words: what is seen in the motion, and what people wrote about it (docs/methods/search_words.md)."""
