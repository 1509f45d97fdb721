"""A plate so small that its scan is computed in seconds: two guides, and two rows of cells between them."""

from quick import QUICK_CELL

TINY = (
    QUICK_CELL
    + """
[plate]
map = "o11oo22o"
rows = 3
loss_factor = 5e-3

[plate.tiles]
o = "lattice"
1 = "WG1"
2 = "WG2"

[plate.clamp]
corners = "5 mm"

[[plate.actuator]]
name = "A1"
region = "WG1"
centre = ["7 mm", "9 mm"]
size = ["9 mm", "7 mm", "0.7 mm"]
material = "pzt-4"
voltage = "60 V"

[scan]
lowest = "30 kHz"
highest = "80 kHz"
rate = "200 kHz"
record = "3 ms"
averages = 2
delay = "3 us"
bandwidth = "150 kHz"
"""
)
