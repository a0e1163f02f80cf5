"""The figures of Lesaffre, Sinou and Thouverez (JSV 299, 2007), loads that rub on an elastic ring."""

import os
import tempfile
from dataclasses import dataclass
from typing import Tuple

from rubplot.gnuplot import Picture
from rubplot.pictures import ring, ring_chart

PNG = ("png",)


@dataclass(frozen=True)
class PanelRun:
    """A run up to a speed, so that its modes are named at rest, drawn from another one on; real parts between -limit and
    limit, 0 for all of them. `settings` are KEY=VALUE."""

    title: str
    stem: str
    from_rpm: int
    to_rpm: int
    limit: float
    settings: Tuple[str, ...] = ()

    def panel(self, sources, work):
        count = 4001 if self.from_rpm > 0 else 2001
        _run(sources, self.stem, work, (*self.settings, f"speed_rpm={{from: 0, to: {self.to_rpm}, count: {count}}}"))
        return ring.read_panel(work, self.title, self.from_rpm, self.to_rpm, self.limit)


@dataclass(frozen=True)
class PanelFigure:
    heading: str
    runs: Tuple[PanelRun, ...]

    def draw(self, name, sources, wanted):
        panels = []
        for run in self.runs:
            with tempfile.TemporaryDirectory() as work:
                panels.append(run.panel(sources, work))
        wanted.draw(ring.picture_of(panels, self.heading), sources.figure(name), PNG)


@dataclass(frozen=True)
class RegionFigure:
    """Where a second load couples with the first, for two and three nodal diameters."""

    heading: str
    stem: str

    def draw(self, name, sources, wanted):
        files = {"first_load": ["60 0", "60 1"]}
        for diameters in (2, 3):
            chart = _chart(sources, self.stem, (f"ring.nodal_diameters={diameters}",))
            files[f"couplings_{diameters}"] = ["%g" % angle for angle in chart.couplings] or ["NaN"]
        wanted.draw(Picture("ring_regions.gp", (self.heading,), files), sources.figure(name), PNG)


@dataclass(frozen=True)
class ChartFigure:
    heading: str
    stem: str
    ends: Tuple[str, str]
    top_rpm: str

    def draw(self, name, sources, wanted):
        chart = _chart(sources, self.stem)
        wanted.draw(ring_chart.picture_of(chart, self.heading, self.ends, self.top_rpm), sources.figure(name), PNG)


def _chart(sources, stem, settings=()):
    with tempfile.TemporaryDirectory() as work:
        _run(sources, stem, work, settings)
        return ring_chart.read_chart(work)


def _run(sources, stem, directory, settings):
    options = [word for setting in settings for word in ("--set", setting)]
    sources.run("ringstab", stem, "--output", directory, "--quiet", *options)


def _mu(value):
    return (f"friction_coefficient={value}",)


def _radial_loads(*angles):
    load = "{{kind: spring_mass, angle_deg: {}, mass_kg: 100, radial_stiffness_n_per_m: 1.0e6, motion: radial}}"
    return (f"loads=[{', '.join(load.format(angle) for angle in angles)}]",)


def _inclined(from_rpm, to_rpm):
    return tuple(PanelRun(f"α = {alpha}°", "ring_figure18", from_rpm, to_rpm, 0, (f"loads.0.inclination_deg={alpha}",))
                 for alpha in (0, 5, 10, 89))


_BEAM = ("loads=[{kind: beam, angle_deg: 60, radial_mass_kg: 185.66, flexural_mass_kg: 100, "
         "radial_stiffness_n_per_m: 1.175e7, tangential_stiffness_n_per_m: 1.0e6}]",)

