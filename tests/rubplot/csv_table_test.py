import hashlib
import os

from files import FileTest
from rubplot import csv_table
from rubplot.configuration import read_configuration
from rubplot.failure import Failure


class ReadTable(FileTest):
    def rows(self, text, *needed):
        return list(csv_table.read_table(self.write("t.csv", text), *needed))

    def expect_refusal(self, message, text, *needed):
        with self.assertRaises(csv_table.TableError) as caught:
            self.rows(text, *needed)
        self.assertEqual(str(caught.exception), self.path("t.csv") + message)

    def test_names_cells_by_the_header_wherever_their_column_is(self):
        self.assertEqual(self.rows("# digest\na,b\n\n1,2\n# end\n3,\n", "b"), [{"a": "1", "b": "2"}, {"a": "3", "b": ""}])
        self.assertEqual(self.rows("b,a\n2,1\n", "b"), [{"a": "1", "b": "2"}])

    def test_takes_lines_of_other_systems_and_quoted_cells(self):
        self.assertEqual(self.rows('a,b\r\n"x, ""y""",z\r\n'), [{"a": 'x, "y"', "b": "z"}])

    def test_names_file_and_line_of_what_is_wrong(self):
        self.expect_refusal(":2: no column 'c'", "# x\na,b\n1,2\n", "a", "c")
        self.expect_refusal(":3: 1 cells, 2 columns", "a,b\n1,2\n3\n")
        self.expect_refusal(":2: 3 cells, 2 columns", "a,b\n1,2,3\n")
        self.expect_refusal(": no header", "# only comments\n")

    def test_reads_row_by_row(self):
        rows = csv_table.read_table(self.write("t.csv", "a,b\n1,2\n3\n"))
        self.assertEqual(next(rows)["a"], "1")


class Checksum(FileTest):
    def summed(self):
        other_lines = "# rubline 1\n# digest x\n# format 1\n", "a,b\n1,2\n"
        total = hashlib.sha256("".join(other_lines).encode()).hexdigest()
        return f"# sha256 {total}\n".join(other_lines)

    def test_ends_of_lines_of_another_system_change_nothing(self):
        whole = self.summed().replace("\n", "\r\n")
        self.assertEqual(list(csv_table.read_table(self.write("t.csv", whole))), [{"a": "1", "b": "2"}])
        with self.assertRaises(csv_table.TableError):
            list(csv_table.read_table(self.write("t.csv", whole.replace("1,2", "1,3"))))

    def test_a_table_that_must_have_one_is_refused_without(self):
        bare = "".join(line for line in self.summed().splitlines(True) if not line.startswith("# sha256"))
        with self.assertRaises(csv_table.TableError):
            list(csv_table.read_table(self.write("t.csv", bare)))
        list(csv_table.read_table(self.write("t.partial.csv", bare)))  # one that grows has none

    def test_a_pipe_is_refused_and_not_waited_for(self):
        os.mkfifo(self.path("t.csv"))
        for read in (csv_table.head, csv_table.require_whole, read_configuration):
            with self.assertRaises(Failure):
                read(self.path("t.csv"))

    def test_all_lines_but_its_own_are_in_the_sum(self):
        other_lines = "# rubline 1\n# digest x\n", "a,b\n1,2\n"
        total = hashlib.sha256("".join(other_lines).encode()).hexdigest()
        whole = f"# sha256 {total}\n".join(other_lines)
        self.assertEqual(list(csv_table.read_table(self.write("t.csv", whole))), [{"a": "1", "b": "2"}])
        for changed in (whole.replace("1,2", "1,3"), whole[:-1], whole.replace("digest x", "digest y"), whole[:60]):
            with self.assertRaisesRegex(csv_table.TableError, "t.csv: is not as it was written"):
                next(csv_table.read_table(self.write("t.csv", changed)))


class Numbers(FileTest):
    def test_an_empty_cell_is_none_and_words_are_refused(self):
        row = {"a": "-1e-3", "b": "", "c": "1;2"}
        self.assertEqual(csv_table.number(row, "a"), -1e-3)
        self.assertIsNone(csv_table.number(row, "b"))
        with self.assertRaisesRegex(csv_table.TableError, "'c': '1;2' is no number"):
            csv_table.number(row, "c")

    def test_between_holds_both_ends(self):
        rows = [{"x": str(x)} for x in range(6)]
        self.assertEqual([row["x"] for row in csv_table.between(rows, "x", 2, 4)], ["2", "3", "4"])
        self.assertEqual([row["x"] for row in csv_table.between(rows, "x", None, 1)], ["0", "1"])
