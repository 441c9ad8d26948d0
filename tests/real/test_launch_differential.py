"""Launch files are compared with the real roslaunch: a share of them; `make judge` takes them all."""

from __future__ import annotations

from collections.abc import Callable, Iterator

import pytest

from tests.helpers import launch_files
from tests.helpers.runs import asked_for
from tests.helpers.shares import SHARE, is_in

SHARES = 8


@pytest.fixture(scope="module")
def real(
    request: pytest.FixtureRequest, require: Callable[[str], None], tmp_path_factory: pytest.TempPathFactory
) -> Iterator[launch_files.Real]:
    require("ros1")
    names = [asked["name"] for asked in asked_for(request)]
    with launch_files.on_roslaunch(tmp_path_factory.mktemp("src"), names) as real:
        yield real


@pytest.mark.parametrize("name", [name for name in launch_files.FILES if is_in(name, SHARES, SHARE)])
def test_a_launch_file_runs_as_on_roslaunch(real: launch_files.Real, name: str) -> None:
    launch_files.check(real, name)
