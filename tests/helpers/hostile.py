"""What an answer may try against the computer that judges it. Each prints a line that begins with IN if it gets in.

FOLDER is a folder of the teacher's, with a socket of a server that obeys whoever connects, and a file ``secret``.
"""

from __future__ import annotations

import socket
import threading
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

_BEGIN = """import ctypes, glob, os, sys
libc = ctypes.CDLL(None, use_errno=True)
def tried(name, way):
    try:
        found = way()
        if found is not False:
            print("IN", name, str(found)[:200])
    except BaseException as error:
        print("not", name, error)
def called(number, *args):
    found = libc.syscall(number, *args)
    if found < 0:
        raise OSError(ctypes.get_errno(), "no such call")
    return found
"""

_ATTACKS = {
    "a socket on the disk": """
import socket
def obeyed():
    with socket.socket(socket.AF_UNIX) as s:
        s.connect("FOLDER/bus.sock")
        return s.recv(100)
tried("socket", obeyed)
tried("socket by number", lambda: called({"x86_64": 41, "aarch64": 198}[os.uname().machine], 1, 1, 0))
""",
    "an abstract socket": """
import socket
def obeyed():
    with socket.socket(socket.AF_UNIX) as s:
        s.connect("\\0rosspin-FOLDER")
        return s.recv(100)
tried("abstract socket", obeyed)
""",
    "the network": """
import socket
for family, address in ((socket.AF_INET, ("127.0.0.1", 9)), (socket.AF_INET6, ("::1", 9))):
    tried("network", lambda: socket.socket(family))
for family in (16, 17, 38, 40):  # netlink, packet, algorithms, virtual machines
    tried("family", lambda: socket.socket(family, socket.SOCK_RAW))
""",
    "the terminal": """
import fcntl
for name in [*glob.glob("/dev/pts/*"), "/dev/tty", "/dev/console", "/dev/ptmx", *glob.glob("/proc/*/fd/*")]:
    tried(name, lambda: os.write(os.open(name, os.O_WRONLY | os.O_NOCTTY), b"30 of 30 solved"))
for number in range(64):
    tried(f"TIOCSTI {number}", lambda: fcntl.ioctl(number, 0x5412, b"x"))
    tried(f"TIOCLINUX {number}", lambda: fcntl.ioctl(number, 0x541C, b"\\2"))
    tried(f"terminal {number}", lambda: os.isatty(number))
""",
    "devices": """
for name in sorted(os.listdir("/dev")):
    path = "/dev/" + name
    if name not in ("null", "zero", "urandom") and not os.path.isdir(path):
        tried(path, lambda: os.close(os.open(path, os.O_RDWR | os.O_NONBLOCK | os.O_NOCTTY)))
tried("mknod", lambda: os.mknod("disk", 0o60666, os.makedev(7, 0)))
""",
    "other processes": """
for pid in ("self", "1", str(os.getppid()), str(os.getpid())):
    for name in ("environ", "mem", "cmdline", "root", "maps"):
        tried(f"{pid} {name}", lambda: os.open(f"/proc/{pid}/{name}", os.O_RDONLY))
tried("list", lambda: os.listdir("/proc") and "processes")
tried("ptrace", lambda: libc.ptrace(16, os.getppid(), 0, 0) and False)
""",
    "the environment": """
tried("os", lambda: dict(os.environ) or False)
environ = ctypes.POINTER(ctypes.c_char_p).in_dll(libc, "environ")
tried("libc", lambda: bool(environ) and environ[0] or False)
tried("proc", lambda: open("/proc/self/environ", "rb").read())
tried("memory", lambda: any("TOP" + "SECRET" in str(each) for each in __import__("gc").get_objects()) or False)
""",
    "the teacher's files": """
tried("secret", lambda: open("FOLDER/secret").read())
for folder in ("FOLDER", "/var/tmp", "/dev/shm", "/run", "/home", "/root", "/etc", "/", "/usr/lib", sys.prefix):
    tried(folder, lambda: open(folder + "/rosspin-was-here", "w").close())
    tried(folder, lambda: os.chmod(folder, 0o777))
for path in ("/etc/passwd", "/etc/shadow", "/etc/hostname"):
    tried(path, lambda: open(path).read())
import rosspin
tried("rosspin", lambda: open(os.path.dirname(rosspin.__file__) + "/rosspin-was-here", "w").close())
tried("other answers", lambda: [name for name in glob.glob("/tmp/*") if "rosspin" in name] or False)
tried("host name", lambda: "HOST" == os.uname().nodename and "HOST")
""",
    "processes": """
x86 = os.uname().machine == "x86_64"
tried("fork", lambda: libc.fork() >= 0)
tried("clone", lambda: called(56 if x86 else 220, 17, 0, 0, 0, 0))
tried("clone3", lambda: called(435, (ctypes.c_ulong * 11)(0, 0, 0, 0, 17), 88))
if x86:
    tried("fork by number", lambda: called(57))
tried("pty", lambda: __import__("pty").fork())
tried("exec", lambda: os.execv("/bin/true", ["true"]))
""",
    "threads": """
attributes, thread = ctypes.create_string_buffer(64), ctypes.c_ulong()
libc.pthread_attr_init(attributes)
libc.pthread_attr_setstacksize(attributes, ctypes.c_size_t(1 << 15))
begin = lambda: libc.pthread_create(ctypes.byref(thread), attributes, libc.sleep, ctypes.c_void_p(60))
count = next((number for number in range(10_000) if begin()), 10_000)
print("IN threads" if count > 1000 or count < 50 else "not threads", count)
""",
    "memory": """
import mmap
taken, size = [], 1 << 20
def all_of_it(way):
    try:
        while len(taken) < 5000:
            taken.append(way())
    except (OSError, MemoryError):
        pass
all_of_it(lambda: mmap.mmap(-1, size))
all_of_it(lambda: bytearray(size))
all_of_it(lambda: open(str(len(taken)), "wb").write(bytes(size)))
all_of_it(lambda: os.memfd_create("x"))
print("IN memory" if len(taken) > 1400 else "not memory", len(taken))
""",
    "signals": """
import signal
x86 = os.uname().machine == "x86_64"
for pid in (-1, 0, 1, 2, os.getppid(), -os.getpgrp()):
    tried(f"kill {pid}", lambda: os.kill(pid, 0))
    tried(f"queue {pid}", lambda: called(129 if x86 else 138, pid, 0, None))
    tried(f"thread {pid}", lambda: called(200 if x86 else 130, pid, 0))
    tried(f"pidfd {pid}", lambda: os.pidfd_open(pid))
    tried(f"priority {pid}", lambda: os.setpriority(os.PRIO_PROCESS, pid, 19))
tried("session", os.setsid)
tried("death signal", lambda: libc.prctl(1, 0, 0, 0, 0) and False)
r, w = os.pipe()
tried("owner", lambda: __import__("fcntl").fcntl(r, 8, os.getppid()))
""",
    "the kernel": """
x86 = os.uname().machine == "x86_64"
for name, one, other in (
    ("unshare", 272, 97), ("setns", 308, 268), ("mount", 165, 40), ("keyctl", 250, 219), ("add_key", 248, 217),
    ("bpf", 321, 280), ("userfaultfd", 323, 282), ("perf_event_open", 298, 241), ("io_uring_setup", 425, 425),
    ("memfd_create", 319, 279), ("shmget", 29, 194), ("semget", 64, 190), ("msgget", 68, 186), ("mq_open", 240, 180),
    ("process_vm_readv", 310, 270), ("pivot_root", 155, 41), ("chroot", 161, 51), ("init_module", 175, 105),
    ("personality", 135, 92), ("seccomp", 317, 277), ("open_by_handle_at", 304, 265), ("fanotify_init", 300, 262),
    ("quotactl", 179, 60), ("fsopen", 430, 430), ("landlock", 444, 444), ("sethostname", 170, 161), ("kcmp", 312, 272),
):
    for arguments in ((0x10000000, 0, 0, 0, 0), (0, 0, 0, 0, 0), (b"x", 1, 0, 0, 0), (1, 1 << 20, 0o1600, 0, 0)):
        def way():
            found = libc.syscall(one if x86 else other, *arguments)
            return found if found >= 0 or ctypes.get_errno() != 38 else False  # ENOSYS
        tried(name, way)
""",
}

