"""Long runs of tests in several sittings: what passed before is left out."""

from pathlib import Path

import pytest

OPTION = "--continued"


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption(
        OPTION, type=Path, metavar="FILE", help="leave out the tests that FILE lists, and add those that pass"
    )


def pytest_configure(config: pytest.Config) -> None:
    if (path := config.getoption(OPTION)) is not None:
        config.pluginmanager.register(Continued(path, writes=not hasattr(config, "workerinput")))


class Continued:
    """Tests that passed, one a line of a file; a run after all have passed begins anew.

    writes : False in a worker process, whose results the main process receives
    """

    def __init__(self, path: Path, *, writes: bool) -> None:
        self.path, self.writes = path, writes

    def pytest_collection_modifyitems(self, config: pytest.Config, items: list[pytest.Item]) -> None:
        passed = set(self.path.read_text("utf-8").splitlines()) if self.path.exists() else set()
        left = [item for item in items if item.nodeid not in passed]
        if not left:
            self.path.unlink(missing_ok=True)
            return
        config.hook.pytest_deselected(items=[item for item in items if item.nodeid in passed])
        items[:] = left

    def pytest_runtest_logreport(self, report: pytest.TestReport) -> None:
        if self.writes and report.when == "call" and report.passed:
            with self.path.open("a", encoding="utf-8") as file:
                file.write(f"{report.nodeid}\n")
