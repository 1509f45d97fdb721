"""Settings that all tests share."""

from hypothesis import settings

# Machines differ, and the first example of a physics test pays for what is cached afterwards, so no deadline.
# Every run of `make test` draws the same examples, so that its answer belongs to the commit;
# `make nightly` draws anew, and more.
settings.register_profile("same", deadline=None, print_blob=True, derandomize=True, max_examples=25)
settings.register_profile("anew", deadline=None, print_blob=True)
settings.load_profile("same")
