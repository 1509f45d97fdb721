"""Texts of studies: a quick cell with a plate and a ribbon, and the plate and pillar of the prototype."""

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

FINER_CELL = QUICK_CELL.replace("order = 2", "order = 3").replace("foot_rings = 0", "foot_rings = 1")

QUICK_PLATE = """
[plate]
map = "o11o22o"
rows = 2
loss_factor = 5e-3
[plate.tiles]
o = "lattice"
1 = "A"
2 = "B"
[plate.clamp]
corners = "5 mm"
[[plate.actuator]]
name = "A1"
region = "A"
centre = ["7 mm", "3 mm"]
size = ["6 mm", "5 mm", "0.5 mm"]
material = "pzt-4"
voltage = "10 V"
[plate.response]
lowest = "2 kHz"
highest = "20 kHz"
points = 19
"""

QUICK_RIBBON = """
[ribbon]
map = "oo"
points = 3
lowest = "40 kHz"
highest = "60 kHz"
[ribbon.tiles]
o = "lattice"
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
