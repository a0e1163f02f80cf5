"""A rotor from the matrices that `rubsweep --export-matrices` writes, by NumPy alone.

Supports with a table are no part of the matrices. Their coefficients, names and masses come from the printed
configuration and, for a rotor of ROSS, from its own file.
"""

import csv
import math
import pathlib
import re
import subprocess
import tempfile
import tomllib

import numpy as np
import yaml

YamlLoader = type("YamlLoader", (yaml.SafeLoader,), {})
EXPONENT = re.compile(r"[-+]?\d+(\.\d+)?e[-+]?\d+$")  # 1e-08, a text in YAML 1.1
YamlLoader.add_implicit_resolver("tag:yaml.org,2002:float", EXPONENT, list("-+0123456789"))
TABLE_COLUMNS = ("kxx", "kxy", "kyx", "kyy", "cxx", "cxy", "cyx", "cyy", "mxx", "myy")
KEYS = {
    "kxx": "stiffness_x_n_per_m", "kxy": "stiffness_xy_n_per_m", "kyx": "stiffness_yx_n_per_m",
    "kyy": "stiffness_y_n_per_m", "cxx": "damping_x_ns_per_m", "cxy": "damping_xy_ns_per_m",
    "cyx": "damping_yx_ns_per_m", "cyy": "damping_y_ns_per_m", "mxx": "mass_x_kg", "myy": "mass_y_kg",
}
UNITS = {"k": "_n_per_m", "c": "_ns_per_m", "m": "_kg"}


def rows_of(path):
    """Rows of a table of ours as maps."""
    with open(path, encoding="utf-8") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


def matrix_of(path):
    """Dense matrix of a Matrix Market file."""
    with open(path, encoding="utf-8") as file:
        mirrored = {"general": 0, "symmetric": 1, "skew-symmetric": -1}[file.readline().split()[-1]]
        lines = [line for line in file if not line.startswith("%")]
    rows, columns, _ = map(int, lines[0].split())
    matrix = np.zeros((rows, columns))
    for line in lines[1:]:
        i, k, value = line.split()
        matrix[int(i) - 1, int(k) - 1] = float(value)
        if mirrored:
            matrix[int(k) - 1, int(i) - 1] = float(value) * (1 if i == k else mirrored)
    return matrix


class MonotoneCubic:
    """Fritsch and Carlson's interpolation with the slopes of Fritsch and Butland."""

    def __init__(self, x, y):
        self.x, self.y = np.asarray(x, float), np.asarray(y, float)
        h, d = np.diff(self.x), np.diff(self.y) / np.diff(self.x)
        self.slope = np.zeros(len(self.x))
        if len(self.x) == 2:
            self.slope[:] = d[0]
            return
        for i in range(1, len(self.x) - 1):
            if d[i - 1] * d[i] > 0:
                a = 2 * h[i] + h[i - 1]
                b = h[i] + 2 * h[i - 1]
                self.slope[i] = (a + b) / (a / d[i - 1] + b / d[i])
        self.slope[0] = self.end(h[0], d[0], h[1], d[1])
        self.slope[-1] = self.end(h[-1], d[-1], h[-2], d[-2])

    @staticmethod
    def end(h, d, h_next, d_next):
        slope = ((2 * h + h_next) * d - h * d_next) / (h + h_next)
        if slope * d <= 0:
            return 0.0
        return 3 * d if d * d_next <= 0 and abs(slope) > 3 * abs(d) else slope

    def __call__(self, at):
        i = int(np.clip(np.searchsorted(self.x, at, side="right") - 1, 0, len(self.x) - 2))
        h = self.x[i + 1] - self.x[i]
        t = (at - self.x[i]) / h
        return ((1 + 2 * t) * (1 - t) ** 2 * self.y[i] + t * (1 - t) ** 2 * h * self.slope[i]
                + t * t * (3 - 2 * t) * self.y[i + 1] + t * t * (t - 1) * h * self.slope[i + 1])


