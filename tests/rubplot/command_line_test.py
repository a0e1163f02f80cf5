import contextlib
import io
import os
import re
import unittest
from unittest import mock

import figures
from rubplot import command_line
from rubplot.subcommands import ALL


class Help(unittest.TestCase):
    def texts(self):
        yield "overview", command_line.overview()
        for one in ALL:
            yield one.name, command_line.parser_of(one).format_help()

    def test_every_help_has_examples_that_can_be_called_and_short_lines(self):
        for name, text in self.texts():
            with self.subTest(name=name):
                self.assertIn("examples:\n  rubplot ", text)
                self.assertLessEqual(max(map(len, text.splitlines())), command_line.WIDTH)
        for one in ALL:
            for example in one.examples:
                if "'" not in example:
                    command_line.parser_of(one).parse_args(example.split())

    def test_the_overview_names_all(self):
        self.assertEqual(figures.rubplot("--help"), (0, command_line.overview() + "\n", ""))
        for one in ALL:
            self.assertIn(f"\n  {one.name} ", command_line.overview())


class Version(unittest.TestCase):
    def test_is_that_of_the_programs(self):
        project = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../CMakeLists.txt")
        with open(project, encoding="utf-8") as file:
            version = re.search(r"project\(rubsweep VERSION (\S+)", file.read())[1]
        self.assertEqual(figures.rubplot("--version"), (0, f"rubplot {version}\n", ""))


class WrongCalls(figures.FileTest):
    def expect(self, code, text, *arguments, **environment):
        found, said, complaint = figures.rubplot(*arguments, **environment)
        self.assertEqual((found, said), (code, ""), complaint)
        self.assertIn(text, complaint)
        self.assertNotIn("Traceback", complaint)
        return complaint

    def test_a_wrong_call_says_what_is_right(self):
        self.expect(2, "a picture is needed, allowed: map, threshold, ")
        self.assertTrue(self.expect(2, "'mapp' is no picture, did you mean map?", "mapp").endswith("Try: rubplot --help\n"))
        self.expect(2, "'xyz' is no picture, allowed: map, ", "xyz")
        self.expect(2, "there is no option --formts, did you mean --formats?", "line", "x", "--formts", "png")
        self.expect(2, "the following arguments are required: DIR", "line")
        self.expect(2, "unrecognized arguments: y", "line", "x", "y")
        self.expect(2, "'gif' is not allowed, allowed: png, svg, pdf", "line", "x", "--formats", "png,gif")
        self.expect(2, "allowed: a name that ends with .png, .svg or .pdf", "line", "x", "--output", "x.gif")
        self.expect(2, "argument --speed-unit: invalid choice: 'kph'", "map", "x", "--speed-unit", "kph")
        self.expect(2, "argument --length-unit: invalid choice: 'inch'", "bode", "x", "--length-unit", "inch")
        self.expect(2, "invalid int value: 'ten'", "trace", "x", "--revolutions", "ten")
        complaint = self.expect(2, "there is no figure 'xyz', allowed: all, ", "figure", "xyz")
        self.assertTrue(complaint.endswith("Try: rubplot figure --help\n"))
        self.expect(2, "did you mean rotor_kit?", "figure", "rotor-kitt")
        self.expect(2, "figure04 shows no map", "figure", "04", "--map", "x")

    def test_ctrl_c_leaves_no_traceback(self):
        complaint = io.TextIOWrapper(io.BytesIO(), encoding="utf-8")
        with mock.patch("rubplot.subcommand.draw", side_effect=KeyboardInterrupt), contextlib.redirect_stderr(complaint):
            self.assertEqual(command_line.main(["map", "x"]), 130)
        complaint.seek(0)
        self.assertEqual(complaint.read(), "rubplot: interrupted; nothing was drawn\n")

    def test_every_picture_names_a_file_that_is_not_there(self):
        for one in ALL:
            if one.picture:
                with self.subTest(name=one.name):
                    self.expect(3, self.path("nowhere"), one.name, self.path("nowhere"))

    def test_damage_of_any_kind_is_no_traceback(self):
        self.write("config.yaml", "sweep:\n  speed_hz:\n    values: [75]\n  whirl_ratio:\n    values: [0.4]\n")
        header = "speed_hz,whirl_ratio,class,order,orbit,whirl,comb_spacing\n"
        for table, said in (
            ("", "no header"),
            (header, "no cells"),
            (header + "75,0.4,chaotic\n", "map.csv:3: 3 cells, 7 columns"),
            (header + "75,x,chaotic,,,,\n", "column 'whirl_ratio': 'x' is no number"),
            (header + ",0.4,chaotic,,,,\n", "map.csv"),
            (header.replace("class", "kind"), "no column 'class'"),
        ):
            with self.subTest(said=said):
                path = self.write("map.csv", figures.sealed(table))
                self.expect(3, said, "map", path)
        path = self.write("map.csv", figures.sealed(header + "75,0.4,chaotic,,,,\n").replace("0.4", "0.5"))
        self.expect(3, "is not as it was written", "map", path)
        self.write("config.yaml", "\x00\n")
        self.expect(3, "config.yaml:1: not as a program writes it", "map", path)

    def test_a_table_without_checksum_is_said(self):
        path = self.write("t.csv", "cell,method\n")
        self.expect(3, f"rubplot: {path} has no checksum in its head: it is taken as it is\n", "work-precision", path)

    def test_gnuplot_is_named_where_it_is_missing(self):
        table = "cell,method,stepper,contact,microseconds_per_revolution,state_error\na,exact,,located,1,1\n"
        self.expect(3, "there is no program called gnuplot to draw with (Debian: gnuplot-nox)", "work-precision",
                    self.write("t.csv", table), PATH=self.directory)
