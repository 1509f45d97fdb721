"""``python -m haptonic``."""

from haptonic.cli import main

main()
