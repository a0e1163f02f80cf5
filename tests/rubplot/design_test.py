import figures

import os

from rubplot import csv_table
from rubplot.pictures import design

CHECKS = """check,place,position_m,speed_hz,value,limit,unit,margin,verdict
vibration,probe 0,0.25,50,1e-05,2.54e-05,m,0.6063,ok
clearance,stop 0,0.29,30,3e-04,1.5e-4,m,-1,not_met
dry_whip,stop 0,,50,0.25,,1,1,ok
stability,,,90,201,0,1/s,,not_met
kick,,,60,17.5,,N,,
"""
RESPONSE = """place,position_m,speed_hz,major_axis_m,limit_m
probe 0,0.25,10,1e-06,
probe 0,0.25,50,1e-05,2.54e-05
probe 0,0.25,90,2e-05,2.54e-05
stop 0,0.29,10,3e-06,1.5e-4
stop 0,0.29,50,3e-04,1.5e-4
stop 0,0.29,90,3e-05,1.5e-4
"""


class Design(figures.FigureTest):
    def setUp(self):
        super().setUp()
        self.write("config.yaml", "title: Pump\nsweep:\n  speed_hz: {from: 50, to: 90, count: 5}\n")
        self.write("design_check.csv", CHECKS)
        self.write("unbalance_response.csv", RESPONSE)
        self.write("lock_speeds.csv", "speed_hz,p,first_mode,q,second_mode\n60,3,2,1,1\n60,3,1,1,2\n")
        self.write("kicks.csv", "speed_hz,force_n,motion,runs,failed\n50,,,8,0\n60,17.5,chaotic,12,0\n90,20,chaotic,9,0\n")

    def test_the_picture_says_what_it_shows(self):
        words = figures.words(self.draw("design", "--heading", "Design check"))
        for word in ("Pump: Design check", "probes (µm peak to peak)", "limit 25.4 µm",
                     "probe 0", "stop 0", "axis / allowed at stops (%)", "kick that starts a rub (N)",
                     "lock speed", "none of the kicks", "clearance", "not met", "-100.0 %", "17.5 N", "60 Hz (3600 rpm)", "dry whip",
                     "stability"):
            self.assertIn(word, words)

    def test_texts_leave_each_other_room(self):
        self.assertEqual(figures.over_each_other(self.draw("design")), [])

    def test_probes_have_the_names_of_their_sensors(self):
        rows = CHECKS.replace("verdict\n", "verdict,name\n").replace("ok\n", "ok,\n").replace("met\n", "met,\n").replace("N,,\n", "N,,,\n")
        rows = rows.replace("0.6063,ok,", '0.6063,ok,"drive end 45, drive end 135"') + 'vibration,probe 1,0.4,50,1e-05,2.54e-05,m,0.6,ok,free end x\n'
        self.write("design_check.csv", rows)
        self.write("unbalance_response.csv", RESPONSE + RESPONSE.split("\n", 1)[1].split("stop")[0].replace("probe 0,0.25", "probe 1,0.4"))
        root = self.draw("design")
        words = figures.words(root)
        self.assertIn("probe 0 (drive end 45, drive end 135)", words)
        self.assertIn("probe 1 (free end x)", words)
        self.assertEqual(figures.over_each_other(root), [])

    def named_stops(self, count):
        names = ["seal beside the disc", "catcher", "a", "b", "c", "d"][:count]
        rows = [row + "," for row in CHECKS.splitlines() if not row.startswith(("check", "clearance"))]
        rows += [f"clearance,stop {i},0.29,30,3e-04,1.5e-4,m,0.5,ok,{name}" for i, name in enumerate(names)]
        self.write("design_check.csv", "\n".join([CHECKS.splitlines()[0] + ",name", *rows]) + "\n")
        of_stop = RESPONSE[RESPONSE.index("stop 0"):]
        self.write("unbalance_response.csv", RESPONSE + "".join(of_stop.replace("stop 0", f"stop {i}") for i in range(1, count)))
        return self.draw("design")

    def test_names_of_stops_leave_the_axis_above_them_room(self):
        for count, word in ((2, "stop 0 (seal beside the disc)"), (5, "stop 0 (seal beside…)"), (6, "stop 0")):
            root = self.named_stops(count)
            self.assertIn(word, figures.words(root))
            self.assertEqual(figures.over_each_other(root), [])

    def test_of_many_checks_those_that_are_not_met_and_the_smallest_margins_are_shown(self):
        rows = [f"separation,configured at probe {k},0.25,{30 + k},-0.1,0.2,1,{margin},{verdict}"
                for k, (margin, verdict) in enumerate([(0.9, "ok")] * 12 + [(0.01, "ok"), (-0.123, "not_met")])]
        rows += ["separation,,,250,,,,,not_told", "amplification,mode 1 at probe 0,0.25,30,9.5,,1,,",
                 "bearing_force,support 0,0.1,60,123,,N,,", "level_2,,,60,0.2,0.1,1,1,ok"]
        self.write("design_check.csv", CHECKS + "\n".join(rows) + "\n")
        root = self.draw("design")
        words = figures.words(root)
        for word in ("separation", "configured, probe 13", "-12.3 %", "1.0 %", "not told", "not met"):
            self.assertIn(word, words)
        self.assertNotIn("AF", words)
        self.assertEqual(figures.over_each_other(root), [])

    def test_without_kicks_and_lock_speeds_there_are_none_in_the_legend(self):
        os.remove(os.path.join(self.directory, "kicks.csv"))
        self.write("lock_speeds.csv", "speed_hz,p,first_mode,q,second_mode\n")
        words = figures.words(self.draw("design"))
        for word in ("lock speed", "none of the kicks"):
            self.assertNotIn(word, words)
        self.assertIn("no kicks were tried", words)

    def test_shares_over_many_decades_leave_the_titles_room(self):
        self.write("unbalance_response.csv", RESPONSE.replace("stop 0,0.29,10,3e-06", "stop 0,0.29,10,3e-11"))
        root = self.draw("design")
        self.assertEqual(figures.over_each_other(root), [])
        self.assertNotIn("0.0001", figures.words(root))

    def test_a_share_is_of_the_limit_and_missing_where_there_is_no_clearance(self):
        self.assertEqual(list(design.share_lines([(50, 3e-4, 1.5e-4), (60, 1e-4, 0.0)], 1)), ["50 200"])

    def test_the_limit_of_the_shares_is_inside_the_picture(self):
        self.assertEqual(design.top_share([("stop 0", [(50, 1e-4, 1e-3), (60, 2e-4, 1e-3)])]), 200)
        self.assertAlmostEqual(design.top_share([("stop 0", [(50, 4e-3, 1e-3), (60, 1e-3, 0.0)])]), 600)
        self.assertEqual(design.top_share([("stop 0", [(50, 1e-4, 0.0)])]), 200)

    def test_a_curve_of_kicks_breaks_where_none_starts_a_rub(self):
        self.assertEqual(list(design.kick_lines([(50, 2.0), (60, None), (70, 4.0)], 60)), ["3000 2", "", "4200 4"])

    def test_what_is_no_place_is_refused(self):
        for name, text in (("unbalance_response.csv", RESPONSE.replace("stop 0", "stop '0")),
                           ("design_check.csv", CHECKS.replace("stop 0", "stop")),
                           ("design_check.csv", CHECKS.replace("kick,", "kicks,"))):
            self.write("bad_" + name, text)
            read = design.curves if name.startswith("unbalance") else design.check_rows
            with self.assertRaises(csv_table.TableError):
                read(os.path.join(self.directory, "bad_" + name))
