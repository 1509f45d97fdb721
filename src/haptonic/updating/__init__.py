"""Comparison of a plate's model with its measurement, and a fit of its unknown numbers."""
