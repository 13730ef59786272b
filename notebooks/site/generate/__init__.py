"""What the pages of the site say that is not written by hand: each module makes one part."""
