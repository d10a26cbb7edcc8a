"""The Stage, the player that every page uses: its layout and the routes that send it motion."""
