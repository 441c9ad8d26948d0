"""Start the process of a worker: in an empty root of its own, made by bubblewrap, or with all rights of this process.

What bubblewrap was asked for is looked up from outside before anything is said to be sealed.
"""

from __future__ import annotations

import importlib.util
import itertools
import json
import os
import select
import shutil
import signal
import subprocess
import sys
import sysconfig
from collections.abc import Iterator, Mapping
from contextlib import suppress
from pathlib import Path
from typing import IO, Any

from ..cpp import building
from ..exercises.own import FOLDER
from ..results.folders import TemporaryFolder
from .filtered import is_known
from .worker import READY

__all__ = ["CannotSeal", "Process"]

# What else than Python a worker imports; the modules of rosspin need no more.
_PACKAGES = ("greenlet", "yaml")

# Where shared libraries may lie: those that Python was linked with.
_LIBRARIES = ("/lib", "/lib64", "/usr/lib", "/usr/lib64", "/nix/store", "/etc/ld.so.cache")

_DEVICES = ("/dev/null", "/dev/zero", "/dev/urandom")

_IN = "/rosspin"  # where the packages are in a sealed worker

_NAMESPACES = ("cgroup", "ipc", "mnt", "net", "pid", "uts")

# The folder of an answer (bytes).
_FOLDER = 16 << 20

_START = """
import json, os, sys
given, own = json.loads(sys.argv[1]), sys.path[:]
sys.path += given["path"]
if given["lessons"]:
    os.environ["ROSSPIN_LESSONS"] = given["lessons"]
from rosspin.grading.worker import work
work(given, own)
"""

# So long (s) a worker may take until it is ready.
_PATIENCE = 120

_number = itertools.count()


class CannotSeal(Exception):
    """Answers cannot be sealed on this machine; the message says why."""


class Process:
    """The process of a worker, which has said that it is ready.

    Jobs are written to ``jobs`` after their size, as a line, to ``control``; what the child says comes from
    ``results``, and how it ended from ``status``.
    """

    def __init__(self, seal: bool, seconds: int) -> None:
        """Start it; an answer has so many seconds. Raises :class:`CannotSeal`, or OSError if it is not to be sealed."""
        self._temporary = None if seal else TemporaryFolder()
        self._init: int | None = None  # of the first process of its namespace
        given: dict[str, Any] = {
            "sealed": seal,
            "time": seconds,
            "node": building.node_command()[0] if building.needed(Path(_IN)) else "",
        }
        if self._temporary:
            folder = self._temporary.path / "answer"
            folder.mkdir(0o700)
            given["folder"] = str(folder)
        jobs, self.jobs = os.pipe()
        self.results, results = os.pipe()
        info, about = os.pipe()
        given |= {"jobs": jobs, "results": results}
        try:
            command = _sealed(given, about) if seal else _unsealed(given)
            self._process = subprocess.Popen(
                command,
                bufsize=0,
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                stderr=subprocess.PIPE,
                pass_fds=(jobs, results, about) if seal else (jobs, results),
                env={},
                cwd="/",
                start_new_session=True,
            )
        except BaseException:
            for number in (self.jobs, self.results, info):
                os.close(number)
            self._sweep()
            raise
        finally:
            for number in (jobs, results, about):
                os.close(number)
        assert self._process.stdin and self._process.stdout and self._process.stderr
        self.control: IO[bytes] = self._process.stdin
        self.status: int = self._process.stdout.fileno()
        try:
            self._begin(seal, info)
        except BaseException:
            self.end()
            raise
        finally:
            os.close(info)
            self._process.stderr.close()

    def _begin(self, seal: bool, info: int) -> None:
        """Wait until it is ready, and look whether it is as it was asked for."""
        assert self._process.stderr
        said = os.read(self.status, 100) if select.select([self.status], [], [], _PATIENCE)[0] else b""
        if said != READY:
            self._process.kill()
            why = self._process.stderr.read().decode(errors="replace").strip().splitlines() or ["it ended at once"]
            raise CannotSeal(f"bubblewrap: {why[-1]}") if seal else OSError(why[-1])
        if seal:
            try:
                self._look(json.loads(os.read(info, 10_000)))
            except (OSError, ValueError, KeyError) as error:
                raise CannotSeal(f"bubblewrap does not say what it has made ({error})") from None

    def _look(self, made: Mapping[str, int]) -> None:
        first = made["child-pid"]
        self._init = os.pidfd_open(first)
        for name in _NAMESPACES if _has_all_users() else (*_NAMESPACES, "user"):
            if os.stat(f"/proc/{first}/ns/{name}").st_ino == os.stat(f"/proc/self/ns/{name}").st_ino:
                raise CannotSeal(f"bubblewrap has made no {name} namespace")

    def end(self) -> None:
        """End it, and all that it has started."""
        if self._init is not None:
            with suppress(ProcessLookupError):  # with the first process of a namespace, all in it end
                signal.pidfd_send_signal(self._init, signal.SIGKILL)
            os.close(self._init)
        with suppress(ProcessLookupError, PermissionError):
            os.killpg(self._process.pid, signal.SIGKILL)
        self._process.kill()
        self._process.wait()
        for file in (self._process.stdin, self._process.stdout):
            with suppress(OSError):
                file and file.close()
        for number in (self.jobs, self.results):
            os.close(number)
        self._sweep()

    def _sweep(self) -> None:
        if self._temporary:
            self._temporary.remove()


