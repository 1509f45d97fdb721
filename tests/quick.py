"""The start of a study: one that computes in about a second, and the plate and pillar of the prototype."""

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

PROTOTYPE_PLATE = """
[material]
youngs_modulus = "70 GPa"
poisson_ratio = 0.33
density = "2700 kg/m^3"
loss_factor = 1e-3
[cell]
pitch = "7 mm"
thickness = "1.5 mm"
"""
PROTOTYPE_PILLAR = '[cell.pillar]\ndiameter = "3.5 mm"\nheight = "14.7 mm"\n'
PROTOTYPE = 'carrier = "60 kHz"' + PROTOTYPE_PLATE + PROTOTYPE_PILLAR
