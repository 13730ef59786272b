"""Pages, cards, texts for terminals, and pictures of what the package computes."""
