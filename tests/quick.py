"""The start of a study that computes in about a second: few bands, a coarse mesh chosen by hand."""

QUICK_CELL = """
title = "Quick"
carrier = "60 kHz"
material = "aluminium-paper"

[cell]
pitch = "7 mm"
thickness = "1.5 mm"

[cell.pillar]
diameter = "3.5 mm"
height = "14.7 mm"

[bands]
count = 8
points = 13
accuracy = 2e-2

[mesh]
order = 2
foot_rings = 0
"""
