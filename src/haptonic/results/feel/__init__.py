"""Friction under a finger on a vibrating plate."""

from haptonic.results.feel.value import Feel

__all__ = ["Feel"]
