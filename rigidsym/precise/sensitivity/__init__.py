"""How states move with what they depend on, in balls; and states of all motions of a box by it."""
