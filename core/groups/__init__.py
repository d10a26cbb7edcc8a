"""Groups of clips compared: what one does more often, longer, faster or in another posture than the other.

Every test permutes subjects, never clips or frames; see docs/groups.md.
"""
