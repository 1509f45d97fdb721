"""Vibration of the plate: bases, modes, frequency responses with errors, and datasets of results."""
