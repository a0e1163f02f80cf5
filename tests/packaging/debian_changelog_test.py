"""A changelog in Debian's format."""

import os
import subprocess
import tempfile
import unittest

import debian_changelog


class DebianChangelog(unittest.TestCase):
    def test_lines(self):
        lines = debian_changelog.text("1.2.3", 0).split("\n")
        self.assertEqual(lines[0], "rubsweep (1.2.3) bookworm; urgency=medium")
        self.assertRegex(lines[4], r"^ -- .+ <\S+@\S+>  Thu, 01 Jan 1970 00:00:00 [-+]0000$")

    def test_date_of_a_commit_is_its_own(self):
        with tempfile.TemporaryDirectory() as top:
            run = lambda *words: subprocess.run(["git", "-C", top, *words], check=True, capture_output=True, env={
                **os.environ, "GIT_COMMITTER_DATE": "@86400 +0000", "GIT_AUTHOR_NAME": "a", "GIT_AUTHOR_EMAIL": "a@b",
                "GIT_COMMITTER_NAME": "a", "GIT_COMMITTER_EMAIL": "a@b"})
            run("init", "-q")
            run("commit", "-q", "--allow-empty", "-m", "first")
            self.assertEqual(debian_changelog.date_of(top), 86400)

    def test_date_without_a_repository(self):
        with tempfile.TemporaryDirectory() as top:
            path = os.path.join(top, "CHANGELOG.md")
            with open(path, "w", encoding="utf-8"):
                pass
            os.utime(path, (1000, 1000))
            self.assertEqual(debian_changelog.date_of(top), 1000)


if __name__ == "__main__":
    unittest.main()
