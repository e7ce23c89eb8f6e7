#!/usr/bin/env python3
"""scripts/screenshots leaves a picture of what rviz shows, and nothing that runs."""

import os
import shutil
import signal
import struct
import subprocess
import tempfile
import unittest
from pathlib import Path

CHECKOUT = Path(__file__).resolve().parents[2]
BUILD = os.environ.get("MAP_MATCHER_BUILD")
NEEDED = ("rviz", "Xvfb", "import", "convert")
DEADLINE = 400  # [s]


def processes_of(directory):
    """Numbers of the processes that were started with this TMPDIR."""
    found = []
    for path in Path("/proc").glob("[0-9]*/environ"):
        try:
            if f"TMPDIR={directory}\0".encode() in path.read_bytes():
                found.append(path.parent.name)
        except OSError:  # it has ended, or is somebody else's
            continue
    return found


@unittest.skipUnless(all(map(shutil.which, NEEDED)), "rviz, Xvfb or ImageMagick is not installed")
@unittest.skipUnless(BUILD, "there is no build that it could use")
class Screenshots(unittest.TestCase):
    def setUp(self):
        directory = tempfile.TemporaryDirectory(prefix="map_matcher_")
        self.addCleanup(directory.cleanup)
        self.temporary = Path(directory.name) / "tmp"
        self.pictures = Path(directory.name) / "pictures"
        self.temporary.mkdir()
        self.pictures.mkdir()
        self.script = subprocess.Popen(
            [CHECKOUT / "scripts/screenshots", f"{BUILD}/.install/setup.bash", self.pictures],
            env={**os.environ, "TMPDIR": str(self.temporary)}, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
            text=True, start_new_session=True,
            preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL))  # also where these tests ignore it

    def assert_nothing_is_left(self):
        self.assertEqual(processes_of(self.temporary), [])
        self.assertEqual(list(self.temporary.iterdir()), [])

    def test_leaves_a_small_picture_of_a_robot_that_is_localized(self):
        said, _ = self.script.communicate(timeout=DEADLINE)

        self.assertEqual(self.script.returncode, 0, said)
        self.assertIn("localized: ", said)
        self.assertEqual([path.name for path in self.pictures.iterdir()], ["rviz.png"])
        picture = (self.pictures / "rviz.png").read_bytes()
        self.assertLess(len(picture), 300000)
        self.assertEqual(picture[:4], b"\x89PNG")
        self.assertGreater(min(struct.unpack(">II", picture[16:24])), 300)
        self.assert_nothing_is_left()

    def test_ends_all_that_it_started_when_it_is_interrupted(self):
        said = ""
        while "sets out" not in said:
            line = self.script.stdout.readline()
            self.assertTrue(line, said)
            said += line

        os.killpg(self.script.pid, signal.SIGINT)  # as a terminal does

        said += self.script.communicate(timeout=DEADLINE)[0]
        self.assertEqual(self.script.returncode, 130, said)
        self.assertEqual(list(self.pictures.iterdir()), [])
        self.assert_nothing_is_left()


if __name__ == "__main__":
    unittest.main()
