"""Motion-motif graphs (Beaudoin, Coros, van de Panne, Poulin 2008)."""
