"""Plots in two dimensions, by matplotlib."""
