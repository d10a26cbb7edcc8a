"""Operations on motion: foot contacts, leg IK, transitions."""
