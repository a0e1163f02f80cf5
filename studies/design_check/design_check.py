#!/usr/bin/env python3
"""Compares the terms of `rubtrace --design-check` with numbers that NumPy computes from exported matrices.

Usage: design_check.py PROGRAMS CONFIG.yaml FROM:TO [STAGE...]

PROGRAMS is the folder of rubsweep and rubtrace, FROM:TO the operating range in Hz, a STAGE as --stage takes it
(none: no stage). Nothing of the library is used but the matrices, the printed configuration and the tables that
are compared. The exit code is 1 where a number differs by more than 1e-6, 77 where NumPy or PyYAML is missing.
"""

import math
import pathlib
import re
import subprocess
import sys
import tempfile

try:
    import numpy as np
    import yaml  # noqa: F401
except ImportError as missing:
    print(f"not compared: {missing}")
    sys.exit(77)

import clearances
import response
import stability
from rotor import Rotor, rows_of

TOLERANCE = 1e-6
GAS_DENSITY_KG_PER_M3 = 40.0


class Comparison:
    """Largest differences by the name of a term."""

    def __init__(self):
        self.largest, self.faults = {}, []

    def add(self, term, ours, theirs, scale=None):
        """Relative difference of a pair of numbers; `scale`: what it is relative to instead."""
        if (ours is None) != (theirs is None):
            self.faults.append(f"{term}: {ours} against {theirs}")
            return
        if ours is None:
            return
        difference = abs(ours - theirs) / (scale or abs(ours) or 1.0)
        count, largest = self.largest.get(term, (0, 0.0))
        self.largest[term] = (count + 1, max(largest, difference))

    def report(self):
        for term, (count, largest) in self.largest.items():
            print(f"| {term} | {count} | {largest:.1e} |")
            if not largest <= TOLERANCE:
                self.faults.append(f"{term}: differs by {largest:.1e}")
        for fault in self.faults:
            print(f"fault: {fault}")
        return 1 if self.faults else 0


def number(row, column):
    return float(row[column]) if row[column] not in ("", "nan") else None


def speeds_around(rotor, from_hz, to_hz, critical, even=500):
    """Speeds evenly and close around critical speeds."""
    speeds = set(np.linspace(from_hz, to_hz, even))
    for speed_hz, ratio in critical:
        half = max(abs(ratio), 1e-9) * speed_hz
        speeds.update(speed_hz + half * sign * 2.0 ** power for sign in (-1, 1) for power in np.arange(-4, 5, 0.5))
        speeds.add(speed_hz)
    return sorted(one for one in speeds if from_hz <= one <= to_hz)


def eccentricity_m(rotor, highest_hz):
    off_axis = sum(disc["mass_kg"] * abs(disc.get("eccentricity_ratio", 1)) for disc in rotor.kit["discs"])
    return response.residual_kg_m(rotor.mass_kg(), highest_hz) / off_axis


def cross_coupling_n_per_m(stages, speed_hz):
    total = 0.0
    for stage in stages:
        kind, *parts = stage.split(":")
        numbers = [float(part) for part in parts]
        power, diameter, width = 1e3 * numbers[0], 1e-3 * numbers[-2], 1e-3 * numbers[-1]
        factor, density = (1.5, 1.0) if kind == "blades" else (3.0, numbers[1])
        total += factor * power * density / (2 * math.pi * speed_hz * diameter * width)
    return total


def probes_of(rotor):
    sensors = [float(one["position_m"]) for one in rotor.kit.get("sensors", [])]
    return list(dict.fromkeys(sensors)) or [float(rotor.study["stops"][0]["position_m"])]


def place_of(row):
    """Case of unbalance, kind and number of the place of a row."""
    found = re.match(r"(?:(.*) at )?(probe|stop|support) (\d+)", row["place"])
    return (found[1], found[2], int(found[3])) if found else (None, None, None)


