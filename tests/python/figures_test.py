import unittest
from pathlib import Path

import rubsweep
from rubsweep.figures import motion_kinds

try:
    import matplotlib
    matplotlib.use("Agg")
except ImportError:
    matplotlib = None

MINIMAL = Path(__file__).resolve().parents[2] / "configs" / "minimal.yaml"


@unittest.skipIf(matplotlib is None, "no matplotlib (Debian package: python3-matplotlib)")
class Figures(unittest.TestCase):
    def test_a_cell_has_the_colour_of_its_kind(self):
        rub = rubsweep.run(MINIMAL, sweep__speed_hz__count=4)
        axes = rubsweep.plot(rub)
        mesh = axes.collections[0]
        axes.figure.canvas.draw()
        colours = mesh.get_facecolors().reshape(*rub["kind"].shape, 4)
        kinds = motion_kinds()
        for place, name in zip(((u, s) for u in range(4) for s in range(4)), rub["kind"].values.ravel()):
            self.assertEqual(matplotlib.colors.to_hex(colours[place]).upper(), kinds[name]["colour"].upper())
        self.assertEqual(axes.get_xlabel(), "speed (Hz)")
        self.assertEqual(axes.get_ylabel(), "whirl ratio")
        self.assertEqual({text.get_text() for text in axes.get_legend().get_texts()},
                         {kinds[name]["label"] for name in rub["kind"].values.ravel()})
