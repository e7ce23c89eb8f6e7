#!/usr/bin/env python3
"""Runs the test cases of one file and writes their results as the other tests write theirs.

usage: run_unittest.py TEST_FILE RESULT_FILE     (Python file with unittest.TestCases; XML file)
"""

import importlib.util
import sys
import unittest
import xml.etree.ElementTree as ElementTree
from pathlib import Path


class Result(unittest.TextTestResult):
    """Remembers each case, with what became of it."""

    def __init__(self, *arguments):
        super().__init__(*arguments)
        self.cases = {}

    def startTest(self, test):
        super().startTest(test)
        self.cases[test.id()] = None

    def addError(self, test, err):
        super().addError(test, err)
        self.cases[test.id()] = "error"

    def addFailure(self, test, err):
        super().addFailure(test, err)
        self.cases[test.id()] = "failure"

    def addSubTest(self, test, subtest, err):
        super().addSubTest(test, subtest, err)
        if err is not None:
            self.cases[test.id()] = "failure"

    def addSkip(self, test, reason):
        super().addSkip(test, reason)
        self.cases[test.id()] = "skipped"


def write(cases, path):
    suite = ElementTree.Element("testsuite", tests=str(len(cases)))
    for identity, outcome in cases.items():
        class_name, name = identity.rsplit(".", 1)
        case = ElementTree.SubElement(suite, "testcase", classname=class_name, name=name)
        if outcome:
            ElementTree.SubElement(case, outcome)
    ElementTree.ElementTree(suite).write(path)


def main(test_file, result_file):
    specification = importlib.util.spec_from_file_location(Path(test_file).stem, test_file)
    module = importlib.util.module_from_spec(specification)
    specification.loader.exec_module(module)
    suite = unittest.defaultTestLoader.loadTestsFromModule(module)
    result = unittest.TextTestRunner(sys.stdout, verbosity=2, resultclass=Result).run(suite)
    write(result.cases, result_file)
    return 0 if result.wasSuccessful() else 1


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    sys.exit(main(*sys.argv[1:]))
