"""What answers try against the computer that judges them: as root and as another user, with bubblewrap and without."""

from __future__ import annotations

import csv
import json
import os
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

import pytest

from rosspin.exercises import Verdict
from rosspin.grading import pool, sealed, worker
from rosspin.grading.filtered import _ALLOWED
from rosspin.grading.pool import Pool, Task
from tests.helpers.answers import CELLS, IN_CPP
from tests.helpers.command_line import NEVER
from tests.helpers.hostile import ATTACKS, got_in, teachers_services, written

pytestmark = pytest.mark.shares(5)

SOLVED = CELLS["slow-timer"][1].source

_SECRET = {"SECRET": "TOPSECRET"}

# As patient as this process is with a busy machine.
_PATIENT = "import sys, rosspin.grading.pool as p, rosspin.__main__ as m; p.TIME = 300; sys.exit(m.main())"


@pytest.fixture
def folder() -> Iterator[Path]:
    """A folder that all users can enter, as pytest's own cannot be."""
    made = Path(tempfile.mkdtemp(prefix="a töst "))
    made.chmod(0o777)
    yield made
    shutil.rmtree(made)


def handed_in(folder: Path, name: str, exercise: str, text: str) -> None:
    (folder / name).mkdir(parents=True, exist_ok=True)
    (folder / name / f"{exercise}.py").write_text(text)


def _for_others(user: str, *command: str) -> Sequence[str]:
    """A command for this user, or for root: which may enter the folders that Python and this copy are in."""
    if user == "root":
        return command
    opened: list[str] = []
    for place in (Path(sys.base_prefix), Path(sys.prefix), Path(worker.__file__).parents[2]):
        above = [*place.parents][-2::-1]
        if closed := [folder for folder in above if not folder.stat().st_mode & 0o001]:
            opened += ["--perms", "0755", "--tmpfs", str(closed[0])]
            for folder in above[above.index(closed[0]) + 1 :]:
                opened += ["--perms", "0755", "--dir", str(folder)]
            opened += ["--ro-bind", str(place), str(place)]
    rights = ["--cap-add", "CAP_SETUID", "--cap-add", "CAP_SETGID"]
    to = ["setpriv", "--reuid=64321", "--regid=64321", "--clear-groups"]
    return ["bwrap", "--dev-bind", "/", "/", *opened, *rights, "--", *to, *command]


def judge(
    folder: Path,
    *args: str,
    user: str = "root",
    within: Sequence[str] = (),
    inside: Sequence[str] = (),
    **environment: str,
) -> tuple[int, dict[str, Any], str]:
    """Status, what was found, and what was said by ``rosspin judge`` of the hand-ins in a folder."""
    command = [sys.executable, "-c", _PATIENT, "judge", str(folder), "--json", *args]
    words = [*within, *_for_others(user, *inside, *command)]
    env = os.environ | _SECRET | environment
    done = subprocess.run(words, capture_output=True, text=True, timeout=NEVER, env=env)
    print(done.stderr)
    return done.returncode, json.loads(done.stdout) if done.stdout else {}, done.stderr


def said(found: Mapping[str, Any]) -> dict[str, dict[str, Any]]:
    """By student what was said of the only answer."""
    return {student["name"]: next(iter(student["answers"].values())) for student in found["students"]}


@pytest.fixture(params=["root", "somebody"])
def user(request: pytest.FixtureRequest, require: Callable[[str], None]) -> str:
    require("bwrap")
    if os.geteuid() and request.param == "root":
        pytest.skip("this is not root")
    return "root" if os.geteuid() else str(request.param)  # who is not root is another user already


# --- with bubblewrap --------------------------------------------------------------------------------------------------


def test_no_attack_gets_in(user: str, folder: Path) -> None:
    """Nor does one of them change what is said of another answer."""
    class_ = folder / "class"
    for name in ATTACKS:
        handed_in(class_, name, "ten-hertz", written(name, folder))
    handed_in(class_, "right", "slow-timer", SOLVED)
    with teachers_services(folder) as obeyed:
        (folder / "bus.sock").chmod(0o666)
        status, found, err = judge(class_, user=user)
    assert (status, err, found["sealed"]) == (1, "", True)
    answers = said(found)
    assert answers.pop("right")["solved"]
    assert {name: got_in(answer["said"]) for name, answer in answers.items()} == dict.fromkeys(ATTACKS, [])
    assert {answer["verdict"] for answer in answers.values()} == {"not yet"}
    assert not obeyed and "TOPSECRET" not in json.dumps(found)
    assert sorted(os.listdir(folder)) == ["bus.sock", "class", "secret"]


