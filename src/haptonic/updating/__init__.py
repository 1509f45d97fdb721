"""A plate's model against its measurement: how alike they are, and which numbers make them more alike."""
