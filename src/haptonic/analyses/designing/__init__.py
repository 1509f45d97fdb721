"""The search of a design, as an analysis runs it: rounds of tasks, what they find, and why they may not."""
