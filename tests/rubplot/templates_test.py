"""Points that stats counts lie inside the ranges of the axes: a range that an earlier panel left behind would hide a part of the
data. Reads the scripts as text."""

import glob
import os
import re
import unittest

TEMPLATES = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../scripts/rubplot/templates")
_FIXES = re.compile(r"\bset [xy]range \[(?!\*:\*\])|\bplot *\[")
_FREES = re.compile(r"\bset autoscale\b|\breset\b|@clear_panel\b")
_STATS = re.compile(r"^\s*(if \([^{]*\) \{ )?stats ")


def hidden(lines):
    """The numbers of the lines with a stats that the range of a panel may narrow."""
    found = set()
    fixed = False
    for number, line in _passed(lines):
        if fixed and _STATS.match(line):
            found.add(number)
        if _FREES.search(line):
            fixed = False
        if _FIXES.search(line):
            fixed = True
    return sorted(found)


def _passed(lines):
    """The lines with their numbers, those of a loop twice: what its end leaves behind is there when it begins again."""
    block, depth = [], 0
    for number, line in enumerate(lines, 1):
        if line.lstrip().startswith("#") or line.startswith("clear_panel ="):
            continue
        block.append((number, line))
        depth += line.count("{") - line.count("}")
        if depth == 0:
            yield from block
            if block[0][1].startswith("do for"):
                yield from block
            block = []


class Ranges(unittest.TestCase):
    def test_no_template_counts_inside_the_range_of_another_panel(self):
        scripts = sorted(glob.glob(os.path.join(TEMPLATES, "*.gp")))
        self.assertGreater(len(scripts), 10)
        for path in scripts:
            with self.subTest(script=os.path.basename(path)), open(path, encoding="utf-8") as file:
                self.assertEqual(hidden(file.readlines()), [])

    def test_a_range_left_behind_is_seen(self):
        panel = ["do for [k = 1:2] {\n", "  stats 'a' using 1\n", "  set xrange [0:1]\n", "  plot 'a'\n", "}\n"]
        self.assertEqual(hidden(panel), [2])
        self.assertEqual(hidden([panel[0], "  set autoscale\n", *panel[1:]]), [])

    def test_axes_of_shaft_speeds_have_rpm_above_them(self):
        for name in ("bode", "branch", "campbell", "compare", "curves", "design", "fit", "identification", "line", "map",
                     "run_up", "scope_run", "threshold"):
            with self.subTest(script=name), open(os.path.join(TEMPLATES, f"{name}.gp"), encoding="utf-8") as file:
                self.assertIn("eval rpm_above(", file.read())


if __name__ == "__main__":
    unittest.main()
