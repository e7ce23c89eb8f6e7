#!/usr/bin/env python3
"""Holds README.md and docs/ true: links, names of files, generated pages, and what they list of interfaces."""

import re
import subprocess
import unittest
from pathlib import Path

CHECKOUT = Path(__file__).resolve().parents[2]
README_LINES = 200
USERS_PARAMETERS = range(8, 13)  # about ten
GENERATED = CHECKOUT / "docs/evaluation"  # by scripts/evaluate


def documents():
    """All pages that people write or that are made of the sources."""
    pages = [CHECKOUT / "README.md", CHECKOUT / "CONTRIBUTING.md", *sorted((CHECKOUT / "docs").rglob("*.md"))]
    return [page for page in pages if GENERATED not in page.parents]


def name_of(page):
    return str(page.relative_to(CHECKOUT))


def text_of(path):
    return (CHECKOUT / path).read_text(encoding="utf-8")


def without_blocks(text):
    return re.sub(r"(?ms)^```.*?^```$", "", text)


def links_of(page):
    """Targets of links and pictures that are in this repository."""
    targets = re.findall(r"\]\(([^)\s]+)\)", without_blocks(page.read_text(encoding="utf-8")))
    return [target for target in targets if not re.match(r"[a-z]+:", target)]


def anchors_of(page):
    """The anchors of a page's headings, as GitHub makes them."""
    headings = re.findall(r"(?m)^#+ (.*)$", without_blocks(page.read_text(encoding="utf-8")))
    return {re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-") for heading in headings}


def first_cells(text):
    """What stands in backticks in the first cells of the rows of all tables."""
    cells = [line.split("|")[1] for line in text.splitlines() if line.startswith("| ")]
    return {name for cell in cells for name in re.findall(r"`([^`]+)`", cell)}


def part(text, heading):
    """What stands under a heading, up to the next one of its level or above."""
    level = heading.split(" ")[0]
    begin = text.index(f"\n{heading}\n") + len(heading) + 2
    end = re.search(rf"(?m)^#{{1,{len(level)}}} ", text[begin:])
    return text[begin:begin + end.start()] if end else text[begin:]


class Pages(unittest.TestCase):
    def test_each_relative_link_leads_somewhere(self):
        for page in documents():
            for target in links_of(page):
                path, _, anchor = target.partition("#")
                linked = (page.parent / path).resolve() if path else page
                with self.subTest(f"{name_of(page)}: {target}"):
                    self.assertTrue(linked.exists())
                    if anchor and linked.suffix == ".md":
                        self.assertIn(anchor, anchors_of(linked))

    def test_each_page_is_linked_from_the_readme_or_from_a_page_that_is(self):
        reached, waiting = set(), [CHECKOUT / "README.md"]
        while waiting:
            page = waiting.pop()
            if page in reached:
                continue
            reached.add(page)
            linked = [(page.parent / target.partition("#")[0]).resolve() for target in links_of(page)]
            waiting += [path for path in linked if path.suffix == ".md" and path.exists()]
        self.assertEqual([], [name_of(page) for page in documents() if page not in reached])

    def test_each_picture_is_shown_somewhere(self):
        shown = {(page.parent / target).resolve() for page in documents() for target in links_of(page)}
        pictures = sorted((CHECKOUT / "docs/images").iterdir())
        self.assertEqual([], [name_of(picture) for picture in pictures if picture not in shown])

    def test_each_file_that_is_named_is_there(self):
        for page in documents():
            for path in re.findall(r"`((?:config|include|launch|scripts|src|test)/[\w./]+)(?: [^`]*)?`",
                                   page.read_text(encoding="utf-8")):
                with self.subTest(f"{name_of(page)}: {path}"):
                    self.assertTrue((CHECKOUT / path).exists())

    def test_each_function_that_is_named_is_there(self):
        sources = "".join(path.read_text(encoding="utf-8") for folder in ("include", "src")
                          for path in (CHECKOUT / folder).rglob("*.[ch]pp"))
        for page in documents():
            for name in re.findall(r"`(?:\w+::)*(\w+)\(\)`", page.read_text(encoding="utf-8")):
                with self.subTest(f"{name_of(page)}: {name}()"):
                    self.assertRegex(sources, rf"\b{name}\(")

    def test_no_page_knows_the_machine_that_it_was_written_on(self):
        for page in documents():
            with self.subTest(name_of(page)):
                self.assertNotRegex(page.read_text(encoding="utf-8"), r"(?<![\w.$])/(?:home|root|work|tmp|mnt|srv)/")

    def test_the_readme_is_short(self):
        self.assertLessEqual(len(text_of("README.md").splitlines()), README_LINES)


class Parameters(unittest.TestCase):
    def test_the_page_says_what_the_parameter_files_say(self):
        done = subprocess.run([CHECKOUT / "scripts/parameter_page", "--check"], stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, text=True, check=False)
        self.assertEqual(0, done.returncode, done.stdout)

    def test_the_page_has_each_parameter_once(self):
        page = text_of("docs/parameters.md")
        for path in sorted((CHECKOUT / "config").glob("*.yaml")):
            if f"\n## {path.stem}\n" not in page:
                continue
            names = re.findall(r"(?m)^(\w+):", path.read_text(encoding="utf-8"))
            rows = re.findall(r"(?m)^\| `~(\w+)` \|", part(page, f"## {path.stem}"))
            with self.subTest(path.name):
                self.assertEqual(sorted(names), sorted(rows))

    def test_about_ten_are_for_users_and_the_readme_has_those(self):
        section = part(part(text_of("docs/parameters.md"), "## map_matcher"), "### For users")
        users = re.findall(r"(?m)^\| `~(\w+)` \|", section)
        in_readme = re.findall(r"(?m)^\| `~(\w+)` \|", text_of("README.md"))

        self.assertIn(len(users), USERS_PARAMETERS)
        self.assertEqual(sorted(users), sorted(in_readme))


class Interfaces(unittest.TestCase):
    def test_each_topic_and_service_of_the_matcher_is_described(self):
        header = text_of("include/map_matcher/ros/common/names.hpp")
        names = set(re.findall(r'constexpr const char\* k\w+ = "(\w+)";', header)) - {"map_matcher"}
        described = {name.lstrip("~") for name in first_cells(part(text_of("docs/interfaces.md"), "## map_matcher"))}

        self.assertGreater(len(names), 10)
        self.assertEqual(set(), names - described)

    def test_each_topic_that_rviz_shows_is_described(self):
        shown = set(re.findall(r"(?m)^ +(?:Marker )?Topic: ([\w/]+)$", text_of("config/map_matcher.rviz")))
        described = {name.lstrip("~/") for page in ("docs/interfaces.md", "docs/tools.md", "docs/robots.md")
                     for name in re.findall(r"`([\w/~]+)`", text_of(page))}

        self.assertGreater(len(shown), 10)
        self.assertEqual(set(), {topic for topic in shown if not any(
            name in described for name in (topic, topic.split("/")[-1], topic.replace("_scrubbed", "")))})

    def test_each_topic_and_service_of_the_readme_is_one(self):
        described = first_cells(text_of("docs/interfaces.md"))
        listed = first_cells(part(text_of("README.md"), "## What it takes and gives"))
        names = {name for name in listed if not name.startswith("~") and "->" not in name}

        self.assertEqual(set(), names - described)

    def test_each_status_and_state_is_explained(self):
        message = text_of("msg/MapMatch.msg")
        constants = re.findall(r"(?m)^uint8 ([A-Z_]+) = \d+", message)
        states = constants[constants.index("SEARCHING"):]
        statuses = {name.lower() for name in constants[:constants.index("SEARCHING")]}
        in_readme = first_cells(part(text_of("README.md"), "## It says X, do Y"))

        self.assertEqual(statuses, statuses & first_cells(part(text_of("docs/tuning.md"), "## It says")))
        self.assertEqual({name.lower() for name in states},
                         first_cells(part(text_of("docs/judgement.md"), "## From map to map")) & {
                             name.lower() for name in states})
        self.assertEqual(set(), in_readme - statuses)

    def test_each_kind_of_evidence_is_explained(self):
        sources = "".join(path.read_text(encoding="utf-8") for path in (CHECKOUT / "src/belief").glob("*.cpp"))
        kinds = set(re.findall(r'(?:Evidence \w+|return ){"(\w+)"', sources)) | set(
            re.findall(r'evidence\.name = "(\w+)"', sources))
        explained = first_cells(part(text_of("docs/interfaces.md"), "### What map_match says"))

        self.assertGreater(len(kinds), 8)
        self.assertEqual(set(), kinds - explained)

    def test_each_launch_file_is_described(self):
        page = part(text_of("docs/robots.md"), "## All launch files")
        names = {path.name for path in (CHECKOUT / "launch").glob("*.launch")}
        self.assertEqual(set(), {name for name in names if f"[{name}](../launch/{name})" not in page})

    def test_each_program_is_described(self):
        page = first_cells(part(text_of("docs/tools.md"), "## Command line"))
        programs = set(re.findall(r"map_matcher_add_tool\((\w+)", text_of("CMakeLists.txt"))) - {"name"}
        self.assertGreater(len(programs), 5)
        self.assertEqual(set(), programs - page)


if __name__ == "__main__":
    unittest.main()