def _packages() -> Iterator[tuple[str, Path]]:
    for name in _PACKAGES:
        spec = importlib.util.find_spec(name)
        assert spec and spec.origin
        yield name, Path(spec.origin).parent.absolute()
    yield "rosspin", Path(__file__).parents[1].absolute()


def _python(given: Mapping[str, Any]) -> list[str]:
    # Without what an environment or a package may change in it, and without installed packages.
    return [*("-I", "-S", "-B", "-X", "utf8", "-c", _START), json.dumps(given)]


def _has_all_users() -> bool:
    """Whether this is root, and not one in a container who knows only a few users."""
    return os.geteuid() == 0 and int(Path("/proc/self/uid_map").read_text().split()[2]) > 3_100_000_000


def _unsealed(given: Mapping[str, Any]) -> list[str]:
    paths = [*dict.fromkeys(str(path.parent) for _, path in _packages())]
    lessons = str(FOLDER.absolute()) if FOLDER else ""
    return [sys.executable, *_python({**given, "path": paths, "lessons": lessons, "user": 0})]


def _sealed(given: Mapping[str, Any], about: int) -> list[str]:
    bubblewrap = shutil.which("bwrap")
    if sys.platform != "linux":
        raise CannotSeal("this needs bubblewrap, which is for Linux")
    if not is_known():
        raise CannotSeal(f"this Linux has processors of {os.uname().machine}, and only x86_64 and aarch64 are known")
    if not bubblewrap:
        raise CannotSeal("bubblewrap is not installed (on Debian and Ubuntu: sudo apt-get install bubblewrap)")
    if not os.path.exists("/proc/self/ns"):
        raise CannotSeal("there is no /proc here, which bubblewrap needs")
    python = os.path.realpath(getattr(sys, "_base_executable", sys.executable))
    installed = sysconfig.get_paths(vars={"installed_base": sys.base_prefix, "platbase": sys.base_exec_prefix})
    homes = {os.path.dirname(installed[name]) for name in ("stdlib", "platstdlib")}
    binds = {path: path for path in (*_LIBRARIES, *sorted(homes), python) if os.path.exists(path)}
    binds |= {str(path): f"{_IN}/{name}" for name, path in _packages()}
    binds |= building.needed(Path(_IN))
    lessons = f"{_IN}/lessons" if FOLDER else ""
    if FOLDER:
        binds[str(FOLDER.absolute())] = lessons
    parents = {str(folder) for place in (*binds.values(), *_DEVICES) for folder in Path(place).parents} - {"/"}
    # A Python may lie there, too.
    folder = "/answer" if any(place.startswith("/tmp/") for place in binds.values()) else "/tmp"
    root = {Path(place).parts[1] for place in parents | {*binds.values(), folder}}
    # Root has a user in it who owns nothing, others a namespace of users: each worker has its own.
    user = 2_000_000_000 + (os.getpid() << 8) % (1 << 30) + next(_number) % 256 if _has_all_users() else 0
    rights = ("--cap-add", "CAP_SETUID", "--cap-add", "CAP_SETGID", "--cap-add", "CAP_DAC_READ_SEARCH")
    given = {**given, "path": [_IN], "lessons": lessons, "user": user, "root": sorted(root), "folder": folder}
    return [
        bubblewrap,
        *(("--cap-drop", "ALL", *rights) if user else ("--unshare-user", "--uid", "65534", "--gid", "65534")),
        *("--unshare-ipc", "--unshare-pid", "--unshare-net", "--unshare-uts", "--unshare-cgroup"),
        *("--hostname", "rosspin", "--clearenv", "--new-session", "--die-with-parent", "--info-fd", str(about)),
        # Where Python's own library is: without /proc, the loader cannot go by the place of the program ($ORIGIN).
        *("--setenv", "LD_LIBRARY_PATH", ":".join(sorted(homes))),
        # Which whoever is in it may enter, whatever the real ones are like.
        *itertools.chain.from_iterable(("--perms", "0755", "--dir", folder) for folder in sorted(parents)),
        *itertools.chain.from_iterable(("--ro-bind", path, place) for path, place in binds.items()),
        *itertools.chain.from_iterable(("--dev-bind", path, path) for path in _DEVICES),
        *("--perms", "1777", "--size", str(_FOLDER), "--tmpfs", folder, "--remount-ro", "/", "--chdir", "/", "--"),
        *(python, *_python(given)),
    ]
