#!/usr/bin/env python3
"""scripts/install_dependencies, with the real apt and dpkg, on an archive and a system that are made for each test."""

import hashlib
import os
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

SCRIPTS = Path(__file__).resolve().parents[2] / "scripts"
AS_ROOT = [] if os.geteuid() == 0 else ["unshare", "--map-root-user"]


def can_be_root():
    return subprocess.run([*AS_ROOT, "true"], stderr=subprocess.DEVNULL, check=False).returncode == 0


class System:
    """A directory with an archive of packages, and a root that apt and dpkg take for the machine's."""

    def __init__(self, directory):
        self.directory = directory
        self.archive = directory / "archive"
        self.admin = directory / "root/var/lib/dpkg"
        for path in (self.archive, self.admin / "info", self.admin / "updates", directory / "scripts",
                     directory / "root/etc/apt/preferences.d", directory / "root/var/lib/apt/lists/partial",
                     directory / "root/var/cache/apt/archives/partial"):
            path.mkdir(parents=True)
        (self.admin / "status").touch()
        (self.archive / "Packages").touch()
        (directory / "root/etc/apt/sources.list").write_text(f"deb [trusted=yes] file:{self.archive} ./\n")
        self.configuration = directory / "apt.conf"
        self.configuration.write_text(f"""
            Dir "{directory}/root";
            Dir::State::status "{self.admin}/status";
            APT::Sandbox::User "root";
            Dpkg::Options {{ "--root={directory}/root"; "--force-unsafe-io"; }};
        """)
        for name in ("common.bash", "install_dependencies"):
            shutil.copy(SCRIPTS / name, directory / "scripts")

    def add_to_archive(self, name, depends=""):
        """A package that holds nothing."""
        control = f"Package: {name}\nVersion: 1\nArchitecture: all\nMaintainer: nobody <nobody@example>\n"
        control += f"Depends: {depends}\n" if depends else ""
        control += "Description: for a test\n"
        tree = self.directory / "tree" / name / "DEBIAN"
        tree.mkdir(parents=True)
        (tree / "control").write_text(control)
        package = self.archive / f"{name}.deb"
        subprocess.run(["dpkg-deb", "--root-owner-group", "--build", tree.parent, package], check=True,
                       stdout=subprocess.DEVNULL)
        content = package.read_bytes()
        with (self.archive / "Packages").open("a") as index:
            index.write(f"{control}Filename: ./{name}.deb\nSize: {len(content)}\n"
                        f"SHA256: {hashlib.sha256(content).hexdigest()}\n\n")

    def write_table(self, *lines):
        """Of lines "group name" or "group name ? loss"; the names are those of every system."""
        rows = [line.split(" ", maxsplit=2) for line in lines]
        (self.directory / "scripts/packages.txt").write_text(
            "".join(f"{group} {name} {name} {name} {' '.join(rest)}\n" for group, name, *rest in rows))

    def run(self, program, *arguments):
        environment = {**os.environ, "APT_CONFIG": str(self.configuration), "DPKG_ADMINDIR": str(self.admin)}
        return subprocess.run([*AS_ROOT, program, *arguments], env=environment, stdin=subprocess.DEVNULL,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)

    def install_dependencies(self, *groups):
        return self.run(self.directory / "scripts/install_dependencies", *groups)

    def installed(self):
        return self.run("dpkg-query", "-W", "-f", "${Package} ").stdout.split()


@unittest.skipUnless(can_be_root(), "installing needs root, or a user namespace")
class InstallDependencies(unittest.TestCase):
    def setUp(self):
        directory = tempfile.TemporaryDirectory(prefix="map_matcher_")
        self.addCleanup(directory.cleanup)
        self.system = System(Path(directory.name))

    def test_installs_the_packages_of_the_groups_asked_for(self):
        for name in ("compiler", "tester"):
            self.system.add_to_archive(name)
        self.system.write_table("build compiler", "test tester")

        run = self.system.install_dependencies("build")

        self.assertEqual(run.returncode, 0, run.stdout)
        self.assertEqual(self.system.installed(), ["compiler"])

    def test_names_what_apt_does_not_know_and_installs_the_others(self):
        self.system.add_to_archive("compiler")
        self.system.write_table("build compiler", "build misspelt", "test unheard-of")

        run = self.system.install_dependencies()

        self.assertEqual(run.returncode, 1, run.stdout)
        self.assertIn("2 packages that are required are missing", run.stdout)
        self.assertIn("misspelt, of group build: apt does not know it", run.stdout)
        self.assertIn("unheard-of, of group test: apt does not know it", run.stdout)
        self.assertEqual(self.system.installed(), ["compiler"])

    def test_names_what_apt_cannot_install_and_installs_the_others(self):
        self.system.add_to_archive("compiler")
        self.system.add_to_archive("library", depends="left-the-archive")
        self.system.write_table("build compiler", "build library")

        run = self.system.install_dependencies()

        self.assertEqual(run.returncode, 1, run.stdout)
        self.assertIn("1 packages that are required are missing", run.stdout)
        self.assertIn("library, of group build: apt cannot install it", run.stdout)
        self.assertEqual(self.system.installed(), ["compiler"])

    def test_tells_what_there_is_not_without_a_package_that_may_be_missing(self):
        self.system.add_to_archive("compiler")
        self.system.write_table("build compiler", "build mapper|old-mapper ? session maps")

        run = self.system.install_dependencies()

        self.assertEqual(run.returncode, 0, run.stdout)
        self.assertIn("missing: mapper or old-mapper (apt does not know it); there will be no: session maps",
                      run.stdout)
        self.assertEqual(self.system.installed(), ["compiler"])

    def test_takes_the_first_alternative_that_apt_knows(self):
        for name in ("older", "oldest"):
            self.system.add_to_archive(name)
        self.system.write_table("build newest|older|oldest")

        run = self.system.install_dependencies()

        self.assertEqual(run.returncode, 0, run.stdout)
        self.assertEqual(self.system.installed(), ["older"])

    def test_leaves_an_installed_alternative_alone(self):
        for name in ("older", "oldest"):
            self.system.add_to_archive(name)
        self.system.write_table("build oldest")
        self.system.install_dependencies()
        self.system.write_table("build older|oldest")

        run = self.system.install_dependencies()

        self.assertEqual(run.returncode, 0, run.stdout)
        self.assertEqual(self.system.installed(), ["oldest"])

    def test_updates_the_package_lists_when_they_lack_a_package(self):
        self.system.add_to_archive("compiler")
        self.system.write_table("build compiler")
        self.system.install_dependencies()
        self.system.add_to_archive("newcomer")
        self.system.write_table("build newcomer")

        run = self.system.install_dependencies()

        self.assertEqual(run.returncode, 0, run.stdout)
        self.assertEqual(self.system.installed(), ["compiler", "newcomer"])

    def test_refuses_a_group_that_there_is_not(self):
        self.system.write_table("build compiler")

        run = self.system.install_dependencies("buidl")

        self.assertEqual(run.returncode, 1)
        self.assertIn("there is no group 'buidl', expected build, run, test, lint, docs or screenshots", run.stdout)
