"""One folder a target, with all that is its own: emitter, runtime, and how it is read back."""