class Check:
    """Both computations of one machine."""

    def __init__(self, programs, config, operating, stages):
        self.programs, self.config, self.stages = programs, config, stages
        self.from_hz, self.to_hz = operating
        with tempfile.TemporaryDirectory() as name:
            self.rows = self.run(name, "--design-check", "--operating-hz", f"{self.from_hz!r}:{self.to_hz!r}",
                                 "--kick-speeds", "0", "--gas-density", f"{GAS_DENSITY_KG_PER_M3!r}",
                                 *[part for one in stages for part in ("--stage", one)],
                                 table="design_check.csv")
        self.rotor = Rotor(str(programs / "rubsweep"), str(config))
        lows, highs = zip(*(one.speeds_hz for one in self.rotor.supports))
        self.low_hz = max(1e-3 * self.to_hz, *lows)
        self.last_hz = min(1.25 * self.to_hz, *highs)
        self.trip_hz = min(1.05 * self.to_hz, *highs)
        self.comparison = Comparison()

    def run(self, folder, *arguments, table):
        subprocess.run([self.programs / "rubtrace", self.config, *arguments, "--output", folder, "--quiet"],
                       check=True)
        return rows_of(pathlib.Path(folder) / table)

    def rows_at(self, check, *place):
        return [row for row in self.rows if row["check"] == check and place_of(row) == place and row["value"] != "nan"
                and row["value"] != ""]

    def compare_critical_speeds(self):
        self.critical = stability.critical_speeds(self.rotor, self.low_hz, self.last_hz)
        with tempfile.TemporaryDirectory() as name:
            theirs = self.run(name, "--campbell", f"{self.low_hz!r}:{self.last_hz!r}", table="critical_speeds.csv")
        theirs = sorted((float(row["speed_hz"]), float(row["damping_ratio"])) for row in theirs)
        ours = list(self.critical)
        if len(ours) != len(theirs):
            self.comparison.faults.append(f"critical speeds: {ours} against {theirs}")
        for mine, other in zip(ours, theirs):
            self.comparison.add("critical speed", mine[0], other[0])
            self.comparison.add("its damping ratio", mine[1], other[1], 1.0)

    def compare_row(self, row, value, limit=None, margin=None, speed_hz=None, scale=None):
        name = row["check"]
        self.comparison.add(name, value, number(row, "value"), scale)
        if limit is not None:
            self.comparison.add(name + ", limit", limit, number(row, "limit"), scale)
        if margin is not None and number(row, "margin") is not None:
            self.comparison.add(name + ", margin", margin, number(row, "margin"), 1.0)
        if speed_hz is not None:
            self.comparison.add(name + ", speed", speed_hz, number(row, "speed_hz"))

    def one(self, check, *place):
        found = self.rows_at(check, *place)
        if len(found) == 1:
            return found[0]
        self.comparison.faults.append(f"{check} of {place}: {len(found)} rows")
        return None

    def compare_responses(self):
        base_m = eccentricity_m(self.rotor, self.to_hz)
        self.responses = response.Responses(self.rotor, base_m, self.to_hz)
        self.speeds = speeds_around(self.rotor, self.low_hz, self.last_hz, self.critical)
        self.operating = [self.from_hz, *(one for one in self.speeds if self.from_hz < one < self.to_hz), self.to_hz]
        limit_m = 25.4e-6 * min(1.0, math.sqrt(12000 / (60 * self.to_hz)))
        tops = []
        for k, position_m in enumerate(probes_of(self.rotor)):
            for case in self.responses.cases:
                def axis(hz, case=case, position_m=position_m):
                    return self.responses.axis_m(hz, case, position_m)
                speed_hz, top = response.largest(axis, self.operating)
                row = self.one("vibration", None, "probe", k) if case == "configured" else self.one(
                    "response", case, "probe", k)
                if case == "configured":
                    tops.append(top)
                if row:
                    self.compare_row(row, top, limit_m, 1 - top / limit_m, speed_hz)
                self.compare_peaks(axis, case, k)
        self.scale = min(max(limit_m / max(tops), 0.5), 6.0)

    def compare_peaks(self, axis, case, probe):
        ours = response.peaks(axis, self.speeds)
        told = [one for one in ours if one[2] is not None]
        for check, mine in (("amplification", told), ("separation", ours)):
            theirs = self.rows_at(check, case, "probe", probe)
            if len(mine) != len(theirs):
                self.comparison.faults.append(
                    f"{check}, {case} at probe {probe}: {[one[0] for one in mine]} against "
                    f"{[row['speed_hz'] for row in theirs]}")
                continue
            for (speed_hz, _, factor), row in zip(mine, theirs):
                if check == "amplification":
                    self.compare_row(row, factor, speed_hz=speed_hz)
                    continue
                actual, required = response.separations(factor, speed_hz, self.from_hz, self.to_hz)
                self.compare_row(row, actual, required if required else None,
                                 actual - required if required else None, scale=1.0)

    def compare_forces_and_clearances(self):
        for support in self.rotor.bearings():
            row = self.one("bearing_force", None, "support", support)
            speed_hz, force = response.largest(lambda hz, i=support: self.responses.force_n(hz, i), self.operating)
            if row:
                self.compare_row(row, self.scale * force, speed_hz=speed_hz)
        gravity = float(self.rotor.study.get("gravity_m_per_s2", 0))
        up_to = [one for one in self.speeds if one <= self.to_hz]
        trip = [self.to_hz, *(one for one in self.speeds if self.to_hz < one < self.trip_hz), self.trip_hz]
        for k, entry in enumerate(self.rotor.study["stops"]):
            stop = clearances.Stop(self.rotor, entry, gravity)
            for check, speeds in (("clearance", up_to + [self.to_hz]), ("clearance_to_trip", trip)):
                row = self.one(check, None, "stop", k) if speeds[0] < speeds[-1] else None
                if row:
                    speed_hz, *numbers = stop.worst(self.responses, self.scale, speeds)
                    self.compare_row(row, *numbers, speed_hz)

    def told(self, check):
        found = [row for row in self.rows if row["check"] == check and row["value"] not in ("", "nan")]
        return found[0] if found else None

    def compare_stability(self):
        rotor, speed_hz = self.rotor, self.to_hz
        outer = [rotor.supports[i].position_m for i in rotor.bearings()]
        midspan = rotor.place((outer[0] + outer[-1]) / 2)
        stages = [one for one in self.stages if one != "none"]
        coupling = cross_coupling_n_per_m(stages, speed_hz)
        if coupling > 0:
            self.compare_row(self.told("cross_coupling"), coupling)
            seals = tuple(i for i, one in enumerate(rotor.supports) if one.position_m is not None and rotor.is_seal(i))
            bare = rotor.at(speed_hz, without=seals)
            mode = stability.first_forward(rotor, stability.coupled(rotor, bare, midspan, coupling), 2 * speed_hz)
            self.compare_decrement("level_1", mode and stability.decrement(mode[0]))
            threshold = stability.threshold_n_per_m(rotor, bare, midspan, 2 * speed_hz)
            self.compare_decrement("level_1_threshold", threshold and threshold / coupling)
            self.compare_row(self.told("level_1_region"), speed_hz / stability.rigid_critical_hz(rotor),
                             stability.region_limit(GAS_DENSITY_KG_PER_M3))
        modes = [stability.first_forward(rotor, stability.coupled(rotor, rotor.at(hz), midspan, coupling), 2 * speed_hz)
                 for hz in np.linspace(self.from_hz, self.to_hz, 11)]
        least = min((stability.decrement(mode[0]) for mode in modes if mode), default=None)
        self.compare_decrement("level_2", least)

    def compare_decrement(self, check, ours):
        row = self.told(check)
        self.comparison.add(check, ours, number(row, "value") if row else None)

    def report(self):
        self.compare_critical_speeds()
        self.compare_responses()
        self.compare_forces_and_clearances()
        self.compare_stability()
        seals = len(self.rotor.supports) - len(self.rotor.bearings())
        print(f"{self.config.name}: {self.rotor.n} coordinates, {len(self.rotor.bearings())} bearings, "
              f"{seals} other supports, {self.from_hz:.6g} to {self.to_hz:.6g} Hz")
        print("| term | numbers | largest difference |\n|---|---|---|")
        return self.comparison.report()


def main():
    programs, config, operating, *stages = sys.argv[1:]
    from_hz, to_hz = map(float, operating.split(":"))
    return Check(pathlib.Path(programs), pathlib.Path(config), (from_hz, to_hz), stages).report()


if __name__ == "__main__":
    sys.exit(main())
