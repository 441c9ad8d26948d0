"""The built site keeps what it promises: read from its files, without a browser."""

from __future__ import annotations

import json
import pickle
import re
import shlex
import subprocess
import tomllib
from collections.abc import Iterator
from copy import copy
from pathlib import Path
from types import SimpleNamespace
from typing import Any
from urllib.parse import unquote, urlsplit

import pytest
import yaml
from bs4 import BeautifulSoup, Tag
from docutils import nodes

from rosspin.__main__ import main
from rosspin.site.search import _keep
from tests.helpers.built_pages import parsed
from tests.helpers.commands import COMMANDS, PAGES, SIMULATED
from tests.helpers.tree import DOCTREES, ROOT, SITE

pytestmark = pytest.mark.shares(3)

NOTEBOOKS = sorted(path.stem for path in (ROOT / "notebooks").glob("*.md"))
SOURCES = [page.relative_to(ROOT).with_suffix("").as_posix() for page in PAGES]
# What a browser loads by itself: attributes of these tags, and of links that stand in these relations.
LOADED = {tag: {"src"} for tag in ("script", "iframe", "audio", "embed", "input")}
LOADED |= {tag: {"src", "srcset"} for tag in ("img", "source")}
LOADED |= {tag: {"href", "xlink:href"} for tag in ("image", "use")} | {"object": {"data"}, "video": {"src", "poster"}}
LOADED_LINKS = {"stylesheet", "icon", "manifest", "preload", "modulepreload", "prefetch", "preconnect", "dns-prefetch"}
FOREIGN = re.compile(r"\s*(?:[a-z]+:)?//", re.IGNORECASE)
FOREIGN_IN_CSS = re.compile(r"""(?:url\(\s*|@import\s+)["']?(?:[a-z]+:)?//[^)"';]*""", re.IGNORECASE)
FOREIGN_IN_JS = re.compile(
    r"""(?:\bimport\b\s*\(?|\bfrom\b|\bfetch\s*\(|\bimportScripts\s*\(|\bnew\s+(?:Worker|WebSocket|EventSource)\s*\("""
    r"""|\.open\s*\(\s*["'][A-Z]+["']\s*,|\.(?:src|href)\s*=)\s*["'`](?:[a-z]+:)?//[^"'`]*""",
    re.IGNORECASE,
)


@pytest.fixture(scope="module")
def pages(site: Path) -> dict[Path, BeautifulSoup]:
    """Every built page, parsed, by its path."""
    files = [path for path in sorted(site.rglob("*.html")) if "_static" not in path.parts]
    return {path: parsed(path) for path in files}


@pytest.mark.parametrize("name", sorted({"index", "docs/tutorial", "notebooks/timer", "notebooks/rate", *SOURCES}))
def test_page_is_built(site: Path, name: str) -> None:
    assert (site / f"{name}.html").is_file()


def _page(name: str) -> BeautifulSoup:
    return parsed(SITE / f"{name}.html")


def test_links_lead_somewhere(pages: dict[Path, BeautifulSoup]) -> None:
    tags = {path: page.find_all(True) for path, page in pages.items()}
    anchors = {path: {str(tag.get(name)) for tag in of for name in ("id", "name")} for path, of in tags.items()}
    broken = []
    for path, of in tags.items():
        for target in {str(target) for tag in of if (target := tag.get("href") or tag.get("src"))}:
            url = urlsplit(target)
            if url.scheme or url.netloc or target == "#":  # "#" is a button of the theme
                continue
            # Links of the page for wrong addresses begin at the site's root.
            below = SITE / url.path.lstrip("/") if path.name == "404.html" else path.parent / unquote(url.path)
            file = below.resolve() if url.path else path
            found = file.is_file() and (not url.fragment or unquote(url.fragment) in anchors.get(file, ()))
            if not found:
                broken.append(f"{path.relative_to(SITE)}: {target}")
    assert not broken


def test_the_page_for_wrong_addresses_works_from_any_depth(pages: dict[Path, BeautifulSoup]) -> None:
    page = pages[SITE / "404.html"]
    targets = [str(tag.get("href") or tag.get("src")) for tag in page.select("[href], [src]")]
    assert not [target for target in targets if not target.startswith(("/", "#"))]
    assert page.html and page.html["data-content_root"] == "/"


