import contextlib
import io
import sys
import unittest
from unittest import mock

import command
from rubplot.csv_table import TableError


class RunProgram(unittest.TestCase):
    def outcome(self, main, *arguments, **limits):
        said = io.StringIO()
        with mock.patch.object(sys, "argv", ["program", *arguments]), contextlib.redirect_stderr(said):
            with self.assertRaises(SystemExit) as caught:
                command.run_program(main, usage="name.sh FILE", **limits)
        return caught.exception.code, said.getvalue()

    def test_wrong_number_of_arguments_is_a_usage_error(self):
        for arguments in ((), ("a", "b")):
            code = self.outcome(lambda _: None, *arguments, least=1, most=1)
            self.assertEqual(code, (1, "name.sh: usage: name.sh FILE\n"))

    def test_what_cannot_be_used_is_said_in_one_line(self):
        def fail_with(error):
            def main(_):
                raise error

            return main

        self.assertEqual(self.outcome(fail_with(command.Failure("no run"))), (3, "name.sh: no run\n"))
        self.assertEqual(self.outcome(fail_with(TableError("t.csv:1: odd"))), (3, "name.sh: t.csv:1: odd\n"))
        missing = FileNotFoundError(2, "No such file or directory", "t.csv")
        self.assertEqual(self.outcome(fail_with(missing)), (3, "name.sh: cannot use t.csv: No such file or directory\n"))

    def test_passes_the_arguments_on(self):
        found = []
        with mock.patch.object(sys, "argv", ["program", "a", "b"]):
            command.run_program(found.extend, usage="name.sh FILE...")
        self.assertEqual(found, ["a", "b"])
