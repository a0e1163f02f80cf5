"""Clearances of stops under the scaled unbalance."""

import math

import numpy as np

import response

CLEARANCE_SHARE = 0.75


class Stop:
    """A stop in a fixed or moving casing, about the mean position of the rotor."""

    def __init__(self, rotor, entry, gravity_m_per_s2):
        self.rotor, self.entry = rotor, entry
        if gravity_m_per_s2 != 0 and entry.get("casing", "rigid") != "rigid":
            raise SystemExit("a moving casing under weight is not studied")
        self.load_n = -gravity_m_per_s2 * rotor.weights_kg()
        for load in rotor.kit.get("static_loads", []):
            x, y = rotor.places[rotor.place(load["position_m"])]
            self.load_n[x] += load.get("force_x_n", 0)
            self.load_n[y] += load.get("force_y_n", 0)
        if rotor.kit.get("clearances_from", "axis") == "sag":
            self.load_n[:] = 0

    def margin(self, responses, scale, speed_hz):
        """Major axis, allowed length and margin at a speed."""
        x, y = self.rotor.places[self.rotor.place(self.entry["position_m"])]
        mean = np.zeros(2)
        if self.load_n.any():
            sag = np.linalg.solve(self.rotor.at(speed_hz)[2], self.load_n)
            mean = np.array([sag[x], sag[y]])
        if self.entry["kind"] == "annular":
            taken = np.linalg.norm(mean + np.array(self.entry.get("offset_m", [0, 0]), float))
        else:
            angle = math.radians(self.entry["angle_deg"])
            taken = mean @ [math.cos(angle), math.sin(angle)]
        axis = scale * responses.axis_m(speed_hz, "configured", self.entry["position_m"])
        allowed = CLEARANCE_SHARE * 2 * (self.entry["clearance_m"] - taken)
        return axis, allowed, 1 - axis / allowed

    def worst(self, responses, scale, speeds_hz):
        speed_hz, _ = response.largest(lambda hz: -self.margin(responses, scale, hz)[2] + 2, speeds_hz)
        return speed_hz, *self.margin(responses, scale, speed_hz)
