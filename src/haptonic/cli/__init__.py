"""The commands of the program."""

from haptonic.cli.app import main

__all__ = ["main"]
