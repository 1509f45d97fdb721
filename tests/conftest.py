"""Settings that all tests share."""

import gc
import os
from collections.abc import Iterator
from pathlib import Path

import pytest
from hypothesis import settings

from continued import pytest_addoption as pytest_addoption, pytest_configure as pytest_configure

# Machines differ, and the first example of a physics test pays for what is cached afterwards, so no deadline.
# Every run of `make test` draws the same examples, so that its answer belongs to the commit;
# `make nightly` draws anew, and more.
settings.register_profile("same", deadline=None, print_blob=True, derandomize=True, max_examples=10)
settings.register_profile("anew", deadline=None, print_blob=True)
settings.load_profile("same")


def pytest_collection_finish() -> None:
    """Leave the half a million objects of the collected tests to no later search for garbage: 0.5 s each."""
    gc.freeze()


@pytest.fixture(scope="session")
def store_folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """One store for all tests of a run, in all its processes: its keys hold all that a result depends on."""
    folder = tmp_path_factory.getbasetemp()
    return (folder.parent if "PYTEST_XDIST_WORKER" in os.environ else folder) / "store"


@pytest.fixture
def alone(store_folder: Path) -> Iterator[None]:
    """No other test with this fixture runs at the same time: each may need more than half of 24 GB."""
    fcntl = pytest.importorskip("fcntl")
    with store_folder.with_name("alone").open("w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)  # ends with the process, even if it is killed
        yield


@pytest.fixture(autouse=True, scope="session")
def _no_store_of_the_user(store_folder: Path) -> Iterator[None]:
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("HAPTONIC_STORE", str(store_folder))
        yield


@pytest.fixture(autouse=True, scope="module")
def _forget_what_tests_shared(request: pytest.FixtureRequest) -> Iterator[None]:
    """Drop what the functions of a module have cached once its tests are over: models take gigabytes."""
    yield
    for value in vars(request.module).values():
        own = getattr(value, "__module__", "") == request.module.__name__
        if own and callable(clear := getattr(value, "cache_clear", None)):
            clear()


@pytest.fixture(scope="module")
def browser() -> Iterator[object]:
    """A headless browser; see `browser.page_at`."""
    from browser import chromium  # needs a driver, which most tests do not

    with chromium() as running:
        yield running
