"""The search of a design as an analysis runs it: rounds of tasks, their results, and reasons of a refusal."""
