"""Friction: from the plate's vibration to what the finger feels, and the trials that prove it.

``lubrication`` predicts, ``signals`` turns force records into a table of trials, ``statistics`` says what the
table proves, ``simulation`` makes trials up to test the others with.
"""
