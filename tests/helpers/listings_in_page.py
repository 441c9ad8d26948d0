"""The listings of a page that can be run, as a reader sees them."""

from __future__ import annotations

import base64
import json
import re
import zlib
from typing import Any

from playwright.sync_api import Locator, Page, expect

from .python_texts import of_any_python
from .readers import until
from .tree import EXAMPLES

TUTORIAL = "docs/tutorial-timer.html"

# The listings of that page that can be run, in their order.
LISTINGS = ["steps/1_class.py", "steps/2_callback.py", "my_robotics_pkg/src/spinner_py_node.py"]

OTHER, TIMER = 1, 2

IN_PYTHON = "div.live:not(.highlight-cpp, .highlight-xml)"

ROS2 = [
    EXAMPLES / "my_robotics_pkg_ros2" / "my_robotics_pkg" / f"spinner_{name}py_node.py"
    for name in ("", "rate_", "param_")
]


class Cell:
    """A listing of the page that can be run, as a reader sees it."""

    def __init__(self, page: Page, index: int, listings: str = IN_PYTHON) -> None:
        self.page = page
        self.element = page.locator(listings).nth(index)
        self.console = self.element.get_by_role("log", name="Console")
        self.status = self.element.get_by_role("status")
        self.plot = self.element.locator("figure:not(.live-made) svg[role=img]")
        self.editor = self.element.get_by_role("textbox", name="Code of")

    def button(self, name: str) -> Locator:
        return self.element.get_by_role("button", name=re.compile(f"^{name} (?!both |with )"))

    def run(self, seconds: float = 2, speed: str = "instantly") -> None:
        self.element.get_by_role("spinbutton").fill(str(seconds))
        self.element.get_by_role("combobox").select_option(speed)
        self.button("Run").click()

    def write(self, text: str) -> None:
        """Replace the code."""
        self.button("Edit").click()
        self.editor.press("Control+a")
        self.page.keyboard.insert_text(text)

    def ends(self, status: str, most: float | None = None) -> str:
        """Wait, for so many ms at most, until the status line begins with these words; the text on the console."""
        expect(self.status).to_have_text(re.compile(f"^{status}"), timeout=most)
        return self.text()

    def text(self) -> str:
        return "".join(self.element.locator(".live-console pre").all_text_contents())

    def marked(self) -> list[str]:
        """The lines on the console that belong to the chosen tick."""
        return self.console.locator(".of-tick").all_text_contents()


def open_exercise(page: Page, address: str, name: str, anchor: str = "") -> Cell:
    """Open the page of an exercise. The cell of its answer."""
    page.goto(f"{address}exercises/{name}.html{anchor}")
    return Cell(page, 0, f"div.live:has([aria-label='Run answer {name}']), div.live.highlight-cpp")


def unfold(page: Page) -> None:
    """Open what is folded."""
    page.locator("details").evaluate_all("all => all.forEach((each) => (each.open = true))")


def open_tutorial(page: Page, address: str) -> None:
    page.goto(address + TUTORIAL)
    page.locator(".sd-tab-label", has_text="Python").first.click()
    unfold(page)


def have_workers(page: Page, count: int) -> None:
    """Wait until a page has so many workers: 1 where the next Python is ready, and no node runs."""
    until(page, lambda: len(page.workers) == count)


def node(body: str) -> str:
    """A node file around some lines."""
    return f'import rospy\n\nrospy.init_node("a_node")\n{body}\n'


def node2(body: str) -> str:
    """The same for ROS 2."""
    return f'import rclpy\nrclpy.init()\nnode = rclpy.create_node("a_node")\n{body}\n'


def _fragment(data: bytes) -> str:
    packed = zlib.compressobj(9, zlib.DEFLATED, -15)
    return "#code=" + base64.urlsafe_b64encode(packed.compress(data) + packed.flush()).decode().rstrip("=")


def link(**changed: Any) -> str:
    return _fragment(json.dumps({"cell": TIMER, "text": "print(1)", "seconds": 2, "args": ""} | changed).encode())


# What the page adds at the end, for a reader who does not know what the error means.
HINTS = (
    "The node had a timer, which was never called",
    "Nothing spun the node",
    "The timer that wakes this Rate was due",
    "A timer passes its callback no",
    "The period of a timer",
    "A field of a message takes values",
    "A parameter keeps the type",
    "Declare a parameter",
    "Call rclpy.init()",
    "Pass the callback itself",
    "A subscription passes",
    "Nothing can have a frequency",
    "The period of a rospy.Timer is a Duration",
    "A subscriber passes",
    "A service passes",
    "Pass a timer the callback",
    "Pass a sub",
    "Pass a service",
)


def lines_of(console: str) -> list[str]:
    """The lines of a console, without addresses and what depends on Python's version: code in tracebacks, messages."""
    text = re.sub(r'^(  File ").*?([^/"]+", line .*)\n(?:    .*\n)*', r"\1\2\n", of_any_python(console), flags=re.M)
    # In a traceback that is logged as a list: the folders, and the marks.
    text = re.sub(r"\\n +[~^]+(?=\\n)", "", re.sub(r"('  File \")[^\"]*/", r"\1", text))
    text = re.sub(r'^  File "threading\.py", .*\n', "", text, flags=re.M)
    text = re.sub(r"^(rosspin: .*?) (was at|had done) .*", r"\1", text, flags=re.M)  # the page has no neighbours there
    text = re.sub(r"\b0x[0-9a-f]+", "0xN", text)
    return [line for line in text.splitlines() if not line.startswith(HINTS)]
