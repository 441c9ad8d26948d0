"""What the site ships of others comes with their licences, with their whole texts."""

from __future__ import annotations

import re
from pathlib import Path

# How each of them ends.
ENDS = {
    "Apache-2.0": "but only in their entirety and only with respect to the Combined Software.",
    "MIT": "IN THE SOFTWARE.",
    "MPL-2.0": 'is "Incompatible With Secondary Licenses", as defined by the Mozilla Public License, v. 2.0.',
    "PSF-2.0": "WITH THE USE OR PERFORMANCE OF THIS SOFTWARE.",
}


def test_each_package_has_the_whole_text(site: Path) -> None:
    text = (site / "_static/live/licences.txt").read_text(encoding="utf-8")
    parts = re.split(r"^((?:@?[\w./-]+ [\d.]+|LLVM|musl|Python|PyYAML): [\w.-]+)\n\n", text, flags=re.M)[1:]
    found = dict(zip(parts[::2], parts[1::2], strict=True))
    names = {re.split("[: ]", name)[0] for name in found}
    assert {"LLVM", "musl", "pyodide", "Python", "PyYAML", "@codemirror/view"} <= names
    for name, licence in found.items():
        assert " ".join(licence.split()).endswith(ENDS[name.rpartition(": ")[2]]), name
