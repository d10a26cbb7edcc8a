"""Ids of the page, and what its stores hold."""