def test_no_address_is_told_where_none_is_known(pages: dict[Path, BeautifulSoup]) -> None:
    assert not (SITE / "sitemap.xml").exists()
    for page in pages.values():
        assert not page.select("link[rel=canonical], meta[property^='og:'], .editthispage")


def _alternative(tag: Tag) -> str | None:
    """The text that stands for an image, "" where it is marked as decoration, None where nothing is said."""
    if any(parent.get("aria-hidden") == "true" for parent in [tag, *tag.parents]):
        return ""
    if tag.name == "img":
        return str(tag.get("alt", "")).strip() or None
    label = str(tag.get("aria-label", "")).strip()
    return label if tag.get("role") == "img" and label else None


def test_images_say_what_they_show(pages: dict[Path, BeautifulSoup]) -> None:
    poor = []
    for path, page in pages.items():
        for tag in page.select("img, svg:not(svg svg)"):  # an svg within one is a part of it
            text = _alternative(tag)
            if text is None or re.search(r"\.(svg|png|jpe?g|gif|webp)$|[0-9a-f]{16}", text, re.IGNORECASE):
                poor.append(f"{path.relative_to(SITE)}: {text!r} for {str(tag)[:120]}")
    assert not poor


def test_no_markup_stands_as_text(pages: dict[Path, BeautifulSoup]) -> None:
    """Markdown that was not rendered: a table, or code in prose."""
    markup = re.compile(r"`|\|\s*:?(?:-{2,}|[\u2013\u2014])")  # dashes have become typographic ones
    raw = [
        f"{path.relative_to(SITE)}: {text.strip()}"
        for path, page in pages.items()
        for text in page.find_all(string=markup)
        if not text.find_parent(["code", "pre", "script", "style"])
    ]
    assert not raw


def test_no_step_and_no_listing_stands_as_a_quotation(pages: dict[Path, BeautifulSoup]) -> None:
    """A space too many before an item begins a quotation, and the numbers of a list begin again at 1."""
    quoted = [path.relative_to(SITE) for path, page in pages.items() if page.select("article blockquote :is(li, pre)")]
    assert not quoted


def test_nobody_has_solved_an_exercise_when_the_site_is_built(site: Path) -> None:
    found = [*site.glob("notebooks/*exercises.html"), *site.rglob("*exercises.ipynb")]
    assert len(found) == 4
    assert not [path for path in found if "You have solved" in path.read_text(encoding="utf-8")]


def test_a_topic_is_drawn_from_its_messages() -> None:
    """By ``ticks`` with ``:topic:``."""
    plots = _page("docs/publish-build").select("figure > svg.rosspin-wide")
    labels = [plot["aria-label"] for plot in plots if not plot.find_parent(class_="live-made")]
    assert labels == ["Timeline. /counter: 4 ticks from 0.500 s to 2.000 s. All 4 ticks were on time."]


def test_a_fault_is_drawn_below_the_ticks() -> None:
    """By ``ticks`` with ``:faults:``."""
    (plot,) = _page("docs/how-to/break-things-on-purpose").select("figure > svg.rosspin-wide")
    assert str(plot["aria-label"]).endswith("Faults: the clock set by -0.1 s at 0.200 s.")
    assert "the clock set" in plot.get_text()


def _loaded(page: BeautifulSoup) -> list[str]:
    """The addresses that a browser loads by itself."""
    tags = page.find_all(True)
    loaded = [str(tag[name]) for tag in tags for name in LOADED.get(tag.name, ()) if tag.get(name)]
    links = [tag for tag in tags if tag.name == "link" and LOADED_LINKS & set(tag.get_attribute_list("rel"))]
    return loaded + [str(tag["href"]) for tag in links]


@pytest.mark.parametrize(
    ("text", "loaded"),
    [
        ('<script src="a"></script><iframe src="b"></iframe><video src="c" poster="d"></video>', ["a", "b", "c", "d"]),
        ('<img src="a" srcset="b 2x"><svg><use xlink:href="c"/><image href="d"/></svg>', ["a", "b 2x", "c", "d"]),
        ('<object data="a"></object><link rel="icon stylesheet" href="b">', ["a", "b"]),
        ('<a href="a">b</a><link rel="next" href="c"><p style="d">e</p>', []),
    ],
)
def test_what_a_browser_loads_is_known(text: str, loaded: list[str]) -> None:
    assert sorted(_loaded(BeautifulSoup(text, "html.parser"))) == loaded


