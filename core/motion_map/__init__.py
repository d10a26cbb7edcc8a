"""Motion maps: postures on a self-organising map (Sakamoto, Kuriyama, Kaneko 2004)."""
