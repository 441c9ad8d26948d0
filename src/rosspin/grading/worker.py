"""A worker of the pool: a process in which answers are run and judged, in an empty root of its own if it is sealed.

It has imported all that an answer needs, knows no hand-in, and runs nothing of one. For each job it forks a child,
which reads the job, gives up all that it does not need, sends a word that says so, and does the job. When that has
ended, the worker says how, and whether all is as it was before.
"""

from __future__ import annotations

import ctypes
import fcntl
import gc
import importlib
import json
import os
import pkgutil
import resource
import select
import signal
import socket
import stat
import struct
import sys
import threading
from collections.abc import Collection, Mapping, Sequence
from contextlib import nullcontext, suppress
from itertools import pairwise
from pathlib import Path
from typing import Any, NoReturn

from .. import exercises, programs, rclpy, rospy
from ..run.alone import refuse_processes
from .filtered import close_kernel, is_known
from .programs import Programs

__all__ = ["AS_BEFORE", "OPEN", "READY", "SEALED", "work"]

READY = b"ready\n"
"""What a worker says when it can work."""

AS_BEFORE = b"0 as before\n"
"""What a worker says of a child that ended well and left nothing behind."""

SEALED = b"sealed\n"
OPEN = b"not sealed\n"
"""The first word of a child: whether it is sealed."""

# At most (bytes, or their number): memory for all that a process is, a file, open files, files that it makes, threads.
_MEMORY = 5 << 28
_FILE = 10 << 20
_FILES = 64
_MADE = 1000
_THREADS = 256

# How often (s) a worker looks how many files there are.
_LOOK = 0.05

# How a child ends that has done its job, and has left a program that still computes.
_COMPUTES = 3

_PR_SET_PDEATHSIG = 1
_CAPABILITIES_3 = 0x20080522
_OWN = 3  # a child's end of the pipe to the judge
_CONTROL, _STATUS, _ERRORS = range(3)


def work(given: Mapping[str, Any], own_path: list[str]) -> NoReturn:
    """Be a worker. ``own_path`` is where Python has its own modules.

    Each line on standard input says how many bytes the next job has, and with a 1 that it is an answer in C++ to run;
    there is an answer to each on standard output.
    """
    for name in ("yaml", "xmlrpc.client"):  # which are else loaded when a node needs them
        importlib.import_module(name)
    for package in (rospy, rclpy, exercises, programs):
        for module in pkgutil.iter_modules(package.__path__, f"{package.__name__}."):
            with suppress(ModuleNotFoundError):  # what needs numpy is not there for answers
                importlib.import_module(module.name)
    os.environ.clear()
    sys.path[:] = own_path
    if given["user"]:
        os.setgroups([])
        os.setresgid(*[given["user"]] * 3)
        os.setresuid(*[given["user"]] * 3)
        ctypes.CDLL(None).capset(_header(), bytes(24))
    if sys.platform == "linux":
        ctypes.CDLL(None).prctl(_PR_SET_PDEATHSIG, signal.SIGKILL, 0, 0, 0)
    os.chdir(given["folder"])
    folder = os.open(".", os.O_RDONLY)
    before = _state(given["results"])
    os.write(_STATUS, READY)
    os.dup2(os.open(os.devnull, os.O_RDWR), _ERRORS)
    gc.collect()
    gc.freeze()
    cpp = Programs(given["node"])
    while asked := os.read(_CONTROL, 20):
        size, is_cpp = map(int, asked.split())
        if is_cpp:
            cpp.start()
        child = os.fork()
        if not child:
            _do(given, size, cpp if is_cpp else None)
        if given["sealed"]:
            _guard(child, folder)
        _, status = os.waitpid(child, 0)
        as_before = "as before" if _state(given["results"]) == before else "changed"
        ended = os.waitstatus_to_exitcode(status)
        if ended:
            cpp.end()
        if is_cpp and ended == _COMPUTES:
            ended = 0
        os.write(_STATUS, f"{ended} {as_before}\n".encode())
    os._exit(0)


def _guard(child: int, folder: int) -> None:
    """Wait until a child ends. If it makes more files than an answer needs, end it.

    The size of the folder says nothing of empty files, which the kernel keeps in its own memory.
    """
    ends = os.pidfd_open(child)
    while not select.select([ends], [], [], _LOOK)[0]:
        found = os.fstatvfs(folder)
        if found.f_files - found.f_ffree > _MADE:
            os.kill(child, signal.SIGKILL)
    os.close(ends)


def _state(results: int) -> object:
    """Return all that a child can change for the next one: its folder, and how its pipe to the judge is open."""
    try:
        found = os.stat(".")
        return os.listdir("."), stat.S_IMODE(found.st_mode), found.st_nlink, fcntl.fcntl(results, fcntl.F_GETFL)
    except OSError as error:
        return error.errno


# --- in a child -------------------------------------------------------------------------------------------------------


