"""Sensitivities of states in balls, and states of all motions of a box by them."""
