"""The NumPy target: one module that needs NumPy alone."""
