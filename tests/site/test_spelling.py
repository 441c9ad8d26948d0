"""Spelling, by codespell: its list of typing errors, and its list of American spellings, for the site is British."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

import codespell_lib
import pytest

from tests.helpers.tree import ROOT

pytestmark = pytest.mark.shares(3)

TEXTS = ["README.md", "CHANGELOG.md", ".github", "index.rst", "conf.py", "Makefile"]
TEXTS += ["docs", "notebooks", "src", "examples", "tests", "benchmarks"]
PAGES = ["README.md", "CHANGELOG.md", ".github", "index.rst", *sorted(ROOT.glob("docs/**/*.rst")), "notebooks"]

# British too, in the sense meant here: the verb and the file LICENSE, what a computer runs, a module of Python, a noun.
BRITISH = "license,licensed,licenses,program,programs,math,practice"
# A method of a goal in rclpy.
IN_LISTINGS = "canceled"
# rospy, rclpy, launch, CSS and io have names and messages in American; so has Python.
IN_CODE = "color,initialized,colors,serialize,deserialize,writable,canceled,canceling,capitalize"
IN_CODE += ",finalized,deserializing"
IN_CODE += ",center,initialize,recognized,serialization,serialized,uninitialized,synchronize,unrecognized,normalize"
IN_CODE += ",synchronizer"
# A package that is a part of many words, a part of a word in a recorded error, words of rclpy's and message_filters'.
NAMES = "simpy,te,transtion,infomation"


@pytest.fixture(scope="session")
def american(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """codespell's table of British and American words, turned round."""
    table = Path(codespell_lib.__file__).parent / "data" / "dictionary_en-GB_to_en-US.txt"
    pairs = [line.split("->") for line in table.read_text(encoding="utf-8").split()]
    path = tmp_path_factory.mktemp("spelling") / "american.txt"
    path.write_text("".join(f"{american.rstrip(',')}->{british}\n" for british, american in pairs), encoding="utf-8")
    return path


def misspelt(*options: object) -> list[str]:
    """What codespell finds in the source folder."""
    command = [sys.executable, "-m", "codespell_lib", "--skip", "*.svg,*.csv,__pycache__", *map(str, options)]
    return subprocess.run(command, cwd=ROOT, capture_output=True, text=True).stdout.splitlines()


def test_words_are_spelt_right() -> None:
    texts = [path for path in TEXTS if (ROOT / path).exists()]
    found = misspelt("--builtin", "clear,rare", "--ignore-words-list", NAMES, *texts)
    assert not [line for line in found if Path(__file__).name not in line]


@pytest.mark.parametrize(
    ("texts", "allowed"),
    [
        (PAGES, f"{BRITISH},{IN_LISTINGS}"),
        (["src", "conf.py", "Makefile", "docs/_static"], f"{BRITISH},{IN_CODE}"),
    ],
    ids=["pages", "code"],
)
def test_the_spelling_is_british(american: Path, texts: list[str], allowed: str) -> None:
    assert not misspelt("--dictionary", american, "--ignore-words-list", allowed, *texts)


@pytest.mark.parametrize("word", ["recieve", "occured", "seperate"])
def test_a_typing_error_would_be_noticed(tmp_path: Path, word: str) -> None:
    (tmp_path / "page.rst").write_text(f"A word: {word}.\n")
    assert misspelt("--builtin", "clear,rare", tmp_path)


@pytest.mark.parametrize("word", ["behavior", "initialize", "center", "gray"])
def test_an_american_word_would_be_noticed(american: Path, tmp_path: Path, word: str) -> None:
    (tmp_path / "page.rst").write_text(f"A word: {word}.\n")
    assert misspelt("--dictionary", american, tmp_path)


# Phrases that have two senses, or sound translated.
AVOIDED = re.compile(
    r"\b(at\s+once|anew|(any|every|no|some)body\s+who\s+(spins|sleeps)|would\s+not\s+do\s+so|that\s+which|it\s+is\s+(not|no)\s+so)\b",
    re.IGNORECASE,
)


@pytest.mark.parametrize("text", ["Ring At\nonce", "nobody who spins", "It would not do so.", "begins anew"])
def test_a_phrase_to_avoid_would_be_noticed(text: str) -> None:
    assert AVOIDED.search(text)
    assert not AVOIDED.search("three_at_once, at one, immediately")


