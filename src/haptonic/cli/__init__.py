"""The commands."""

from haptonic.cli.app import main

__all__ = ["main"]
