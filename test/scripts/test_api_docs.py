#!/usr/bin/env python3
"""scripts/api_docs makes pages of the headers, and nothing in these is doubtful to doxygen."""

import re
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

CHECKOUT = Path(__file__).resolve().parents[2]


@unittest.skipUnless(shutil.which("doxygen"), "doxygen is not installed")
class ApiDocs(unittest.TestCase):
    def test_the_headers_are_documented_without_a_warning(self):
        with tempfile.TemporaryDirectory(prefix="map_matcher_") as directory:
            done = subprocess.run([CHECKOUT / "scripts/api_docs", directory], stdout=subprocess.PIPE,
                                  stderr=subprocess.STDOUT, text=True, check=False)
            self.assertEqual(0, done.returncode, done.stdout)
            pages = Path(directory) / "html"
            first = (pages / "index.html").read_text(encoding="utf-8")
            for name in re.findall(r"map_matcher::[\w:]+::\w+", (CHECKOUT / "docs/api.md").read_text(encoding="utf-8")):
                with self.subTest(f"the first page links to {name}"):
                    self.assertRegex(first, rf'<a class="el" href="[^"]+"[^>]*>{name}(?:\(\))?</a>')


if __name__ == "__main__":
    unittest.main()
