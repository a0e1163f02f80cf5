import math

import as_recorded
from files import FileTest
from rubplot import csv_table


class AsRecorded(FileTest):
    def recorded(self, *options):
        """Rows of numbers that are written of readings of 10 and -20 um at 20 kHz, at 50 Hz, and what is true of them."""
        rows = "".join(f"{k / 20000},1e-5,-2e-5\n" for k in range(2000))
        sensors = self.write("sensors.csv", "t_s,sensor_0_m,sensor_1_m\n" + rows)
        out = self.path("run.csv")
        as_recorded.write_recording(as_recorded.parse([sensors, out, "--speed-hz", "50", *options]))
        with open(out, encoding="utf-8") as file:
            names, *lines = file.read().splitlines()
        self.assertEqual(names, "time [s];P0 [mV];P1 [mV];KP [V]")
        truth = {row["quantity"]: csv_table.number(row, "value") for row in csv_table.read_table(self.path("run_truth.csv"))}
        return [[float(cell) for cell in line.split(";")] for line in lines], truth

    def test_probes_read_millivolts(self):
        rows, truth = self.recorded()
        self.assertEqual(rows[7][1:3], [80, -160])
        self.assertEqual(truth["gain_0"], 1)

    def test_the_keyway_passes_once_a_turn_at_its_angle(self):
        rows, _ = self.recorded("--mark-deg", "90")
        falls = [row[0] for before, row in zip(rows, rows[1:]) if before[3] == -2 and row[3] == -12]
        self.assertEqual(len(falls), 5)
        self.assertTrue(all(abs(time - (k + 0.25) / 50) < 1e-4 for k, time in enumerate(falls)))

    def test_the_clock_is_fast(self):
        rows, _ = self.recorded("--clock-ppm", "100")
        self.assertAlmostEqual(rows[-1][0] / (1999 / 20000), 1.0001, 6)

    def test_run_out_and_gain_are_what_the_truth_says(self):
        rows, truth = self.recorded("--run-out-um", "3", "--gain-error", "0.01")
        self.assertNotEqual(truth["gain_1"], 1)
        k = 123
        turns = 50 * k / 20000
        run_out = sum(truth[f"run_out_1_{order}x_um"] * math.cos(2 * math.pi * order * turns + math.radians(truth[f"run_out_1_{order}x_deg"]))
                      for order in (1, 2))
        self.assertAlmostEqual(rows[k][2], 8 * truth["gain_1"] * (-20 + run_out), 2)

    def test_a_seed_gives_the_same_recording(self):
        options = ("--run-out-um", "3", "--gain-error", "0.01", "--seed", "5")
        self.assertEqual(self.recorded(*options), self.recorded(*options))
        self.assertNotEqual(self.recorded(*options)[1], self.recorded(*options[:-1], "6")[1])
