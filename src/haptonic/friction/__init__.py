"""Friction: from the plate's vibration to the friction under a finger, and trials that measure it.

``lubrication`` predicts friction, ``signals`` turns force records into a table of trials, ``statistics``
tests differences between conditions, ``simulation`` simulates trials with known ground truth to test the
others.
"""