def test_pages_load_nothing_from_elsewhere(pages: dict[Path, BeautifulSoup]) -> None:
    foreign = []
    for path, page in pages.items():
        inline = [tag.get_text() for tag in page.find_all("style")]
        inline += [str(tag["style"]) for tag in page.find_all(style=True)]
        scripts = [tag.get_text() for tag in page.find_all("script")]
        found = [url for url in _loaded(page) if any(FOREIGN.match(part) for part in url.split(","))]
        found += [hit for text in inline for hit in FOREIGN_IN_CSS.findall(text)]
        found += [hit for text in scripts for hit in FOREIGN_IN_JS.findall(text)]
        foreign += [f"{path.relative_to(SITE)}: {hit}" for hit in found]
    assert not foreign


def test_styles_and_scripts_load_nothing_from_elsewhere(site: Path) -> None:
    patterns = {".css": FOREIGN_IN_CSS, ".svg": FOREIGN_IN_CSS, ".js": FOREIGN_IN_JS, ".mjs": FOREIGN_IN_JS}
    foreign = [
        f"{path.relative_to(site)}: {hit}"
        for path in sorted(site.rglob("*"))
        if path.suffix in patterns
        for hit in patterns[path.suffix].findall(path.read_text(encoding="utf-8"))
    ]
    assert not foreign


@pytest.mark.parametrize(
    ("pattern", "text"),
    [
        (FOREIGN_IN_CSS, "@import 'https://fonts.example/a.css';"),
        (FOREIGN_IN_CSS, "src: url(//fonts.example/a.woff2)"),
        (FOREIGN_IN_JS, 'import x from "https://cdn.example/x.js"'),
        (FOREIGN_IN_JS, "fetch('//api.example')"),
        (FOREIGN_IN_JS, 'script.src = "https://cdn.example/x.js"'),
    ],
)
def test_a_foreign_host_would_be_noticed(pattern: re.Pattern[str], text: str) -> None:
    assert pattern.search(text)
    assert not pattern.search(text.replace("https:", "").replace("//", "/").replace("@import '/", "@import '"))


@pytest.mark.parametrize("name", NOTEBOOKS)
def test_notebook_can_be_downloaded_executed(site: Path, name: str) -> None:
    links = [str(tag["href"]) for tag in _page(f"notebooks/{name}").select("a.download[href$='.ipynb']")]
    assert links, "the page offers no .ipynb: write {nb-download}`" + name + ".ipynb`"
    notebook = json.loads((site / "notebooks" / links[0]).read_text(encoding="utf-8"))
    cells = [cell for cell in notebook["cells"] if cell["cell_type"] == "code"]
    outputs = [output for cell in cells for output in cell["outputs"]]
    assert outputs
    assert all(cell["execution_count"] for cell in cells)
    assert not [output for output in outputs if output["output_type"] == "error"]


def _literals(name: str) -> Iterator[tuple[nodes.Element, bool]]:
    """The literal texts of a page, and whether the doctest builder runs them (by its own rule)."""
    doctree = pickle.loads((DOCTREES / f"{name}.doctree").read_bytes())
    for node in doctree.findall(lambda node: isinstance(node, nodes.FixedTextElement)):
        yield node, isinstance(node, nodes.doctest_block) or node.get("testnodetype") == "doctest"


@pytest.mark.parametrize("name", SOURCES)
def test_every_prompt_on_the_site_is_run(site: Path, name: str) -> None:
    """No ``>>>`` stands where the doctest builder would not collect it, and none is told to skip."""
    prompt = re.compile(r"^ *>>> ", re.MULTILINE)
    literals = list(_literals(name))
    shown = [node.astext() for node, run in literals if not run and prompt.search(node.astext())]
    assert not shown, "a block with >>> that never runs: make it a doctest block"
    run = "\n".join(str(node.get("test", node.astext())) for node, run in literals if run)
    source = next(ROOT.glob(f"{name}.*")).read_text(encoding="utf-8")
    assert len(prompt.findall(run)) == len(prompt.findall(source)), "a >>> outside a doctest block never runs"
    assert not re.search(r"doctest: *\+SKIP|^ *:skipif:", source, re.MULTILINE)


