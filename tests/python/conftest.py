import logging
from pathlib import Path

import pytest

import mimo


def pytest_addoption(parser):
    parser.addoption("--guides", default="plain", help="which programs of the pages test_guides.py runs, see guides.py")


ROOT = Path(__file__).resolve().parents[2]


@pytest.fixture(scope="session")
def root():
    """The repository."""
    return ROOT


@pytest.fixture(autouse=True)
def _no_messages(caplog):
    """The library has nothing to warn of in these tests, unless they say so."""
    yield
    assert [r.message for r in caplog.get_records("call") if r.name == "mimo" and r.levelno >= logging.WARNING] == []


@pytest.fixture
def reach():
    with mimo.World("reach") as world:
        yield world
