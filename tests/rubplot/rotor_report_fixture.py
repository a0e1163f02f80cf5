"""The tables of a small rotor report, as rubtrace --rotor-report writes them: a shaft in two pieces with a sleeve, a disc, two
bearings, a seal, a stop and two probes."""

import cmath
import math

import figures

PARTS = """element,name,position_m,end_m,inner_m,outer_m,inner_end_m,outer_end_m,mass_kg,polar_inertia_kg_m2,angle_deg
layer,shaft 0,0,0.5,0,0.05,0,0.05,,,
layer,shaft 1,0.5,1,0.01,0.05,0.01,0.08,,,
layer,shaft 1 layer 0,0.5,1,0.05,0.1,0.08,0.1,,,
disc,disc 0,0.5,,,,,,20,0.25,
bearing,Drive end,0.1,,,,,,,,
bearing,Free end,0.9,,,,,,,,
seal,Seal 'A',0.45,,,,,,,,
stop,stop 0,0.55,,,,,,,,
probe,probe 0,0.15,,,,,,,,45
probe,probe 1,0.15,,,,,,,,135
"""
NOTES = """picture,note,from_hz,to_hz
deflected_shape,at 50 Hz (3000 rpm) with an eccentricity of 3 um,,
stability,"cross-coupling at 0.5 m, at 50 Hz (3000 rpm)",,
operating,"operating range, 30 Hz (1800 rpm) to 50 Hz (3000 rpm)",30,50
"""
LOADS = """bearing,position_m,load_x_n,load_y_n,unbalance_force_n
Drive end,0.1,0,-150,3.5
Free end,0.9,0,-170,2.5
"""
CONFIG = """title: Pump
author: Me
rotor:
  discs:
    - position_m: 0.5
  supports:
    - position_m: 0.1
    - position_m: 0.9
stops:
  - kind: annular
    position_m: 0.55
sweep:
  speed_hz: {from: 30, to: 50, count: 5}
"""
PLACES = [0.1 * k for k in range(11)]


def static_line():
    lines = ["position_m,deflection_x_m,deflection_y_m,shear_x_n,shear_y_n,moment_x_nm,moment_y_nm"]
    for z in PLACES:
        lines.append(f"{z},0,{-1e-5 * math.sin(math.pi * z)},0,{150 - 300 * z},0,{150 * z * (1 - z)}")
    return "\n".join(lines) + "\n"


def critical_map():
    lines = ["stiffness_n_per_m,mode,speed_hz"]
    for decade in range(4, 11):
        for mode in (1, 2):
            lines.append(f"{10.0 ** decade},{mode},{mode * 80 / math.sqrt(1 + 1e7 / 10.0 ** decade)}")
    return "\n".join(lines) + "\n"


def bearing_stiffness():
    lines = ["bearing,speed_hz,stiffness_x_n_per_m,stiffness_y_n_per_m"]
    for name, x, y in (("Drive end", 2e7, 3e7), ("Free end", 2e7, 2e7)):
        lines += [f"{name},{speed},{x},{y}" for speed in (0, 20, 40, 60)]
    return "\n".join(lines) + "\n"


def campbell():
    lines = ["speed_hz,mode,whirl,forward_share,frequency_hz,damping_ratio"]
    for mode, whirl, slope in ((1, "backward", -0.1), (2, "forward", 0.1)):
        lines += [f"{speed},{mode},{whirl},{1 if whirl == 'forward' else 0},{40 + slope * speed},{0.05 - 0.0002 * speed * mode}"
                  for speed in (0, 20, 40, 60)]
    return "\n".join(lines) + "\n"


def shapes():
    lines = ["mode,whirl,speed_hz,frequency_hz,position_m,x_real,x_imag,y_real,y_imag"]
    for mode, whirl, turn in ((1, "backward", 1j), (2, "forward", -1j)):
        for z in PLACES:
            x = math.sin(math.pi * z)
            lines.append(f"{mode},{whirl},38,38,{z},{x},0,{(turn * x).real},{(turn * x).imag}")
    return "\n".join(lines) + "\n"


def deflected():
    lines = ["position_m,x_real,x_imag,y_real,y_imag"]
    for z in PLACES:
        x = 2e-6 * math.sin(math.pi * z) * cmath.exp(-0.6j)
        y = -0.5j * x
        lines.append(f"{z},{x.real},{x.imag},{y.real},{y.imag}")
    return "\n".join(lines) + "\n"


def coupling():
    return "coupling_n_per_m,frequency_hz,decrement\n" + "".join(f"{1e5 * k},40,{0.2 - 0.05 * k}\n" for k in range(7))


class ReportTest(figures.FigureTest):
    """Tests with the tables of a whole report in their own directory."""

    def setUp(self):
        super().setUp()
        self.write("config.yaml", CONFIG)
        tables = {"rotor_parts": PARTS, "report_notes": NOTES, "bearing_loads": LOADS, "static_line": static_line(),
                  "critical_map": critical_map(), "bearing_stiffness": bearing_stiffness(), "campbell": campbell(),
                  "critical_speeds": "mode,whirl,speed_hz,damping_ratio\n1,backward,36.4,0.043\n2,forward,44.4,0.03\n",
                  "mode_shapes": shapes(), "lock_speeds": "speed_hz,p,first_mode,q,second_mode\n",
                  "deflected_shape": deflected(), "stability": coupling()}
        for name, text in tables.items():
            self.write(f"{name}.csv", text)

    def expect_clear(self, name, *words):
        """Draws a picture; it has these words, and no text over another. Returns its root."""
        root = self.draw(name)
        found = figures.words(root)
        for word in words:
            self.assertIn(word, found)
        self.assertEqual(figures.over_each_other(root), [])
        return root