@pytest.mark.parametrize(
    ("name", "kinds"),
    [
        ("docs/tutorial-timer", ["SPINNER PY NODE"]),
        ("docs/ros2/tutorial-timer", ["SPINNER PY NODE"]),
        ("docs/publish-build", ["PUBSUB PY NODE", "SUBSCRIBER PY NODE"]),
        ("docs/ros2/publish-build", ["SUBSCRIBER PY NODE"]),
    ],
)
def test_the_counters_that_a_page_shows_are_examples(site: Path, name: str, kinds: list[str]) -> None:
    shown = (node.astext() for node, run in _literals(name) if run or node.get("testnodetype") == "testoutput")
    printed = "\n".join(shown)
    for kind in kinds:
        assert (
            len(re.findall(rf"\[0\.0+\].*\[{kind}\] (?:counter = 1|namespace)", printed)) >= 1
        )  # the Rate's, the first
        assert len(re.findall(rf"\[0\.50+\].*\[{kind}\] counter = 1$", printed, re.MULTILINE)) >= 1
        assert len(re.findall(rf"\[2\.0+\].*\[{kind}\] counter = \d", printed)) >= 1


def test_there_are_as_many_examples_as_there_were(site: Path) -> None:
    """180 with a prompt, and the commands whose console is shown; Sphinx counts them so, too."""
    literals = [node for name in SOURCES for node, run in _literals(name) if run or "testnodetype" in node]
    prompts = [line for node in literals for line in node.astext().splitlines() if line.lstrip().startswith(">>> ")]
    assert len(prompts) + sum(node.get("testnodetype") == "testcode" for node in literals) >= 183


def test_readme_shows_its_commands() -> None:
    assert {"make html", "make test"} <= set(COMMANDS)


@pytest.mark.parametrize("command", [command for command in COMMANDS if "make " in command])
def test_make_command_exists(command: str) -> None:
    subprocess.run(f"{command} --dry-run", shell=True, cwd=ROOT, check=True, capture_output=True)


@pytest.mark.parametrize("command", [command for command in COMMANDS if "pytest " in command])
def test_pytest_is_given_files_that_there_are(command: str) -> None:
    files = re.findall(r"(?:tests|examples)/\S*", command)
    assert all((ROOT / file).exists() for file in files)


