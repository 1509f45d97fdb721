"""The frequency response: velocity against frequency, point and direction. Simulation and scan meet here."""