# What a node in C++ does at its start, and lines above it.
IN_A_PROGRAM = {
    "what there is": 'for (const char* name : {"/etc/passwd", "FOLDER/secret", "/build/cpp", "/dev/null", "."})\n'
    '  if (std::fopen(name, "r")) std::printf("IN %s\\n", name);\n'
    'if (std::filesystem::exists("/") || std::filesystem::exists(".")) std::puts("IN folders");\n'
    'if (std::ofstream("x") << "x" << std::flush) std::puts("IN writes");\n'
    'if (std::getenv("SECRET") || std::getenv("HOME") || std::getenv("PATH")) std::puts("IN environment");\n'
    'if (std::getchar() != EOF) std::puts("IN standard input");\n'
    'std::printf("{\\"status\\":0,\\"log\\":[],\\"now\\":\\"0\\"}\\n");  // as its host says it',
    "the stack": "std::function<int(int)> f = [&](int n) { return f(n + 1) + 1; }; std::exit(f(0));",
    "memory": "for (;;) std::memset(std::malloc(1 << 20), 1, 1 << 20);",
    "a loop": "for (;;) {}",
    "no end at Ctrl-C": "signal(SIGINT, SIG_IGN); for (;;) rclcpp::sleep_for(std::chrono::seconds(1));",
}
ABOVE = {
    "include": '#include "/etc/passwd"\n#include "FOLDER/secret"',
    "embed": 'const char stolen[] = {\n#embed "FOLDER/secret"\n};',
    "import": '#include <cstdio>\nextern "C" __attribute__((import_module("hasOwnProperty"), '
    'import_name("constructor"))) int made(int);\nstatic int in = (made(0), std::puts("IN imports"));',
    "incbin": 'asm(".incbin \\"FOLDER/secret\\"");',
}
_HEADERS = "".join(
    f"#include <{name}>\n"
    for name in ("csignal", "cstdio", "cstdlib", "cstring", "filesystem", "fstream", "functional")
)


def test_no_attack_in_cpp_gets_in(user: str, folder: Path) -> None:
    """The files of a program, and of its compiler, are those that it is given; a right answer comes after each."""
    solved = IN_CPP["make-it-10-hz"].changed
    start = "rclcpp::init(argc, argv);"
    attacks = {name: _HEADERS + solved.replace(start, f"{start}\n{does}") for name, does in IN_A_PROGRAM.items()}
    attacks |= {name: f"{above}\n{solved}" for name, above in ABOVE.items()}
    for name, text in attacks.items():
        text = text.replace("FOLDER", str(folder))
        handed_in(folder / "class", f"{name} 1", "make-it-10-hz", text)
        handed_in(folder / "class", f"{name} 2", "make-it-10-hz", solved)
    with teachers_services(folder) as obeyed:
        status, found, err = judge(folder / "class", user=user)
    assert (status, err, found["sealed"]) == (1, "", True)
    answers = said(found)
    assert {name: answers[f"{name} 2"]["verdict"] for name in attacks} == dict.fromkeys(attacks, "solved")
    tried = {name: answers[f"{name} 1"] for name in attacks}
    assert {name: got_in(answer["said"]) for name, answer in tried.items()} == dict.fromkeys(attacks, [])
    assert {name for name, answer in tried.items() if answer["solved"]} == {"what there is"}
    assert "simulated time stands still" in tried["a loop"]["why"]
    assert not obeyed and "TOPSECRET" not in json.dumps(found)


HOLDS_ON = """
import ctypes, os
libc = ctypes.PyDLL(None)  # which keeps the lock of the interpreter
libc.prctl(1, 0, 0, 0, 0)
libc.setsid()
libc.sigprocmask(0, (ctypes.c_ulong * 16)(*[2**64 - 1] * 16), None)
for _ in range(60):
    if libc.fork() == 0:
        libc.unshare(0x10000000)
        break
libc.sleep(600)
"""


