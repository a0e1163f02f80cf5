import unittest

from callgrind_operations import count_parts, count_profile, per_turn

MNEMONICS = {"0x10": "mulsd", "0x14": "mulpd", "0x18": "subpd", "0x1c": "divsd", "0x20": "sqrtsd", "0x24": "mov"}
PROFILE = """\
ob=/somewhere/exact_turns
0x10 7 3
0x14 7 2
0x18 8 1
0x1c 8 4
0x20 8 5
0x24 8 10
calls=2 0x99
0x24 8 1000
ob=/lib/libm.so
0x10 7 6
"""


class CountProfile(unittest.TestCase):
    def test_packed_instructions_count_twice_and_calls_not_at_all(self):
        self.assertEqual(
            count_profile(PROFILE.split("\n"), MNEMONICS),
            {"instructions": 31, "multiplications": 7, "additions": 2, "divisions": 4, "square roots": 5},
        )

    def test_per_turn(self):
        self.assertEqual(per_turn({"a": 10}, {"a": 50}, 20), {"a": 2})


class CountParts(unittest.TestCase):
    def test_names_functions(self):
        lines = ["1,200,000 (50 %) x.cpp:rubsweep::ExactRun<4>::go_on(double)", "300 y ExactMotion<4>::land(int)", "7 other("]
        self.assertEqual(count_parts(lines), {"inside": 1200000, "landings": 300, "switches": 0})
