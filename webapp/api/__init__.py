"""Flask routes: binary motion for the Stage, small pictures of motions."""