ATTACKS = {name: _BEGIN + text for name, text in _ATTACKS.items()}


def written(name: str, folder: Path) -> str:
    """An attack, for a folder of the teacher's."""
    return ATTACKS[name].replace("FOLDER", str(folder)).replace("HOST", socket.gethostname())


def got_in(console: str) -> list[str]:
    """What an attack could do."""
    return [line for line in console.splitlines() if line.startswith("IN ")]


@contextmanager
def teachers_services(folder: Path) -> Iterator[list[str]]:
    """What listens on the teacher's computer, on the disk and without a place there; who was obeyed is told."""
    (folder / "secret").write_text("TOPSECRET")
    obeyed: list[str] = []
    servers = [socket.socket(socket.AF_UNIX) for _ in range(2)]
    for server, address in zip(servers, (str(folder / "bus.sock"), f"\0rosspin-{folder}"), strict=True):
        server.bind(address)
        server.listen()

        def serve(server: socket.socket = server, address: str = address) -> None:
            with suppress(OSError):
                while True:
                    connection, _ = server.accept()
                    obeyed.append(address)
                    connection.sendall(b"done")
                    connection.close()

        threading.Thread(target=serve, daemon=True).start()
    try:
        yield obeyed
    finally:
        for server in servers:
            server.shutdown(socket.SHUT_RDWR)
            server.close()
