"""Every shipped configuration says where its schema is, and the schema there is that of the program. With the folder of the
configurations, rubsweep and ringstab as arguments: those are looked at."""

import os
import subprocess
import sys
import unittest

import mark_schemas

FILES = sys.argv[1:4]


class Marks(unittest.TestCase):
    def test_path_is_relative_to_the_file(self):
        self.assertEqual(mark_schemas.line_of("c/my.yaml", "c"),
                         "# yaml-language-server: $schema=schema/rubsweep.schema.json")
        self.assertEqual(mark_schemas.line_of("c/gallery/ring_brake.yaml", "c"),
                         "# yaml-language-server: $schema=../schema/ringstab.schema.json")

    def test_a_second_mark_replaces_the_first(self):
        once = mark_schemas.marked("a: 1\n", mark_schemas.MARK + "x")
        self.assertEqual(mark_schemas.marked(once, mark_schemas.MARK + "y"), mark_schemas.MARK + "y\na: 1\n")


@unittest.skipIf(not FILES, "no programs")
class Shipped(unittest.TestCase):
    def test_every_file_is_marked(self):
        configs = FILES[0]
        paths = list(mark_schemas.configurations(configs))
        self.assertGreater(len(paths), 50)
        for path in paths:
            with open(path, encoding="utf-8") as file:
                line = file.readline().rstrip("\n")
            self.assertEqual(line, mark_schemas.line_of(path, configs), path)
            self.assertTrue(os.path.exists(os.path.join(os.path.dirname(path), line[len(mark_schemas.MARK):])), path)

    def test_schemas_are_those_of_the_programs(self):
        for program in FILES[1:]:
            asked = subprocess.run([program, "--schema"], check=True, capture_output=True, text=True)
            path = os.path.join(FILES[0], "schema", os.path.basename(program) + ".schema.json")
            with open(path, encoding="utf-8") as file:
                self.assertEqual(file.read(), asked.stdout, f"packaging/mark_schemas.py writes {path} anew")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
