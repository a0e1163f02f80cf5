import base64
import os
import re
import unittest

import figures
import rotor_report_fixture


class RotorReport(rotor_report_fixture.ReportTest):
    def page(self, *arguments):
        path = self.path("page.html")
        self.assertEqual(figures.rubplot("rotor-report", self.directory, "--output", path, *arguments), (0, "", ""))
        return self.read("page.html")

    def test_the_page_holds_all_pictures_and_asks_nobody(self):
        page = self.page()
        pictures = re.findall(r'<img alt="([^"]+)" src="data:image/png;base64,([^"]+)">', page)
        self.assertEqual([name for name, _ in pictures], ["Rotor", "Static line", "Campbell diagram", "Undamped critical speed map",
                                                          "Stability", "Deflected shape", "Mode shapes"])
        for _, text in pictures:
            self.assertTrue(base64.b64decode(text).startswith(b"\x89PNG\r\n"))
        outside = re.sub(r'src="data:[^"]*"', "", page)
        self.assertNotRegex(outside, r"https?:|src=|@import|url\(|<script")
        for text in ("<title>Pump: Rotor report</title>", "operating range, 30 Hz", "<td>Drive end</td>", "<td>-150</td>",
                     "<td>44.4 Hz (2664 rpm)</td>"):
            self.assertIn(text, page)

    def test_what_is_missing_is_said_with_its_reason(self):
        for name in ("rotor_parts", "static_line", "critical_map", "bearing_loads"):
            os.remove(self.path(f"{name}.csv"))
        notes = "".join(f"{name},left out: a <Jeffcott> rotor has no shaft,,\n" for name in ("rotor", "static_line", "critical_map", "mode_shapes"))
        self.write("report_notes.csv", rotor_report_fixture.NOTES + notes)
        page = self.page()
        self.assertEqual(page.count("left out: a &lt;Jeffcott&gt; rotor has no shaft"), 4)
        self.assertEqual(page.count("<img "), 3)

    def test_units_are_those_that_were_asked_for(self):
        self.assertIn("<td>2664 rpm</td>", self.page("--speed-unit", "rpm"))

    def test_another_name_than_a_page_is_refused(self):
        code, _, complaint = figures.rubplot("rotor-report", self.directory, "--output", self.path("page.png"))
        self.assertEqual(code, 2)
        self.assertIn("allowed: a name that ends with .html", complaint)

    def test_a_directory_without_a_report_is_named(self):
        code, _, complaint = figures.rubplot("rotor-report", self.path("nowhere"))
        self.assertEqual(code, 3)
        self.assertIn("nowhere", complaint)


if __name__ == "__main__":
    unittest.main()
