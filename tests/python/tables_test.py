import tempfile
import unittest
from pathlib import Path

from rubsweep.tables import read_table, unit_of


class Tables(unittest.TestCase):
    def test_units_stand_at_the_end_of_names(self):
        for name, unit in (("speed_hz", "Hz"), ("amplitude_1x_forward_m", "m"), ("vx_m_per_s", "m/s"), ("t_s", "s"),
                           ("lyapunov_per_revolution", "1/revolution"), ("revolutions", "revolution"), ("whirl_ratio", "1"),
                           ("contact_fraction", "1"), ("inertia_kg_m2_per_s", "kg m^2/s"), ("speed_rpm", "1/min"),
                           ("stiffness_n_per_m", "N/m"), ("order", "1"), ("m", "m"), ("share_per", "1")):
            with self.subTest(name):
                self.assertEqual(unit_of(name), unit)

    def test_a_table_has_its_head_units_and_categories(self):
        with tempfile.TemporaryDirectory() as directory:
            path = Path(directory) / "t.csv"
            path.write_text("# program 1\n# digest x\nt_s,class,order\n0.5,chaotic,\n1,chaotic,2\n")
            table = read_table(path)
        self.assertEqual(table.attrs["head"], ["program 1", "digest x"])
        self.assertEqual(table.attrs["units"], {"t_s": "s", "order": "1"})
        self.assertEqual(str(table["class"].dtype), "category")
        self.assertEqual(list(table["t_s"]), [0.5, 1.0])
        self.assertTrue(table["order"].isna()[0])
