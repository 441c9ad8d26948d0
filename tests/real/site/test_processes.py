"""A site whose pages several processes read is the one that a single process makes."""

from __future__ import annotations

from pathlib import Path

from tests.helpers.small_sites import build, listed
from tests.helpers.small_sites import site as small_site

PATH = """

.. list-table:: A way
   :name: way
   :class: path

   * - 5
     - :doc:`notebooks/book`
   * - 5
     - :doc:`index`

It takes :minutes:`notebooks/book` min.
"""

MORE = """extensions += ["rosspin.site.times", "rosspin.site.paths"]
html_theme = "basic"
"""

STALE = {"default": [("doctest", "", ">>> 1 + 1\n3")]}


def test_two_processes_read_what_one_reads(tmp_path: Path) -> None:
    made = []
    for jobs in ("-j1", "-j2"):
        folder = small_site(tmp_path / jobs / "site", STALE)
        conf, index, book = folder / "conf.py", folder / "index.rst", folder / "notebooks/book.md"
        conf.write_text(conf.read_text() + MORE)
        index.write_text(index.read_text() + PATH)
        book.write_text(f"{book.read_text()}\n**Time**: 50 minutes.\n")
        run = build(folder, "html", jobs)
        pages = [(folder / f"build/html/{name}.html").read_text() for name in ("index", "notebooks/book")]
        made.append((run.returncode, listed(run), pages))
    one, two = made
    assert one == two
    status, entries, (index_page, book_page) = two
    assert status == 1 and len(entries) == 3
    assert "It takes 5 min." in index_page and "A way</a>, 1 of 2." in book_page