def _do(given: Mapping[str, Any], size: int, cpp: Programs | None) -> NoReturn:
    try:
        job = _read(given["jobs"], size)
        try:
            confine(given, cpp.files if cpp else ())
        except OSError as error:
            _send(f"{error}\n".encode())
            raise
        _send(SEALED if given["sealed"] else OPEN)
        with cpp.used() if cpp else nullcontext():
            _send(_done(json.loads(job)))
    except BaseException:
        os._exit(1)
    os._exit(_COMPUTES if cpp and cpp.computes else 0)


def _read(file: int, size: int) -> bytes:
    """Read a job; it is in the memory of this child only, and of none that comes after."""
    found = bytearray()
    while len(found) < size:
        if not (data := os.read(file, size - len(found))):
            raise EOFError
        found += data
    return bytes(found)


def _send(data: bytes) -> None:
    while data:
        data = data[os.write(_OWN, data) :]


def _done(job: Mapping[str, str]) -> bytes:
    """Run an answer and return the trace, or judge a trace and return the verdict; or do nothing, to try it."""
    if not job:
        return b""
    text = exercises.code(job["text"])
    if "trace" in job:
        return json.dumps(exercises.verdict(job["exercise"], text, job["trace"])).encode()
    refuse_processes()  # by their names
    try:
        return exercises.trace(job["exercise"], text).encode()
    except ValueError:
        return b""  # there is no such exercise, which its judge says


def confine(given: Mapping[str, Any], files: Sequence[int] = ()) -> None:
    """Give up all that an answer does not need, but for these files. Raises OSError where a seal does not hold."""
    if sys.platform == "linux":
        ctypes.CDLL(None).prctl(_PR_SET_PDEATHSIG, signal.SIGKILL, 0, 0, 0)
    nothing = os.open(os.devnull, os.O_RDWR)
    os.dup2(given["results"], _OWN)
    for number in range(_OWN):
        os.dup2(nothing, number)
    for one, other in pairwise([_OWN, *sorted(files), 1 << 20]):
        os.closerange(one + 1, other)
    limits = {
        resource.RLIMIT_CPU: given["time"] + 1,
        resource.RLIMIT_AS: _MEMORY,
        resource.RLIMIT_FSIZE: _FILE,
        resource.RLIMIT_NOFILE: _FILES,
        resource.RLIMIT_CORE: 0,
    }
    if given["sealed"]:
        limits[resource.RLIMIT_NPROC] = _THREADS  # of a user of its own, or within its own namespace
    for kind, most in limits.items():
        _, hard = resource.getrlimit(kind)
        with suppress(ValueError, OSError):  # macOS has no limit of memory
            resource.setrlimit(kind, (min(most, hard) if hard >= 0 else most,) * 2)
    if given["sealed"]:
        _check_limits(limits)
        _check_root(given["root"], given["folder"])
        _check_rights(given["user"])
    if given["sealed"] or is_known():
        close_kernel()
        _check_kernel()


class _Unsealed(OSError):
    """A seal does not hold."""


def _check_limits(limits: Mapping[int, int]) -> None:
    for kind, most in limits.items():
        if not 0 <= resource.getrlimit(kind)[1] <= most:
            raise _Unsealed("a limit")


def _check_root(names: Collection[str], folder: str) -> None:
    """There is nothing but what was asked for, and nothing of it can be written but the ``folder``."""
    if not set(os.listdir("/")) <= set(names) or not set(os.listdir("/dev")) <= {"null", "zero", "urandom"}:
        raise _Unsealed("what is there")
    for name in ("/", *(f"/{name}" for name in names if name not in (folder[1:], "dev"))):
        with suppress(FileNotFoundError):
            if not os.statvfs(name).f_flag & os.ST_RDONLY:
                raise _Unsealed("the disk")
    if set(os.environ) or Path("/proc").exists():
        raise _Unsealed("the environment")


def _check_rights(user: int) -> None:
    found = ctypes.create_string_buffer(24)
    if ctypes.CDLL(None).capget(_header(), found) or any(found.raw):
        raise _Unsealed("rights of root")
    if user and {*os.getresuid(), *os.getresgid(), *os.getgroups()} != {user}:
        raise _Unsealed("a user")


def _header() -> bytes:
    return struct.pack("Ii", _CAPABILITIES_3, 0)  # of this process


def _check_kernel() -> None:
    """Try what must not be possible, and what must be."""
    for name, way in (
        ("a process", os.fork),
        ("a socket", socket.socket),
        ("a signal", lambda: os.kill(0, 0)),
        ("a namespace", lambda: _called(ctypes.CDLL(None, use_errno=True).unshare(0x10000000))),
    ):
        try:
            if way() == 0 and name == "a process":
                os._exit(1)
        except OSError:
            continue
        raise _Unsealed(name)
    thread = threading.Thread(target=int)
    thread.start()
    thread.join()


def _called(result: int) -> None:
    if result:
        raise OSError(ctypes.get_errno(), "not called")
