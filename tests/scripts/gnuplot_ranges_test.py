"""What stats counts lies inside the ranges of the axes: a range that an earlier panel left behind would hide a part of the
data. Reads the scripts as text."""

import glob
import os
import re
import unittest

SCRIPTS = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../scripts")
_FIXES = re.compile(r"\bset [xy]range \[(?!\*:\*\])|\bplot *\[")
_FREES = re.compile(r"\bset autoscale\b|\breset\b|@clear_panel\b")
_STATS = re.compile(r"^\s*(if \([^{]*\) \{ )?stats ")


def hidden(lines):
    """The numbers of the lines with a stats that the ranges of a panel may narrow. A loop's body is read twice: what its
    end leaves behind is there when it begins again."""
    found = set()
    fixed = False
    once = [(number, line) for number, line in enumerate(lines, 1) if not line.lstrip().startswith("#")]
    first = next((i for i, (_, line) in enumerate(once) if line.startswith("do for") and line.rstrip().endswith("{")), len(once))
    for number, line in [*once, *once[first:]]:
        if line.startswith("clear_panel ="):
            continue
        if fixed and _STATS.match(line):
            found.add(number)
        if _FREES.search(line):
            fixed = False
        if _FIXES.search(line):
            fixed = True
    # Outside of every loop a line is passed once.
    return sorted(found - _unrepeated(once, first))


def _unrepeated(lines, first):
    """The lines behind the first loop that stand in none."""
    depth, outside = 0, set()
    for number, line in lines[first:]:
        if depth == 0 and not line.rstrip().endswith("{"):
            outside.add(number)
        depth += line.count("{") - line.count("}")
    return outside


class Ranges(unittest.TestCase):
    def test_no_script_counts_inside_the_range_of_another_panel(self):
        scripts = sorted(glob.glob(os.path.join(SCRIPTS, "*.gp")))
        self.assertGreater(len(scripts), 10)
        for path in scripts:
            with self.subTest(script=os.path.basename(path)), open(path, encoding="utf-8") as file:
                self.assertEqual(hidden(file.readlines()), [])

    def test_a_range_left_behind_is_seen(self):
        panel = ["do for [k = 1:2] {\n", "  stats 'a' using 1\n", "  set xrange [0:1]\n", "  plot 'a'\n", "}\n"]
        self.assertEqual(hidden(panel), [2])
        self.assertEqual(hidden([panel[0], "  set autoscale\n", *panel[1:]]), [])


if __name__ == "__main__":
    unittest.main()
