#!/usr/bin/env python3
"""Every link and picture in the documents that names a file or a heading of this package finds it."""
import re
import unittest
from pathlib import Path

CHECKOUT = Path(__file__).resolve().parents[2]
DOCUMENTS = [*CHECKOUT.glob("*.md"), *CHECKOUT.glob("docs/**/*.md")]
MOST_LINES = 200  # of README.md, which is to be read at one go


def anchors_of(document):
    """The names that headings of a page are linked by."""
    headings = re.findall(r"^#+ (.*)$", document.read_text(encoding="utf-8"), re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", heading).strip().lower().replace(" ", "-") for heading in headings}


class Links(unittest.TestCase):
    def test_lead_somewhere(self):
        self.assertGreater(len(DOCUMENTS), 5)
        for document in DOCUMENTS:
            for target in re.findall(r"\]\(([^)\s]+)\)", document.read_text(encoding="utf-8")):
                if re.match(r"[a-z]+:", target):
                    continue
                path, _, anchor = target.partition("#")
                page = (document.parent / path).resolve() if path else document
                self.assertTrue(page.exists(), f"{document}: there is no {path}")
                if anchor:
                    self.assertIn(anchor, anchors_of(page), f"{document}: {target}")

    def test_reach_every_page(self):
        reached, waiting = set(), [CHECKOUT / "README.md"]
        while waiting:
            page = waiting.pop()
            if page in reached or page.suffix != ".md" or not page.exists():
                continue
            reached.add(page)
            waiting += [(page.parent / target.partition("#")[0]).resolve()
                        for target in re.findall(r"\]\(([^)\s]+)\)", page.read_text(encoding="utf-8"))]
        self.assertEqual(set(DOCUMENTS) - reached, set())

    def test_readme_is_short(self):
        self.assertLessEqual(len((CHECKOUT / "README.md").read_text(encoding="utf-8").splitlines()), MOST_LINES)


if __name__ == "__main__":
    unittest.main()
