import unittest

from rubsweep.errors import BadInput, Problem, problem_of


class Errors(unittest.TestCase):
    def test_a_message_comes_apart(self):
        self.assertEqual(problem_of("a b.yaml:3:12: rotor.mass_kg: -1 is out of range, allowed: a number > 0"),
                         Problem("-1 is out of range", "a b.yaml", 3, 12, "rotor.mass_kg", "a number > 0"))

    def test_an_override_has_a_key_and_no_line(self):
        self.assertEqual(problem_of("--set stops.0.clearance_m=x: stops.0.clearance_m: not a number, allowed: a number > 0"),
                         Problem("not a number", key="stops.0.clearance_m", allowed="a number > 0"))

    def test_an_element_of_another_program_has_blanks_in_its_key(self):
        self.assertEqual(problem_of("pump.toml:47:5: ShaftElement_Shaft Element 2.odl: -0.08 is out of range, allowed: a number > 0"),
                         Problem("-0.08 is out of range", "pump.toml", 47, 5, "ShaftElement_Shaft Element 2.odl", "a number > 0"))

    def test_any_other_message_is_text(self):
        self.assertEqual(problem_of("no such thing"), Problem("no such thing"))

    def test_the_first_problem_stands_in_the_exception(self):
        error = BadInput(["c.yaml:1:2: kick: missing, allowed: a map", "c.yaml:4:2: x: unknown key, allowed: y"], 2)
        self.assertEqual((error.file, error.line, error.key, error.allowed), ("c.yaml", 1, "kick", "a map"))
        self.assertEqual([problem.key for problem in error.problems], ["kick", "x"])
        self.assertEqual(str(error).count("\n"), 1)
