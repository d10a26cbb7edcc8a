"""The command line: ``main`` runs a command; the other modules hold what several commands share."""