def _processes_of(folder: str) -> list[str]:
    """All processes whose command line names this."""
    found = []
    for path in Path("/proc").glob("[0-9]*/cmdline"):
        try:
            line = path.read_bytes().replace(b"\0", b" ").decode(errors="replace")
        except OSError:
            continue
        if folder in line and int(path.parent.name) != os.getpid():
            found.append(line)
    return found


_NONE = "s.shutil.which = lambda name: None"


@pytest.mark.parametrize("how", [signal.SIGKILL, signal.SIGTERM, signal.SIGINT, signal.SIGHUP])
@pytest.mark.parametrize("where", ["bubblewrap", "without", "container"])
def test_nothing_outlives_the_judge(how: signal.Signals, where: str, user: str, folder: Path) -> None:
    """An answer that asks not to be ended, leaves its session, forks, and holds on to namespaces."""
    handed_in(folder / "class", "eve", "ten-hertz", HOLDS_ON)
    code = f"mark = {folder.name!r}; {_NONE if where == 'without' else 'pass'}; {_PATIENT}"
    mark = f"import rosspin.grading.sealed as s; s._START += '# {folder.name}'; {code}"
    inside = [sys.executable, "-c", _CONTAINER] if where == "container" else []
    unsealed = [] if where == "bubblewrap" else ["--unsealed"]
    command = [sys.executable, "-c", mark, "judge", str(folder / "class"), "--json", *unsealed]
    words = _for_others(user, *inside, *command)
    child = subprocess.Popen(words, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    while not any(" -I " in line for line in _processes_of(folder.name)):
        assert child.poll() is None
        time.sleep(0.05)
    time.sleep(1)
    for pid in _judges(child.pid):
        os.kill(pid, how)
    child.communicate(timeout=NEVER)
    while found := _processes_of(folder.name):  # what is killed is gone a little later
        time.sleep(0.05)
    assert found == []


def _judges(pid: int) -> list[int]:
    """The process that judges: this one, or that which an outer bubblewrap has started."""
    below = Path(f"/proc/{pid}/task/{pid}/children").read_text().split()
    line = Path(f"/proc/{pid}/cmdline").read_bytes()
    return _judges(int(below[0])) if line.startswith(b"bwrap") and below else [pid]


def test_an_answer_ends_nothing_of_the_next_one(user: str, folder: Path) -> None:
    """Neither by its signals, nor by what it leaves in its folder or its pipe, nor by ending the worker."""
    leaves = "import os\nprint('found', os.listdir(), oct(os.stat('.').st_mode))\n"
    leaves += "open('x', 'x').write('a')\nos.chmod('.', 0)"
    closes = (
        "import fcntl, os\nprint('pipe', fcntl.fcntl(3, fcntl.F_GETFL))\nfcntl.fcntl(3, fcntl.F_SETFL, os.O_NONBLOCK)"
    )
    ends = "import ctypes, os\nlibc = ctypes.CDLL(None)\nprint([libc.kill(pid, 9) for pid in (-1, os.getppid())])"
    for number in range(6):
        handed_in(folder / "class", f"a{number}", "ten-hertz", leaves)
        handed_in(folder / "class", f"b{number}", "ten-hertz", ends)
        handed_in(folder / "class", f"c{number}", "slow-timer", SOLVED)
        handed_in(folder / "class", f"d{number}", "ten-hertz", closes)
    _, found, _ = judge(folder / "class", user=user)
    answers = said(found)
    assert all(answers[f"a{number}"]["said"].startswith("found [] 0o41777\n") for number in range(6))
    assert all(answers[f"b{number}"]["said"].startswith("[-1, -1]\n") for number in range(6))
    assert all(answers[f"c{number}"]["solved"] for number in range(6))
    assert all(answers[f"d{number}"]["said"].startswith(f"pipe {os.O_WRONLY}\n") for number in range(6))


LESSON = """
from rosspin.exercises import Finding
TITLE, NODE, HINTS, RIGHT, WRONG = "A beat", "import rclpy", [], ["x = 1"], []
def check(answer):
    yield Finding(bool(answer.ending(1.0)), "It runs.")
"""


def test_wherever_the_package_and_the_teacher_s_exercises_are(user: str, folder: Path) -> None:
    """In folders with any name; as root, also in a copy that is closed to all others."""
    copy = folder / "d'été $x"
    shutil.copytree(Path(worker.__file__).parents[1], copy / "rosspin", ignore=shutil.ignore_patterns("__pycache__"))
    (folder / "my lessons").mkdir()
    (folder / "my lessons/a_beat.py").write_text(LESSON)
    handed_in(folder / "class", "ann", "slow-timer", SOLVED)
    handed_in(folder / "class", "ben", "a-beat", "x = 1")
    if user == "root" and not os.geteuid():
        for path in (copy, *copy.rglob("*"), *(folder / "my lessons").rglob("*")):
            path.chmod(0o700 if path.is_dir() else 0o600)
    where = {"PYTHONPATH": str(copy), "ROSSPIN_LESSONS": str(folder / "my lessons"), "PYTHONDONTWRITEBYTECODE": "1"}
    _, found, _ = judge(folder / "class", user=user, **where)
    assert found["sealed"] and [answer["verdict"] for answer in said(found).values()] == ["solved", "solved"]


@pytest.fixture
def made_pools(require: Callable[[str], None], monkeypatch: pytest.MonkeyPatch) -> Iterator[list[Pool]]:
    require("bwrap")
    monkeypatch.setattr(pool, "TIME", 300)
    made: list[Pool] = []
    yield made
    for each in made:
        each.close()


def judged(made: Pool, *texts: str) -> list[Verdict]:
    found: dict[int, Verdict] = {}
    made.judge([Task("ten-hertz", text) for text in texts], found.__setitem__)
    return [found[number] for number in range(len(texts))]


@pytest.mark.parametrize("unsealed", [False, True])
def test_an_answer_that_never_ends_is_ended(
    unsealed: bool, made_pools: list[Pool], monkeypatch: pytest.MonkeyPatch
) -> None:
    if unsealed:
        monkeypatch.setattr(shutil, "which", lambda name: None)
    made_pools.append(Pool(unsealed))
    monkeypatch.setattr(pool, "TIME", 1)
    (found,) = judged(
        made_pools[0], "import ctypes\nctypes.PyDLL(None).sleep(600)  # which keeps the interpreter's lock"
    )
    assert found.verdict == "did not end" and "It was ended after 1 s." in found.said


@pytest.mark.parametrize("make", ["os.close(os.open(name, os.O_CREAT))", "os.mkdir(name)", "os.symlink('x', name)"])
def test_an_answer_that_makes_files_without_end_is_ended(make: str, made_pools: list[Pool]) -> None:
    """They are in the kernel's memory, however little is in them."""
    made_pools.append(Pool())
    text = f"import itertools, os\nfor name in map(str, itertools.count()):\n    {make}"
    (found,) = judged(made_pools[0], text)
    assert found.verdict == "not judged" and "Its Python broke down" in found.said
    (found,) = judged(made_pools[0], "import os\nfor name in map(str, range(500)):\n    " + make)
    assert found.verdict == "not yet" and "broke down" not in found.said


@pytest.mark.parametrize(
    ("broken", "name"),
    [
        ("close_kernel = lambda: None", "a process"),
        ("_THREADS = 1 << 20; resource.setrlimit = lambda *a: None", "a limit"),
        ("os.environ['A'] = 'b'", "the environment"),
    ],
)
def test_an_answer_whose_seals_do_not_hold_does_not_run(
    broken: str, name: str, made_pools: list[Pool], monkeypatch: pytest.MonkeyPatch
) -> None:
    """They held when the first worker was tried, and do not in a later one."""
    own = Pool()
    made_pools.append(own)
    own.close()
    before, after = sealed._START.split("work(given, own)")
    begins = f"{before}import os, resource\nfrom rosspin.grading import worker as w\n"
    broken = f"do = w._do\ndef _do(*a):\n    exec({broken!r}, vars(w)); do(*a)\nw._do = _do\n"
    monkeypatch.setattr(sealed, "_START", f"{begins}{broken}work(given, own){after}")
    (found,) = judged(own, "print('it runs')")
    assert found.verdict == "not judged" and not found.console
    assert f"It could not be sealed as it has to be, so nothing of it has run. (It said: {name}.)" in found.said


def test_where_no_later_worker_can_be_sealed_nothing_more_runs(
    made_pools: list[Pool], monkeypatch: pytest.MonkeyPatch
) -> None:
    own = Pool(unsealed=True)
    made_pools.append(own)
    own.close()
    monkeypatch.setattr(shutil, "which", lambda name: None)
    (found,) = judged(own, "print('it runs')")
    assert found.verdict == "not judged" and "nothing of it has run" in found.said and not found.console


@pytest.mark.parametrize(
    "left_out", ["--unshare-net", "--unshare-pid", "--unshare-ipc", "--unshare-cgroup", "--clearenv"]
)
def test_what_bubblewrap_made_is_looked_up(
    left_out: str, folder: Path, require: Callable[[str], None], monkeypatch: pytest.MonkeyPatch
) -> None:
    """Another program of that name, which makes less than it is asked for."""
    require("bwrap")
    real = shutil.which("bwrap")
    extra = "--setenv SECRET x" if left_out == "--clearenv" else ""
    (folder / "bwrap").write_text(
        f'#!/bin/bash\nwords=("$@")\nfor i in "${{!words[@]}}"; do\n'
        f'  [ "${{words[$i]}}" = {left_out} ] && unset "words[$i]"\ndone\nexec {real} {extra} "${{words[@]}}"\n'
    )
    (folder / "bwrap").chmod(0o755)
    monkeypatch.setenv("PATH", f"{folder}{os.pathsep}{os.environ['PATH']}")
    if left_out == "--clearenv":
        Pool().close()  # what a worker has of an environment it takes away
    else:
        with pytest.raises(sealed.CannotSeal, match=f"no {left_out.removeprefix('--unshare-')} namespace"):
            Pool()


def test_a_python_may_lie_in_the_folder_of_temporary_files(
    require: Callable[[str], None], monkeypatch: pytest.MonkeyPatch
) -> None:
    require("bwrap")
    with tempfile.TemporaryDirectory(dir="/tmp") as place:
        Path(place).chmod(0o755)
        (Path(place) / "part").write_text("of it")
        monkeypatch.setattr(sealed, "_LIBRARIES", (*sealed._LIBRARIES, place))
        pool = Pool()
        try:
            text = f"import os\nopen('own', 'w')\nprint(open({place + '/part'!r}).read(), os.getcwd(), os.listdir())"
            (verdict,) = judged(pool, text)
        finally:
            pool.close()
    assert verdict.said.startswith("of it /answer ['own']\n")


# Runs a command where there are all users, and no more namespaces of users can be made.
_FORBIDDEN = """
import ctypes, os, sys
ours, theirs = os.pipe(), os.pipe()
if child := os.fork():
    os.read(ours[0], 1)
    for name in ("uid_map", "gid_map"):
        with open(f"/proc/{child}/{name}", "w") as file:
            file.write("0 0 4294967295")
    os.write(theirs[1], b"x")
    sys.exit(os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]))
assert ctypes.CDLL(None).unshare(0x10000000) == 0
os.write(ours[1], b"x")
os.read(theirs[0], 1)
with open("/proc/sys/user/max_user_namespaces", "w") as file:
    file.write("0")
os.execvp(sys.argv[1], sys.argv[1:])
"""


def test_all_users_namespaces_are_taken(user: str, folder: Path, require: Callable[[str], None]) -> None:
    """Root needs none; whoever does is refused, and nothing runs."""
    if os.geteuid():
        pytest.skip("only root can forbid them in a namespace of its own")
    within = [sys.executable, "-c", _FORBIDDEN]
    handed_in(folder / "class", "ann", "slow-timer", SOLVED)
    status, found, err = judge(folder / "class", user=user, within=within)
    if user == "root":
        assert (status, found["sealed"], err) == (0, True, "")
    else:
        assert (status, found) == (2, {})
        assert err.startswith("rosspin: answers cannot be sealed here: bubblewrap: ")
        status, found, err = judge(folder / "class", "--unsealed", user=user, within=within)
        assert (status, found["sealed"]) == (0, False) and "NOT sealed" in err


def test_a_root_that_is_none_outside(folder: Path, require: Callable[[str], None]) -> None:
    """As in a container that an ordinary user has started: only a few users are known in it."""
    require("bwrap")
    handed_in(folder / "class", "ann", "slow-timer", SOLVED)
    status, found, _ = judge(folder / "class", within=["unshare", "--user", "--map-root-user"])
    assert status == 0 and found["sealed"]


# In Docker's usual container, root has these rights only, and no user makes namespaces, mounts or another root.
_CONTAINER = """
import ctypes, os, struct, sys
libc = ctypes.CDLL(None, use_errno=True)
for right in set(range(41)) - {0, 1, 3, 4, 5, 6, 7, 8, 10, 13, 18, 27, 29, 31}:
    libc.prctl(24, right, 0, 0, 0)
x86 = os.uname().machine == "x86_64"
rules = [(0x20, 0, 0, 0), (0x15, 0, 1, 435), (6, 0, 0, 0x50026)]  # clone3: there is none
for number in (272, 165, 155, 166, 308) if x86 else (97, 40, 41, 39, 268):
    rules += [(0x15, 0, 1, number), (6, 0, 0, 0x50001)]
rules += [(0x15, 0, 3, 56 if x86 else 220), (0x20, 0, 0, 16), (0x45, 0, 1, 0x7E020000), (6, 0, 0, 0x50001)]
rules += [(6, 0, 0, 0x7FFF0000)]
data = ctypes.create_string_buffer(b"".join(struct.pack("HBBI", *rule) for rule in rules))
assert not libc.prctl(38, 1, 0, 0, 0)
assert not libc.prctl(22, 2, struct.pack("HP", len(rules), ctypes.addressof(data)), 0, 0)
os.execvp(sys.argv[1], sys.argv[1:])
"""


def _contained(folder: Path) -> list[str]:
    """A container with Python, this copy and a folder in it, and no network."""
    system = [name for name in ("/usr", "/bin", "/lib", "/lib64", "/etc/ld.so.cache") if Path(name).exists()]
    own = [str(place) for place in (Path(sys.base_prefix), Path(sys.prefix), Path(worker.__file__).parents[2])]
    return [
        *("bwrap", "--unshare-all", "--cap-add", "ALL", "--hostname", "container"),
        *("--proc", "/proc", "--dev", "/dev", "--tmpfs", "/tmp"),
        *(word for place in dict.fromkeys(system + own) for word in ("--ro-bind", place, place)),
        *("--bind", str(folder), str(folder), "--", sys.executable, "-c", _CONTAINER),
    ]


def test_in_a_container_that_allows_no_bubblewrap(user: str, folder: Path) -> None:
    """Nothing is judged until that is allowed; then the container is what is between an answer and the teacher."""
    class_ = folder / "class"
    for name in set(ATTACKS) - {"the terminal"}:  # which would write into the report, by way of /proc
        handed_in(class_, name, "ten-hertz", written(name, folder))
    inside = _contained(class_)
    status, found, err = judge(class_, user=user, inside=inside)
    assert (status, found) == (2, {}) and err.startswith("rosspin: answers cannot be sealed here: bubblewrap: ")
    with teachers_services(folder) as obeyed:
        (folder / "bus.sock").chmod(0o666)
        _, found, err = judge(class_, "--unsealed", user=user, inside=inside)
    assert not found["sealed"] and err.startswith("The answers were NOT sealed")
    came = {name: got_in(answer["said"]) for name, answer in said(found).items()}
    kept = ("a socket on the disk", "an abstract socket", "the network", "processes", "memory", "the kernel")
    assert {name: came[name] for name in kept} == dict.fromkeys(kept, [])
    assert not obeyed
    own = {"full", "random", "tty", "ptmx", "stdin", "stdout", "stderr"}
    assert {line.split()[1] for line in came["devices"]} <= {f"/dev/{name}" for name in own}
    assert not [line for line in came["the teacher's files"] if line.startswith(("IN secret", "IN host"))]
    assert sorted(os.listdir(folder)) == ["bus.sock", "class", "secret"]


def test_where_there_is_no_proc_nothing_is_sealed(made_pools: list[Pool], monkeypatch: pytest.MonkeyPatch) -> None:
    exists = os.path.exists
    monkeypatch.setattr(os.path, "exists", lambda path: not str(path).startswith("/proc") and exists(path))
    with pytest.raises(sealed.CannotSeal, match="there is no /proc here, which bubblewrap needs"):
        Pool()


# --- without it -------------------------------------------------------------------------------------------------------


@pytest.fixture
def without(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> str:
    """A PATH on which there is no bubblewrap."""
    return str(tmp_path)


def test_without_a_seal_nothing_is_judged_until_that_is_allowed(without: str, folder: Path) -> None:
    handed_in(folder, "ann", "slow-timer", SOLVED)
    status, found, err = judge(folder, PATH=without)
    assert (status, found) == (2, {})
    assert err.startswith("rosspin: answers cannot be sealed here: bubblewrap is not installed") and "--unsealed" in err


def test_it_is_said_everywhere_that_answers_were_not_sealed(without: str, folder: Path) -> None:
    handed_in(folder / "class", "ann", "slow-timer", SOLVED)
    handed_in(folder / "class", "ben", "slow-timer", "after_1_0_seconds = [1]")
    table = folder / "table.csv"
    _, found, err = judge(folder / "class", "--unsealed", "--csv", str(table), PATH=without)
    assert not found["sealed"] and [student["sealed"] for student in found["students"]] == [False, False]
    assert found["warning"] == err.strip() and err.startswith("The answers were NOT sealed")
    rows = list(csv.DictReader(table.read_text(encoding="utf-8-sig").splitlines()))
    assert [row["sealed"] for row in rows] == ["NO", "NO"]
    command = [sys.executable, "-m", "rosspin", "judge", str(folder / "class"), "--unsealed"]
    done = subprocess.run(command, capture_output=True, text=True, env=os.environ | {"PATH": without})
    first, ann, ben, *_ = done.stdout.splitlines()
    assert first == found["warning"]
    assert ann == "ann: 1 of 1 solved; NOT sealed" and ben == "ben: 0 of 1 solved; not yet: slow-timer; NOT sealed"


# What is kept from an answer all the same: on Linux, by the kernel alone.
_STILL = (
    *("a socket on the disk", "an abstract socket", "the network", "processes", "the environment", "memory"),
    "the kernel",
)


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="other systems have no such filter")
def test_what_is_kept_from_an_answer_without_bubblewrap(without: str, folder: Path) -> None:
    """And each has a folder of its own, which is taken away."""
    for name in _STILL:
        handed_in(folder / "class", name, "ten-hertz", written(name, folder))
    deep = "import os\nfor _ in range(3000): os.mkdir('d'); os.chdir('d')\nos.chmod('.', 0)"
    handed_in(folder / "class", "deep", "ten-hertz", deep)
    handed_in(folder / "class", "writes", "ten-hertz", "open('x', 'x').write('a')\nimport os\nprint(os.getcwd())")
    own_tmp = folder / "tmp"
    own_tmp.mkdir()
    with teachers_services(folder) as obeyed:
        _, found, _ = judge(folder / "class", "--unsealed", PATH=without, TMPDIR=str(own_tmp))
    answers = said(found)
    assert answers.pop("deep")["verdict"] == "not yet"
    own = answers.pop("writes")["said"].splitlines()[0]
    assert own.startswith(str(own_tmp)) and not [*own_tmp.iterdir()]
    left = {
        name: [line for line in got_in(answer["said"]) if "IN proc" not in line] for name, answer in answers.items()
    }
    assert left == dict.fromkeys(_STILL, []) and not obeyed


# --- the list of the kernel's functions -------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("column", "header"),
    [(1, "/usr/include/x86_64-linux-gnu/asm/unistd_64.h"), (2, "/usr/include/asm-generic/unistd.h")],
)
def test_the_numbers_are_those_of_the_kernel(column: int, header: str) -> None:
    if not Path(header).exists():
        pytest.skip("the kernel's headers are not installed (linux-libc-dev)")
    defined = {}
    for line in Path(header).read_text().splitlines():
        words = line.split()
        if len(words) == 3 and words[0] == "#define" and words[1].startswith("__NR") and words[2].isdecimal():
            defined[words[1].removeprefix("__NR3264_").removeprefix("__NR_")] = words[2]
    defined.setdefault("newfstatat", defined.get("fstatat", ""))
    for name, *numbers in (word.split(":") for word in _ALLOWED.split()):
        assert numbers[column - 1] == defined.get(name, ""), name
