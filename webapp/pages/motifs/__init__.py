"""Motifs: parameters, the motif graph, the motif table, metrics."""
