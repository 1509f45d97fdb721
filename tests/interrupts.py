"""Ctrl-C in tests: a runner that was started in the background makes its children deaf to it."""

import signal


def hear_interrupts() -> None:
    """Give a child process the usual answer to an interrupt; for ``preexec_fn``."""
    signal.signal(signal.SIGINT, signal.SIG_DFL)
