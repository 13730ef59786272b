"""Special functions as lets: each module builds straight-line code and bounds its error."""
