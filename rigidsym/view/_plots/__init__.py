"""Two-dimensional plots, drawn by matplotlib."""