@pytest.mark.parametrize("command", SIMULATED)
def test_simulated_run_works(
    command: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """Typed as it stands, in a folder that has the examples; tests/real has what needs the wall clock or ROS."""
    (tmp_path / "examples").symlink_to(ROOT / "examples")
    monkeypatch.chdir(tmp_path)
    assert main(["run", *shlex.split(command.partition(" run ")[2])]) == 0
    said = "rosspin: deadlock. This can never continue:" if "/hangs/" in command else "counter = 1"
    if "--schedule " in command:  # in this order a part is lost
        said = "parts = 19"
    assert said in "".join(capsys.readouterr())


@pytest.mark.parametrize("name", ["docs/ros2/tutorial", "docs/tutorial"])
def test_who_chooses_cpp_is_told_what_can_be_done_without_ros(name: str) -> None:
    """In the tab of the first listing, with a command that is tried above."""
    tab, *_ = (tab for tab in _page(name).select(".sd-tab-content") if "spinner_cpp_node.cpp" in tab.get_text())
    assert "spinner_cpp_node.cpp \\\n      --simulated" in tab.get_text()


def test_readme_links_lead_somewhere() -> None:
    readme = (ROOT / "README.md").read_text(encoding="utf-8")
    targets = [target for target in re.findall(r"\]\(([^)]+)\)", readme) if not urlsplit(target).scheme]
    assert targets
    assert not [target for target in targets if not (ROOT / target).is_file()]


# The sections of a page that are on others now. A link to one still leads to where its page is named.
MOVED = {
    ("docs/tutorial", "tutorial-timer"): "python-only-add-a-class-definition "
    "add-a-callback-function-for-when-the-timer-triggers initialise-a-timer-and-connect-it-to-the-callback",
    (
        "docs/tutorial",
        "tutorial-launch",
    ): "add-the-c-node-to-cmakelists-txt-and-compile make-the-python-file-executable launch-and-test",
    ("docs/tutorial", "tutorial-rate"): "alternative-fixed-frequency-spinning-in-the-main",
    ("docs/ros2/tutorial", "tutorial-timer"): "start-with-a-class "
    "add-a-callback-function-for-when-the-timer-triggers initialise-a-timer-and-connect-it-to-the-callback",
    (
        "docs/ros2/tutorial",
        "tutorial-build",
    ): "make-a-package-and-build-it run-and-test ros2-run-and-test stop-the-node",
    ("docs/ros2/tutorial", "tutorial-rate"): "alternative-fixed-frequency-spinning-with-a-rate",
    ("docs/publish", "publish-build"): "c-only-make-the-node-a-class publish-the-counter subscribe-in-the-same-node "
    "subscribe-in-another-node add-the-c-nodes-to-cmakelists-txt-and-compile make-the-python-files-executable "
    "launch-and-test",
    ("docs/publish", "publish-lost"): "why-the-first-message-may-be-lost publish-first-message what-queue-size-drops "
    "publish-queue-size how-far-to-believe-rostopic-hz",
    ("docs/ros2/publish", "publish-build"): "publish-the-counter subscribe-in-another-node build-and-run-them",
    ("docs/ros2/publish", "publish-qos"): "one-process-or-two depth-what-a-slow-subscriber-misses ros2-publish-depth "
    "durability-what-a-late-subscriber-hears ros2-publish-late when-the-two-ends-do-not-match ros2-publish-mismatch",
    ("notebooks/ros2-timer", "ros2-timer-slow"): "make-one-call-slow-and-read-how-late-the-next-one-is "
    "compare-it-with-the-real-rclpy stop-a-timer-and-start-it-again",
    ("notebooks/ros2-rate", "ros2-rate-slow"): "make-a-pass-take-too-long make-the-loop-hang look-at-how-the-loop-ends",
    ("notebooks/ros2-executors", "ros2-groups"): "see-a-callback-overlap-itself change-the-work-of-the-slow-timer "
    "keep-a-rule-of-thumb",
    ("notebooks/ros2-services", "ros2-actions"): "wait-for-the-answer-in-other-ways follow-an-action",
}


@pytest.mark.parametrize(("name", "other"), MOVED)
def test_the_address_of_a_section_that_has_moved_leads_on(name: str, other: str) -> None:
    for section in MOVED[name, other].split():
        place = _page(name).find(id=section)
        assert isinstance(place, Tag), section
        around = place.find_parent("section")
        assert around and around.select(f"a[href='{other}.html']")


VERDICT = re.compile(r"(True|False|It depends|Not guaranteed|Not after lost ticks|Only on|Only with)\b[^:]*: .*\w")


@pytest.mark.parametrize(("name", "least"), [("docs/how-timing-works", 13), ("docs/ros2/how-timing-works", 11)])
def test_headings_on_how_timing_works_show_the_verdict(name: str, least: int) -> None:
    """A reader who scans the contents of the page must not take a false claim for a statement."""
    headings = [tag.get_text() for tag in _page(name).select("article h2, article h3")]
    claims = [heading for heading in headings if "\u201c" in heading]
    assert len(claims) >= least
    assert [claim for claim in claims if not VERDICT.match(claim)] == []


def test_each_claim_has_a_short_link_that_stays() -> None:
    """Links are given to others: ``links.txt`` may get new lines, and loses none."""
    given = (ROOT / "tests/site/links.txt").read_text(encoding="utf-8").splitlines()
    found = []
    for name in ("docs/how-timing-works", "docs/ros2/how-timing-works"):
        for heading in _page(name).select("article h2, article h3"):
            if "\u201c" in heading.get_text():
                (link,) = heading.select("a.headerlink")
                found.append(f"{name}.html{link['href']}")
    assert found == given


@pytest.mark.parametrize("name", ["docs/ros2/how-timing-works", "docs/ros2/from-ros-1"])
def test_no_line_ends_between_a_number_and_its_unit(name: str) -> None:
    article = copy(_page(name).select("article")[0])
    for code in article.select("pre, code, figure, .cell"):
        code.decompose()
    text = article.get_text()
    assert re.search(r"\d\N{NO-BREAK SPACE}s\b", text)
    assert re.findall(r".*\d[ \n](?:s|ms|Hz)\b.*", text) == []


def test_the_sidebar_in_order() -> None:
    captions = [tag.get_text() for tag in _page("index").select("nav.bd-docs-nav .caption")]
    of_ros_1 = [f"{caption} (ROS 1)" for caption in ("Before you start", "Tutorials", "Practice")]
    assert captions == ["ROS 2", *of_ros_1, "Explanation", "How-to", "Reference", "For teachers"]


def test_the_first_paragraph_of_the_site_is_one_sentence() -> None:
    assert _page("index").select("article p")[0].get_text().count(".") == 1


def test_the_first_page_says_when_ros_1_ended_and_what_to_choose() -> None:
    text = " ".join(_page("index").select("article")[0].get_text().split())
    assert "ROS 1 ended on 31 May 2025. If the choice is yours, learn ROS 2." in text


@pytest.mark.parametrize(
    "term",
    [
        *("callback", "callback queue", "cycle", "drift", "executor", "grid", "jitter", "lateness", "namespace"),
        *("node handle", "overrun", "pass", "period", "rate", "rosspin", "simulated time", "spin", "stand-in"),
        *("tick", "timestamp", "latch", "message", "publisher", "subscriber", "topic", "callback group"),
    ],
)
def test_the_glossary_has(term: str) -> None:
    found = [tag.contents[0].get_text().strip() for tag in _page("docs/glossary").select("dl.glossary dt")]
    assert term in found


def test_every_page_is_on_the_path_of_the_course_or_in_its_sidebar() -> None:
    """What the reading paths name can be found; the tutorial, the notebooks and the page on timing are on them."""
    targets = {re.split("[?#]", str(tag["href"]))[0] for tag in _page("docs/paths").select("article a.internal")}
    assert {f"../notebooks/{name}.html" for name in ("timer", "rate", "slow-callback", "drift", "exercises")} <= targets
    assert {"tutorial.html", "how-timing-works.html", "how-to/irregular-loop.html"} <= targets
    assert {f"../notebooks/ros2-{name}.html" for name in ("timer", "rate", "executors", "exercises")} <= targets
    assert {f"ros2/{name}.html" for name in ("tutorial", "how-timing-works", "from-ros-1")} <= targets


def test_the_reading_paths_give_the_minutes_of_the_notebooks() -> None:
    for row in _page("docs/paths").select("tr:has(a.internal[href*='/notebooks/'])"):
        name = Path(str(row.select("a.internal")[0]["href"])).stem
        text = (ROOT / "notebooks" / f"{name}.md").read_text(encoding="utf-8")
        found = re.search(r"\*\*Time\*\*: (\d+) minutes", text)
        if found and "exercises" not in row.get_text():  # else it is for a part
            assert row.select("td")[0].get_text().strip() == found[1], name


def test_citation() -> None:
    citation = yaml.safe_load((ROOT / "CITATION.cff").read_text(encoding="utf-8"))
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    assert citation["version"] == project["version"]
    assert [author["name"] for author in citation["authors"]] == [author["name"] for author in project["authors"]]
    assert citation["license"] == "CC-BY-4.0"
    assert citation["references"][0]["authors"][0]["family-names"] == "Beuchat"
    assert {"cff-version", "message", "title", "type"} <= citation.keys()


@pytest.mark.parametrize("name", ["how-timing-works", "ros2/how-timing-works", "ros2/from-ros-1"])
def test_no_number_in_how_timing_works_is_typed(name: str) -> None:
    """Each is filled in from a run or a recording."""
    text = (ROOT / "docs" / f"{name}.rst").read_text(encoding="utf-8")
    prose = re.sub(r"^ *\.\. (?:facts|ticks|scenes|literalinclude)::.*\n(?:\n|   .*\n)+", "", text, flags=re.MULTILINE)
    prose = re.sub(
        r":\w+:`[^`]*`|``[^`]*``|^ +:[\w-]+: [\d ]+$|\S+\.svg|^\.\. _.*:$|ROS [12]|31 May 2025",
        "",
        prose,
        flags=re.MULTILINE,
    )
    assert len(prose) > 2500
    assert re.findall(r".*\d.*", prose) == []


@pytest.mark.parametrize(
    ("name", "named_in", "least"), [("for-teachers", "td", 11), ("slides/ros2", "ol", 6), ("slides/ros1", "ol", 6)]
)
def test_the_pages_for_teachers_name_exercises_that_there_are(name: str, named_in: str, least: int) -> None:
    pages = [_page(f"notebooks/{name}") for name in ("exercises", "ros2-exercises")]
    titles = {tag.get_text() for page in pages for tag in page.select(".exercise-list a")}
    named = [tag.get_text() for tag in _page(f"docs/{name}").select(f"{named_in} em")]
    assert len(named) >= least
    assert set(named) <= {re.sub(r"^\d+\. ", "", title) for title in titles}


# What a student types, and the page that it should find first.
FIRST = {
    "docs/glossary": [
        *("callback", "drift", "executor", "jitter", "lateness", "publisher", "service", "simulated time", "spin"),
        "subscriber",
    ],
    "docs/how-to/frequency-from-parameter": ["parameter"],
    "docs/how-to/info-lines": ["use_sim_time"],
    "docs/how-to/irregular-loop": ["rostopic hz"],
    "docs/how-to/look-at-your-log": ["log"],
    "docs/how-to/shared-data": ["lock", "race"],
    "docs/how-to/test-timing": ["pytest", "test"],
    "docs/how-to/timer-or-rate": ["sleep", "timer"],
    "docs/how-to/why-does-it-hang": ["deadlock", "hang", "hangs"],
    "docs/reference/launch-files": ["launch"],
    "docs/ros2/publish-qos": ["qos"],
    "docs/ros2/tutorial": ["C++", "frequency", "hz"],
    "docs/ros2/tutorial-build": ["Ctrl-C"],
    "docs/ros2/tutorial-rate": ["rate"],
    "docs/simulation-limits": ["wall clock"],
    "notebooks/ros2-executors": ["thread"],
}
FOUND = {word: page for page, words in FIRST.items() for word in words}


@pytest.fixture(scope="module")
def searched(site: Path) -> dict[str, list[str]]:
    """The pages that the script of the search finds for each word, best first."""
    command = [str(ROOT / ".venv/bin/node"), str(ROOT / "tests/helpers/search.mjs"), str(site), *FOUND]
    found: dict[str, list[str]] = json.loads(subprocess.run(command, capture_output=True, text=True, check=True).stdout)
    return found


@pytest.mark.parametrize("word", FOUND)
def test_a_word_that_a_student_types_leads_to_its_page_first(searched: dict[str, list[str]], word: str) -> None:
    assert searched[word][0] == FOUND[word]


def test_pages_to_look_things_up_in_come_last(searched: dict[str, list[str]]) -> None:
    """``scorer.js`` says which."""
    assert all("slides" not in page for pages in searched.values() for page in pages[:5])


def test_the_search_keeps_what_leads_to_pages_that_are_not_written_again() -> None:
    entries = {"page": [("single", "hang; deadlock", "index-0", "main", None), ("pair", "lost", "", "", None)]}
    indexer = SimpleNamespace(_index_entries={"other": [("timer", "", "")]})
    app: Any = SimpleNamespace(builder=SimpleNamespace(indexer=indexer))
    app.env = SimpleNamespace(domaindata={"index": {"entries": entries}})
    _keep(app)
    kept = [("deadlock", "index-0", "main"), ("hang", "index-0", "main")]
    assert indexer._index_entries == {"other": [("timer", "", "")], "page": kept}


def test_every_page_has_a_language_and_one_main_heading(pages: dict[Path, BeautifulSoup]) -> None:
    for path, page in pages.items():
        assert page.html and page.html["lang"] == "en", path
        assert len(page.select("h1")) == 1, path
