"""Sensitivities of states as balls, and enclosures of all motions of a box by them."""
