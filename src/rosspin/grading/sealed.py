"""Seal a process before a student's code runs in it: what it can reach, and how much it can take.

On Linux the process gets namespaces of its own: without network, with a disk that it can read and not write but for a
small folder in memory, and without sight of other processes' numbers. Where the system allows none of that, as in most
containers, root becomes a user who owns nothing, if it can then still read what is needed. Limits hold on any system.
"""

from __future__ import annotations

import ctypes
import os
import resource
import struct
import sys
import sysconfig
from contextlib import suppress
from typing import Any

__all__ = ["SEALS", "limit", "seal"]

SEALS = {
    "network": "no network",
    "disk": "a disk that cannot be written",
    "user": "a user who owns nothing",
}
"""What seals there are, in words; each process has those that the system allows."""

_CLONE_NEWNS = 0x00020000
_CLONE_NEWIPC = 0x08000000
_CLONE_NEWUSER = 0x10000000
_CLONE_NEWPID = 0x20000000
_CLONE_NEWNET = 0x40000000
_AT_FDCWD = -100
_AT_RECURSIVE = 0x8000
_SYS_MOUNT_SETATTR = 442  # on all processors
_MOUNT_ATTR_RDONLY = 1
_MS_NOSUID_NODEV = 2 | 4
_PR_SET_PDEATHSIG = 1
_PR_SET_NO_NEW_PRIVS = 38
_CAPABILITIES_3 = 0x20080522
_SIGKILL = 9
_NOBODY = 65534

# At most (bytes): memory beside what the process has already, as much as a sandbox of the page; a file; the folder.
_MEMORY = 1 << 30
_FILE = 10 << 20
_FOLDER = "size=16m,mode=700"


def seal(folder: str) -> set[str]:
    """Seal this process, which was forked for that and has one thread; ``folder`` is empty, and where it may write.

    Returns which of ``SEALS`` are in force. With new namespaces the caller goes on in a child of this process, which
    has the number 1 there: when that ends, so does all that it has started.
    """
    if sys.platform != "linux":
        return set()
    libc = ctypes.CDLL(None, use_errno=True)
    user, group = os.geteuid(), os.getegid()
    found = set()
    if libc.unshare(_CLONE_NEWUSER | _CLONE_NEWNET | _CLONE_NEWNS | _CLONE_NEWPID | _CLONE_NEWIPC) == 0:
        found.add("network")
        for name, text in (("setgroups", "deny"), ("uid_map", f"{user} {user} 1"), ("gid_map", f"{group} {group} 1")):
            with suppress(OSError), open(f"/proc/self/{name}", "w") as file:
                file.write(text)
        if _closes_disk(libc, folder):
            found.add("disk")
        _fork_once_more(libc)
        # Rights over these namespaces would undo all that.
        libc.capset(struct.pack("Ii", _CAPABILITIES_3, 0), bytes(24))
    elif user == 0 and _can_be_nobody():
        os.chown(folder, _NOBODY, _NOBODY)
        os.setgroups([])
        os.setgid(_NOBODY)
        os.setuid(_NOBODY)
        found.add("user")
    libc.prctl(_PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0)
    return found


def _closes_disk(libc: Any, folder: str) -> bool:
    """Make all that is mounted read-only, but for an empty folder in memory."""
    attributes = struct.pack("QQQQ", _MOUNT_ATTR_RDONLY, 0, 0, 0)
    read_only = libc.syscall(_SYS_MOUNT_SETATTR, _AT_FDCWD, b"/", _AT_RECURSIVE, attributes, len(attributes))
    if read_only != 0:
        return False
    libc.mount(b"tmpfs", os.fsencode(folder), b"tmpfs", _MS_NOSUID_NODEV, _FOLDER.encode())
    return True


def _fork_once_more(libc: Any) -> None:
    """Go on as the first process of the new namespace; the one before only waits for it, and takes its status."""
    if child := os.fork():
        _, status = os.waitpid(child, 0)
        os._exit(1 if os.waitstatus_to_exitcode(status) else 0)
    libc.prctl(_PR_SET_PDEATHSIG, _SIGKILL, 0, 0, 0)


def _can_be_nobody() -> bool:
    """Whether somebody who owns nothing can read Python and this package: nothing on the way is closed to others."""
    for path in (sysconfig.get_paths()["stdlib"], os.path.dirname(__file__)):
        while path != os.path.dirname(path):
            if not os.stat(path).st_mode & 0o001:
                return False
            path = os.path.dirname(path)
    return True


def limit(seconds: int) -> None:
    """Limit what this process takes: processor time (s), memory, files, and no dump of its memory when it dies."""
    for kind, most in (
        (resource.RLIMIT_CPU, seconds),
        (resource.RLIMIT_AS, _taken() + _MEMORY),
        (resource.RLIMIT_FSIZE, _FILE),
        (resource.RLIMIT_NOFILE, 64),
        (resource.RLIMIT_CORE, 0),
    ):
        _, hard = resource.getrlimit(kind)
        with suppress(ValueError, OSError):  # macOS has no limit of memory
            resource.setrlimit(kind, (min(most, hard) if hard >= 0 else most,) * 2)


def _taken() -> int:
    """Return how much address space (bytes) this process takes up; 0 where the system does not say.

    A process that has had many threads takes up most of a gigabyte: beside that, none could begin under the limit.
    """
    try:
        with open("/proc/self/statm") as file:
            return int(file.read().split()[0]) * resource.getpagesize()
    except OSError:
        return 0
