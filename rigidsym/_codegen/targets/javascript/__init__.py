"""JavaScript as a target: an ES module without dependencies, with type declarations."""
