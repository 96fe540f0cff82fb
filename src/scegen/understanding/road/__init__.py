"""The road: shape, control and surroundings, and whether the text is about traffic at all."""
