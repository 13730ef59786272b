"""NumPy target: one Python module that needs only NumPy."""
