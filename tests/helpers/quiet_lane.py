"""pytest's side of the third verdict: tests that the machine disturbed run once more, alone, after all others.

Once, one after another, in a fresh process, when the workers have ended. What comes of it is told beside the reason of
the first time, and counts: a test may pass there, fail, or be inconclusive again. That does not fail the session,
unless it is asked for with ``--conclusive``. What failed is never run again.
"""

from __future__ import annotations

import argparse
import json
import subprocess
import sys
import tempfile
from collections.abc import Generator
from pathlib import Path

import pytest
from verdicts import Inconclusive

TOLD = {how: f"INCONCLUSIVE, THEN {how.upper()} IN THE QUIET LANE" for how in ("passed", "failed")}


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption("--conclusive", action="store_true", help="a test that stays inconclusive fails the session")
    parser.addoption("--quiet-lane", metavar="FILE", type=Path, help=argparse.SUPPRESS)  # for its own process


def pytest_configure(config: pytest.Config) -> None:
    if file := config.getoption("--quiet-lane"):
        config.pluginmanager.register(_Alone(config, file))
    elif not hasattr(config, "workerinput"):  # which xdist's workers have
        config.pluginmanager.register(_QuietLane(config))


@pytest.hookimpl(wrapper=True)
def pytest_runtest_makereport(call: pytest.CallInfo[None]) -> Generator[None, pytest.TestReport, pytest.TestReport]:
    report = yield
    if call.excinfo and isinstance(call.excinfo.value, Inconclusive):
        report.outcome = "inconclusive"  # type: ignore[assignment]  # an outcome that pytest does not know by itself
        report.longrepr = str(call.excinfo.value)
    return report


@pytest.hookimpl(tryfirst=True)
def pytest_report_teststatus(report: pytest.TestReport) -> tuple[str, str, tuple[str, dict[str, bool]]] | None:
    if _is_inconclusive(report):
        return "inconclusive", "?", ("INCONCLUSIVE", {"yellow": True})
    if report.when == "call" and report.passed and "inconclusive" in dict(report.user_properties):
        return "passed in the quiet lane", ".", (TOLD["passed"], {"yellow": True})
    return None


def _is_inconclusive(report: pytest.TestReport) -> bool:
    return str(report.outcome) == "inconclusive"


class _Alone:
    """In the process of the quiet lane: keeps all reports, one a line."""

    def __init__(self, config: pytest.Config, file: Path) -> None:
        self._config = config
        self._file = file

    def pytest_runtest_logreport(self, report: pytest.TestReport) -> None:
        data = self._config.hook.pytest_report_to_serializable(config=self._config, report=report)
        with self._file.open("a", encoding="utf-8") as file:
            file.write(json.dumps(data) + "\n")


class _QuietLane:
    """In the session that was asked for."""

    def __init__(self, config: pytest.Config) -> None:
        self._config = config
        self._reasons: dict[str, str] = {}  # by test; after the quiet lane, of those that are inconclusive there too
        self._told: list[str] = []

    def pytest_runtest_logreport(self, report: pytest.TestReport) -> None:
        if _is_inconclusive(report):
            self._reasons[report.nodeid] = str(report.longrepr)

    @pytest.hookimpl(wrapper=True)
    def pytest_runtestloop(self, session: pytest.Session) -> Generator[None, object, object]:
        result = yield
        if self._reasons:
            if xdist := self._config.pluginmanager.getplugin("dsession"):
                xdist.nodemanager.teardown_nodes()
            self._run_again()
            if self._config.getoption("--conclusive"):
                session.testsfailed += len(self._reasons)
        return result

    def _run_again(self) -> None:
        first, self._reasons = self._reasons, {}
        terminal = self._config.pluginmanager.getplugin("terminalreporter")
        assert terminal
        del terminal.stats["inconclusive"]
        terminal.write_sep("-", f"quiet lane: once more, alone: {len(first)} inconclusive")
        for report in self._alone(list(first)):
            report.user_properties.append(("inconclusive", first[report.nodeid]))
            if report.failed:
                report.sections.append(("quiet lane", f"The first time it was inconclusive: {first[report.nodeid]}"))
            self._config.hook.pytest_runtest_logreport(report=report)
            if report.when == "call" and report.outcome in TOLD or report.failed:
                self._told.append(f"{TOLD[report.outcome]} {report.nodeid} - {first[report.nodeid]}")
        self._told += [f"INCONCLUSIVE {test} - {reason}" for test, reason in self._reasons.items()]

    def _alone(self, tests: list[str]) -> list[pytest.TestReport]:
        """What a process of its own reports of these tests."""
        options = ["--numprocesses=0"] if self._config.pluginmanager.hasplugin("xdist") else []
        if self._config.inipath:
            options.append(f"--config-file={self._config.inipath}")
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder, "reports")
            done = subprocess.run(
                # -P: the folder it is started in is not on the path, as for the command pytest.
                [sys.executable, "-P", "-m", "pytest", "-p", "no:cacheprovider", f"--quiet-lane={file}"]
                + [f"--rootdir={self._config.rootpath}", *options, *tests],
                cwd=self._config.rootpath,
                stdin=subprocess.DEVNULL,
                stdout=subprocess.PIPE,
                stderr=subprocess.STDOUT,
                text=True,
            )
            lines = file.read_text(encoding="utf-8").splitlines() if file.exists() else []
        load = self._config.hook.pytest_report_from_serializable
        reports: list[pytest.TestReport] = [load(config=self._config, data=json.loads(line)) for line in lines]
        if set(tests) != {report.nodeid for report in reports if report.when == "teardown"}:
            pytest.exit(f"the quiet lane broke off with status {done.returncode}:\n{done.stdout}", returncode=3)
        return reports

    def pytest_terminal_summary(self, terminalreporter: pytest.TerminalReporter) -> None:
        if self._told:
            terminalreporter.section("inconclusive", yellow=True)
            for line in self._told:
                terminalreporter.line(line)