FIGURES = {
    "03": PanelFigure("A radial stiffness rubs on the ring", (
        PanelRun("a) µ = 0.01", "ring_figure03", 0, 500, 0, _mu(0.01)),
        PanelRun("b) zoom of a", "ring_figure03", 140, 250, 1, _mu(0.01)),
        PanelRun("c) µ = 0.1", "ring_figure03", 0, 500, 0, _mu(0.1)),
        PanelRun("d) zoom of c", "ring_figure03", 140, 250, 2, _mu(0.1)))),
    "04": PanelFigure("A mass rubs on the ring", (
        PanelRun("a) µ = 0.01", "ring_figure04", 0, 1500, 0, _mu(0.01)),
        PanelRun("b) zoom of a", "ring_figure04", 140, 180, 1, _mu(0.01)),
        PanelRun("c) µ = 0.1", "ring_figure04", 0, 1500, 0, _mu(0.1)),
        PanelRun("d) zoom of c", "ring_figure04", 140, 180, 1, _mu(0.1)))),
    "05": PanelFigure("A radial spring-mass rubs on the ring", (
        PanelRun("a) ω_r = 100 rad/s, µ = 0.01", "ring_figure05", 0, 1000, 0),
        PanelRun("b) zoom of a", "ring_figure05", 0, 700, 0.2),
        PanelRun("c) ω_r = 31.6 rad/s, µ = 0.01", "ring_figure05", 0, 1000, 0, ("loads.0.radial_stiffness_n_per_m=1e5",)),
        PanelRun("d) zoom of c", "ring_figure05", 0, 350, 0.05, ("loads.0.radial_stiffness_n_per_m=1e5",)))),
    "06": PanelFigure("A radial spring-mass, more friction", (
        PanelRun("a) ω_r = 100 rad/s, µ = 0.1", "ring_figure05", 0, 1000, 0, _mu(0.1)),
        PanelRun("b) zoom of a", "ring_figure05", 0, 700, 2, _mu(0.1)))),
    "07": PanelFigure("Radial spring-masses, µ = 0.01", (
        PanelRun("a) one", "ring_figure07", 0, 1000, 1, _radial_loads(60)),
        PanelRun("b) two, 60° apart", "ring_figure07", 0, 1000, 1, _radial_loads(60, 120)),
        PanelRun("c) three, 60° apart", "ring_figure07", 0, 1000, 1, _radial_loads(60, 120, 180)),
        PanelRun("d) at 60°, 120°, 240°", "ring_figure07", 0, 1000, 1, _radial_loads(60, 120, 240)))),
    "09": PanelFigure("A tangential spring-mass rubs on the ring", (
        PanelRun("a) µ = 0.01", "ring_figure09", 0, 1500, 0, _mu(0.01)),
        PanelRun("b) µ = 0.1", "ring_figure09", 0, 1500, 0, _mu(0.1)))),
    "10": PanelFigure("A spring-mass with both motions", (
        PanelRun("a) µ = 0.1", "ring_figure10", 0, 2000, 0),
        PanelRun("b) zoom", "ring_figure10", 0, 1000, 10))),
    "11": PanelFigure("A spring-mass with both motions, µ = 0.1", (
        PanelRun("a) k_r = 10⁷, k_t = 10⁶ N/m", "ring_figure10", 0, 2500, 0, ("loads.0.radial_stiffness_n_per_m=1e7",)),
        PanelRun("b) k_r = 10⁶, k_t = 10⁷ N/m", "ring_figure10", 0, 3500, 0, ("loads.0.tangential_stiffness_n_per_m=1e7",)))),
    "12": PanelFigure("Two spring-masses, µ = 0.1", (
        PanelRun("a) 60° apart", "ring_figure12", 0, 2000, 0),
        PanelRun("b) 180° apart", "ring_figure12", 0, 2000, 0, ("loads.1.angle_deg=240",)))),
    "13": PanelFigure("Three spring-masses, µ = 0.1", (
        PanelRun("a) 60° apart", "ring_figure13", 0, 2000, 0),
        PanelRun("b) at 60°, 120°, 240°", "ring_figure13", 0, 2000, 0, ("loads.2.angle_deg=240",)))),
    "14": PanelFigure("Two unlike spring-masses, µ = 0.1", (
        PanelRun("k_t = 10⁷ and 10⁶ N/m", "ring_figure14", 0, 3500, 0),)),
    "15": RegionFigure("Where a second spring-mass couples with the one at 60°", "ring_figure15"),
    "16": PanelFigure("From divergence to flutter of two spring-masses, µ = 0.1", (
        PanelRun("Zoom of figure 12a", "ring_figure12", 900, 1250, 0),)),
    "17": PanelFigure("A spring-mass and a beam of the same frequencies, µ = 0.1", (
        PanelRun("a) spring-mass", "ring_figure17", 0, 2500, 0),
        PanelRun("b) beam", "ring_figure17", 0, 2500, 0, _BEAM))),
    "18": PanelFigure("An inclined beam (20 Hz) on a ring (30 Hz), µ = 0.1", _inclined(0, 6000)),
    "19": PanelFigure("Zooms of figure 18", _inclined(60, 2500)),
    "20": ChartFigure("Onsets over the inclination of the beam, µ = 0.1", "ring_figure20", ("0", "89"), "6000"),
    "21": ChartFigure("Coupling with the forward mode and divergence of the beam, µ = 0.1", "ring_figure20", ("0", "89"),
                      "3000"),
}
FIGURES = {f"ring_figure{number}": figure for number, figure in FIGURES.items()}