# Plain English has a shorter or a stronger word.
STIFF = re.compile(
    r"\b((go|goes|went) on|(?<!>)(any|every|no|some)body|held to|mend(s|ed|ing)?|(that|those|the ones?) of|for ever"
    r"|anew|beside (an?|each|every|its?|that|the|them|what)|(?<!there )(is|are|was|were) to (?!(an?|the)\b)[a-z]+)\b",
    re.IGNORECASE,
)


@pytest.mark.parametrize(
    "text",
    [
        *("The node goes on.", "Somebody spins.", "It is held\n    # to that.", "a lock mends it", "beside the node"),
        *("its clock and that of the node", "It is to stop.", "waits for ever"),
    ],
)
def test_a_stiff_word_would_be_noticed(text: str) -> None:
    assert STIFF.search(_unwrapped(text))
    fine = "nobody_spins, what is going on, recommended, <a>nobody</a>, for_ever, beside=1, there is to say"
    assert not STIFF.search(fine)


REMARKS = re.compile(r'(?<!["\'])#.*|"""(?:.|\n)*?"""')


def test_no_stiff_word_is_left() -> None:
    """In the pages, and in messages, docstrings and comments."""
    texts = [ROOT / name for name in ("README.md", "CHANGELOG.md", "index.rst")]
    for folder in "docs", "notebooks", "src/rosspin", "web/src", "web/test":
        suffixes = {".rst", ".md", ".py", ".js", ".mjs", ".css", ".ts", ".h", ".hpp", ".cpp"}
        texts += [path for path in (ROOT / folder).rglob("*") if path.suffix in suffixes]
    texts += [*(ROOT / "web").glob("*.mjs"), *(ROOT / "tests").rglob("*.mjs")]
    found = {path: STIFF.findall(_unwrapped(path.read_text(encoding="utf-8"))) for path in texts}
    for path in (ROOT / "tests").rglob("*.py"):
        if path != Path(__file__):  # of tests, what is said, not what is run
            remarks = "\n".join(REMARKS.findall(path.read_text(encoding="utf-8")))
            found[path] = STIFF.findall(_unwrapped(remarks))
    assert not {path: words for path, words in found.items() if words}


# Sounds translated, too. Gone through are the course on ROS 2, up to its exercises, and what is like it for ROS 1.
TRANSLATED = re.compile(r"\b(stands?(?!-)|lets?|beside)\b|(?<=\. )What\b[^?.]*\.(?= |$)", re.IGNORECASE)
COURSE = [page for name in ("tutorial", "publish", "how-timing") for page in sorted(ROOT.glob(f"docs/**/{name}*.rst"))]
COURSE += [page for page in sorted(ROOT.glob("notebooks/ros2-*.md")) if page.stem != "ros2-exercises"]
COURSE += [ROOT / f"notebooks/{name}.md" for name in ("timer", "rate", "slow-callback", "drift", "publish")]
COURSE += [ROOT / "notebooks/two-languages.md"]


@pytest.mark.parametrize(
    "text", ["It stands\nbelow.", "Let it run.", "a box beside it", "It ran. What counts is time.\n"]
)
def test_a_phrase_that_sounds_translated_would_be_noticed(text: str) -> None:
    assert TRANSLATED.search(_unwrapped(text))
    assert not TRANSLATED.search("a stand-in, letter, besides, It ran. What counts?")


@pytest.mark.parametrize("page", COURSE, ids=lambda page: page.stem)
def test_nothing_on_the_course_sounds_translated(page: Path) -> None:
    text = _unwrapped(page.read_text(encoding="utf-8"))
    assert not [found[0] for words in (STIFF, TRANSLATED) for found in words.finditer(text)]


def _unwrapped(text: str) -> str:
    """A text in one line, without the marks of comments."""
    return re.sub(r"\n[ \t]*(?:#|//|\*)?[ \t]*", " ", text)


def test_no_phrase_to_avoid_is_left() -> None:
    """In the pages, and in what exercises, runs in a page and verdicts on logs say."""
    texts = [ROOT / "README.md", ROOT / "index.rst", ROOT / "src/rosspin/page.py", *ROOT.glob("docs/**/*.rst")]
    for folder, suffix in {"notebooks": "md", "web/src": "js", "src/rosspin/exercises": "py", "examples": "py"}.items():
        texts += ROOT.glob(f"{folder}/**/*.{suffix}")
    texts += ROOT.glob("src/rosspin/look/*.py")
    found = {path: AVOIDED.findall(path.read_text(encoding="utf-8")) for path in texts}
    assert not {path: words for path, words in found.items() if words}
