"""What pytest does differently here: a file of which every test was skipped ends with 77, by which ctest knows it."""
import pytest


def pytest_configure(config):
    config.addinivalue_line("markers", "long: takes minutes; scripts/test --all runs it")
    config.addinivalue_line("filterwarnings", "ignore::UserWarning")  # Small pictures have no room for a legend.


def pytest_sessionfinish(session, exitstatus):
    counted = session.config.pluginmanager.get_plugin("terminalreporter").stats
    nothing = exitstatus in (pytest.ExitCode.OK, pytest.ExitCode.NO_TESTS_COLLECTED) and not counted.get("passed")
    if nothing and counted.get("skipped"):
        session.exitstatus = 77
