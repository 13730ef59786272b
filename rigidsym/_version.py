"""The version of this project, for all who have to name it."""

__version__ = "0.1.0"
