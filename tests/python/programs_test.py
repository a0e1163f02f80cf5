import os
import signal
import stat
import tempfile
import threading
import time
import unittest
from pathlib import Path
from unittest import mock

from rubsweep.errors import BadInput, RubsweepError
from rubsweep.programs import call, find


class Programs(unittest.TestCase):
    def setUp(self):
        self.directory = tempfile.TemporaryDirectory()
        self.addCleanup(self.directory.cleanup)
        patch = mock.patch.dict(os.environ, RUBSWEEP_PROGRAMS=self.directory.name)
        patch.start()
        self.addCleanup(patch.stop)

    def program(self, text):
        path = Path(self.directory.name) / "rubfake"
        path.write_text("#!/bin/sh\n" + text)
        path.chmod(path.stat().st_mode | stat.S_IXUSR)

    def test_text_and_summary_come_apart(self):
        self.program('echo "motion    synchronous"\necho "{\\"exit_code\\": 0, \\"counts\\": {\\"cells\\": 3}}"')
        answer = call("rubfake", [])
        self.assertEqual(answer.text, "motion    synchronous\n")
        self.assertEqual(answer.summary["counts"], {"cells": 3})

    def test_cells_that_failed_are_an_answer(self):
        self.program("exit 4")
        self.assertEqual(call("rubfake", []).text, "")

    def test_bad_input_has_the_messages_of_the_summary(self):
        self.program('echo "{\\"messages\\": [\\"c.yaml:1:1: kick: missing, allowed: a map\\"]}"\nexit 2')
        with self.assertRaises(BadInput) as raised:
            call("rubfake", [])
        self.assertEqual(raised.exception.key, "kick")

    def test_other_failures_have_what_stood_on_standard_error(self):
        self.program("echo disk full >&2\nexit 3")
        with self.assertRaises(RubsweepError) as raised:
            call("rubfake", [], progress=False)
        self.assertEqual((raised.exception.messages, raised.exception.exit_code), (["disk full"], 3))
        self.assertNotIsInstance(raised.exception, BadInput)

    def test_a_program_that_is_not_there_is_said(self):
        with self.assertRaisesRegex(RubsweepError, "no program rubnone in .*RUBSWEEP_PROGRAMS"):
            find("rubnone")

    def test_an_interrupt_reaches_the_program_and_is_raised_when_it_has_ended(self):
        mark = Path(self.directory.name) / "mark"
        self.program(f"trap 'echo kept >{mark}; exit 130' INT\necho up >{mark}.up\nwhile true; do sleep 0.05; done")

        def interrupt():
            while not Path(f"{mark}.up").exists():
                time.sleep(0.02)
            os.kill(os.getpid(), signal.SIGINT)

        threading.Thread(target=interrupt).start()
        with self.assertRaises(KeyboardInterrupt):
            call("rubfake", [])
        self.assertEqual(mark.read_text(), "kept\n")
