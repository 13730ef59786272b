"""Special functions as straight-line code, with bounds of their truncation errors."""
