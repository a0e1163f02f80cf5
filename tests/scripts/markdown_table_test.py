import unittest

import markdown_table


class MarkdownTable(unittest.TestCase):
    def test_rows_stand_below_headings_and_bars_are_escaped(self):
        self.assertEqual(markdown_table.table(["a", "b"], [[1, "|x|"], ["", 2]]),
                         "| a | b |\n| --- | --- |\n| 1 | \\|x\\| |\n| | 2 |\n")

    def test_columns_of_lines_that_match_are_taken_by_number(self):
        text = "map  touched  error\nconfigs/benchmark/one_side.yaml  6  1e-12\nnothing\nconfigs/minimal.yaml 5 2e-12\n"
        self.assertEqual(markdown_table.of_columns(text, "^configs", [("map", 1), ("error", 3)]),
                         "| map | error |\n| --- | --- |\n| `benchmark/one_side` | 1e-12 |\n| `minimal` | 2e-12 |\n")


if __name__ == "__main__":
    unittest.main()
