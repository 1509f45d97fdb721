"""Settings that all tests share."""

from hypothesis import settings

# machines differ, and the first example of a physics test pays for what is cached afterwards
settings.register_profile("haptonic", deadline=None, print_blob=True)
settings.load_profile("haptonic")
