import contextlib
import io
import unittest
from unittest import mock

import insert_tables
from files import FileTest
from rubplot.failure import Failure

PAGE = """Before.

<!-- Made by echo one,
     commit 1234567, on 2 x a processor -->
| a |
<!-- End of what is made. -->

<!-- Made by echo two | cat,
     commit 1234567, on 2 x a processor -->
<!-- End of what is made. -->
After.
"""
MADE = {"echo one": "| a |\n", "echo two | cat": "| b |\n"}


class InsertTables(FileTest):
    def test_tables_stand_between_their_lines_with_commit_and_machine(self):
        changed = insert_tables.with_tables(PAGE, MADE.get, "", "abc", "a host")
        self.assertIn("<!-- Made by echo two | cat,\n     commit abc, on a host -->\n| b |\n<!-- End of what is made. -->\nAfter.", changed)
        self.assertTrue(changed.startswith("Before.\n\n<!-- Made by echo one,\n     commit abc, on a host -->\n| a |\n<!-- End"))

    def test_other_commands_than_those_asked_for_keep_table_and_commit(self):
        changed = insert_tables.with_tables(PAGE, MADE.get, "two", "abc", "a host")
        self.assertIn("<!-- Made by echo one,\n     commit 1234567, on 2 x a processor -->\n| a |\n", changed)
        self.assertIn("| b |", changed)

    def test_stale_tables_are_named(self):
        self.assertEqual(insert_tables.stale_tables(PAGE, MADE.get, ""), ["echo two | cat"])
        self.assertEqual(insert_tables.stale_tables(PAGE, MADE.get, "one"), [])

    def test_commands_that_fail_or_print_no_table_end_it(self):
        self.assertEqual(insert_tables.printed("printf '| a |\\n'"), "| a |\n")
        self.assertEqual(insert_tables.printed("printf '| %s %s |\\n'\n     one two"), "| one two |\n")
        for command in ("false", "echo no table", "false | printf '| a |\\n'"):
            with self.assertRaises(Failure):
                insert_tables.printed(command)

    def test_documents_are_written_and_checked(self):
        path = self.write("page.md", PAGE.replace("echo one", "printf '| c |\\n'").replace("echo two | cat", "printf '| d |\\n'"))
        with contextlib.redirect_stdout(io.StringIO()) as said:
            self.assertEqual(insert_tables.main(["--check", path]), 1)
        self.assertEqual(said.getvalue().count("is not what it prints now"), 2)
        with mock.patch.object(insert_tables, "this_commit", return_value="abc"):
            self.assertEqual(insert_tables.main([path]), 0)
        self.assertEqual(insert_tables.main(["--check", path]), 0)
        with open(path, encoding="utf-8") as file:
            self.assertIn("| d |", file.read())


if __name__ == "__main__":
    unittest.main()