class Support:
    """Coefficients of a bearing or seal over the speed, and the coordinates that it joins."""

    def __init__(self, entry, index_of):
        self.position_m = None if "at_housing" in entry else float(entry["position_m"])
        at = index_of("housing", entry["at_housing"]) if "at_housing" in entry else index_of("m", self.position_m)
        base = index_of("housing", entry["on_housing"]) if "on_housing" in entry else None
        self.pairs = [(at[plane], None if base is None else base[plane]) for plane in range(2)]
        table = entry.get("table")
        self.tabled = table is not None
        self.tilting = float(entry.get("angular_stiffness_nm_per_rad", 0))
        if "pedestal" in entry:
            raise SystemExit("pedestals are not studied")
        if self.tabled:
            speeds = [float(one) for one in table["speed_hz"]]
            named = {c: table.get(c + UNITS[c[0]], [0] * len(speeds)) for c in TABLE_COLUMNS}
            self.curves = {c: MonotoneCubic(speeds, [float(one) for one in named[c]]) for c in TABLE_COLUMNS}
            self.middle_hz, self.speeds_hz = speeds[len(speeds) // 2], (speeds[0], speeds[-1])
        else:
            self.curves = {c: (lambda _, value=float(entry.get(KEYS[c], 0)): value) for c in TABLE_COLUMNS}
            self.middle_hz, self.speeds_hz = 0.0, (0.0, math.inf)

    def at(self, speed_hz):
        """Stiffness, damping and mass, 2 x 2 each."""
        value = {c: self.curves[c](speed_hz) for c in TABLE_COLUMNS}
        return tuple(np.array(m) for m in (
            [[value["kxx"], value["kxy"]], [value["kyx"], value["kyy"]]],
            [[value["cxx"], value["cxy"]], [value["cyx"], value["cyy"]]],
            [[value["mxx"], 0.0], [0.0, value["myy"]]]))

    def gap(self, n):
        """Rows 2 x n that give its displacement relative to its base."""
        rows = np.zeros((2, n))
        for plane, (here, base) in enumerate(self.pairs):
            rows[plane, here] += 1
            if base is not None:
                rows[plane, base] -= 1
        return rows

    def held(self):
        stiffness = self.at(self.middle_hz)[0]
        return min(stiffness[0, 0], stiffness[1, 1])


def section_mass_kg(layer, length_m, begin=0.0, end=1.0):
    """Mass of a straight or tapered tube between two shares of its length; diameters are linear."""
    def area(share):
        outer = layer["outer_diameter_m"] + share * (layer.get("outer_diameter_end_m", layer["outer_diameter_m"])
                                                     - layer["outer_diameter_m"])
        inner = layer["inner_diameter_m"] + share * (layer.get("inner_diameter_end_m", layer["inner_diameter_m"])
                                                     - layer["inner_diameter_m"])
        return math.pi / 4 * (outer ** 2 - inner ** 2)
    mean = (area(begin) + 4 * area((begin + end) / 2) + area(end)) / 6
    return layer["density_kg_per_m3"] * length_m * (end - begin) * mean


class Rotor:
    """Matrices, places, masses and supports of a rotor."""

    def __init__(self, rubsweep, config):
        printed = subprocess.run([rubsweep, config, "--print-config"], check=True, capture_output=True, text=True)
        self.study = yaml.load(printed.stdout, YamlLoader)
        self.kit = self.study["rotor"]
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name) / "matrices"
            subprocess.run([rubsweep, config, "--export-matrices", folder, "--quiet"], check=True)
            self.mass, self.damping, self.gyroscopic, self.stiffness = (
                matrix_of(folder / f"{m}.mtx") for m in ("mass", "damping", "gyroscopic", "stiffness"))
            freedoms = rows_of(folder / "degrees_of_freedom.csv")
            self.unbalance = np.array([complex(float(row["real_kg"]), float(row["imaginary_kg"]))
                                       for row in rows_of(folder / "unbalance.csv")])
        self.n = len(freedoms)
        self.find_places(freedoms)
        self.supports = [Support(entry, self.index_of) for entry in self.kit["supports"]]
        self.names = self.names_of_ross(config)
        self.known_damping = {}
        if np.any(np.array(self.kit.get("rotating_damping_ratio", 0), float)):
            raise SystemExit("rotating_damping_ratio: is not studied")

    def find_places(self, freedoms):
        self.plane = np.array([0 if row["direction"] in ("x", "ry") else 1 for row in freedoms])
        self.moves = np.array([row["direction"] in ("x", "y") for row in freedoms])
        nodes = {}
        for i, row in enumerate(freedoms):
            nodes.setdefault(row["node"], {"m": row["position_m"]})[row["direction"]] = i
        shaft = [(float(node["m"]), node) for node in nodes.values() if node["m"] != ""]
        self.place_m = np.array([at for at, _ in shaft])
        self.places = [(node["x"], node["y"]) for _, node in shaft]
        self.tilts = np.array([(node["ry"], node["rx"]) for _, node in shaft])
        self.housings = [(node["x"], node["y"]) for node in nodes.values() if node["m"] == ""]

    def place(self, position_m):
        return int(np.argmin(np.abs(self.place_m - position_m)))

    def index_of(self, kind, at):
        return self.housings[at] if kind == "housing" else self.places[self.place(at)]

    @staticmethod
    def names_of_ross(config):
        """Names of bearings and seals in the order of a file of ROSS; empty for other rotors."""
        with open(config, encoding="utf-8") as file:
            rotor = yaml.safe_load(file)["rotor"]
        if rotor.get("kind") != "ross" or not str(rotor["file"]).endswith(".toml"):
            return []
        with open(pathlib.Path(config).parent / rotor["file"], "rb") as file:
            return [name for name, element in tomllib.load(file).items()
                    if isinstance(element, dict) and "kxx" in element]

    def is_seal(self, number):
        if self.names and "Seal" in self.names[number]:
            return True
        stiffest = max(one.held() for one in self.supports if one.position_m is not None)
        return self.supports[number].held() < 0.01 * stiffest

    def bearings(self):
        """Numbers of the supports of the shaft that are no seals, along the shaft."""
        found = [i for i, one in enumerate(self.supports) if one.position_m is not None and not self.is_seal(i)]
        return sorted(found, key=lambda i: self.supports[i].position_m)

    def plane_at_middle(self, plane, without=()):
        """Mass and stiffness of one plane with the tables at their middle speeds."""
        mass, stiffness = self.mass.copy(), self.stiffness.copy()
        for number, one in enumerate(self.supports):
            sign = one.tabled - (number in without)
            k, _, m = one.at(one.middle_hz)
            gap = one.gap(self.n)
            stiffness += sign * gap.T @ np.diag(np.diag(k)) @ gap
            mass += sign * gap.T @ m @ gap
        own = self.plane == plane
        return mass[np.ix_(own, own)], stiffness[np.ix_(own, own)]

    def modes(self, plane, without=()):
        """Undamped rates in rad/s and shapes with modal mass 1."""
        mass, stiffness = self.plane_at_middle(plane, without)
        root = np.linalg.cholesky(stiffness)
        half = np.linalg.solve(root, np.linalg.solve(root, mass).T)
        values, vectors = np.linalg.eigh((half + half.T) / 2)
        keep = values > 1e-14 * values[-1]
        values, vectors = values[keep][::-1], vectors[:, keep][:, ::-1]
        return 1 / np.sqrt(values), np.linalg.solve(root.T, vectors) / np.sqrt(values)

    def damping_by_ratios(self, without=()):
        """Damping of each mode by its ratio, of the rotor without some supports."""
        if without not in self.known_damping:
            damping = np.zeros((self.n, self.n))
            ratios = np.atleast_1d(np.array(self.kit.get("damping_ratio", 0), float))
            for plane in range(2 if ratios.any() else 0):
                rates, shapes = self.modes(plane, without)
                ratio = ratios[np.minimum(np.arange(len(rates)), len(ratios) - 1)]
                momentum = self.plane_at_middle(plane, without)[0] @ shapes
                own = np.flatnonzero(self.plane == plane)
                damping[np.ix_(own, own)] = (momentum * (2 * ratio * rates)) @ momentum.T
            self.known_damping[without] = damping
        return self.known_damping[without]

    def at(self, speed_hz, without=()):
        """Mass, damping with the gyroscopic part, and stiffness at a speed; `without`: supports taken away."""
        mass, damping, stiffness = self.mass.copy(), self.damping.copy(), self.stiffness.copy()
        damping += 2 * math.pi * speed_hz * self.gyroscopic + self.damping_by_ratios(without)
        for number, one in enumerate(self.supports):
            sign = (1 if one.tabled else 0) - (1 if number in without else 0)
            if number in without and one.tilting:
                for tilt in self.tilts[self.place(one.position_m)]:
                    stiffness[tilt, tilt] -= one.tilting
            if sign == 0:
                continue
            k, c, m = one.at(speed_hz)
            gap = one.gap(self.n)
            stiffness += sign * gap.T @ k @ gap
            damping += sign * gap.T @ c @ gap
            mass += sign * gap.T @ m @ gap
        return mass, damping, stiffness

    def mass_kg(self, low_m=-math.inf, high_m=math.inf):
        """Mass of shaft, discs and point masses strictly between two places."""
        total, begin = 0.0, 0.0
        for segment in self.kit["shaft"]:
            length = float(segment["length_m"])
            low, high = max(low_m, begin), min(high_m, begin + length)
            if high > low:
                for layer in [segment, *segment.get("layers", [])]:
                    total += section_mass_kg(layer, length, (low - begin) / length, (high - begin) / length)
            begin += length
        for part in [*self.kit.get("discs", []), *self.kit.get("point_masses", [])]:
            if low_m < part["position_m"] < high_m:
                total += float(part["mass_kg"])
        return total

    def weights_kg(self):
        """Mass whose weight acts along each coordinate of y, without fluid in supports."""
        mass = self.mass.copy()
        for one in self.supports:
            if not one.tabled:
                gap = one.gap(self.n)
                mass -= gap.T @ one.at(0)[2] @ gap
        return np.where(self.plane == 1, mass @ (self.moves & (self.plane == 1)), 0.0)
