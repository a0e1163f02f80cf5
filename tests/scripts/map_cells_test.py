from files import FileTest
from map_cells import COLUMNS, read_map
from sample_machine import cell, circle, oval


class ReadMap(FileTest):
    def test_reads_columns_by_name(self):
        names = ",".join(reversed(COLUMNS)) + ",proof\n"
        path = self.write("map.csv", names + "34,1.5,0.5,1e-5,1e-3,0.3,0.5,,complex,2,subharmonic,0.2,75,floquet\n"
                          ",,,,,,,,,,failed,0.1,45,\n,,,,,,,,,,failed,,45,\n")
        first, failed = read_map(path, 30)
        self.assertEqual((first.speed, first.ratio, first.order, first.hits), (2.5, 0.2, 2, 0.5))
        self.assertEqual((first.amplitude_1x_m, first.dominant_order, first.comb_spacing), (1e-3, 0.5, None))
        self.assertEqual((first.backward_1x_m, first.contact_fraction, first.farthest, first.last_contact), (1e-5, 0.3, 1.5, 34))
        self.assertEqual((failed.order, failed.hits), (None, 0))


class Kinds(FileTest):
    def test_a_circle_is_one_line(self):
        self.assertTrue(circle(2, 0.5).synchronous_circle())
        flat = {"order": 1, "orbit": "oval", "amplitude_m": 1e-3}
        self.assertTrue(cell(2, 0.5, "synchronous", **flat, backward_m=0.9e-4).synchronous_circle())
        self.assertFalse(cell(2, 0.5, "synchronous", **flat, backward_m=1.1e-4).synchronous_circle())
        self.assertFalse(cell(2, 0.5, "subharmonic", **flat).synchronous_circle())

    def test_a_little_2x_is_let_pass_in_contact_all_along(self):
        self.assertTrue(cell(2, 0.5, "synchronous", 1, contact=1.0).synchronous_circle())
        self.assertFalse(cell(2, 0.5, "synchronous", 1, contact=0.9).synchronous_circle())
        self.assertFalse(cell(2, 0.5, "synchronous", 1, contact=1.0, dominant=2.0).synchronous_circle())

    def test_ovals(self):
        self.assertTrue(oval(5, 0.5).oval())
        self.assertFalse(cell(5, 0.5, "quasi_periodic", orbit="oval").oval())
        self.assertFalse(oval(5, 0.5).synchronous_oval())
        self.assertTrue(cell(5, 0.5, "quasi_periodic", comb=1.9).synchronous_oval())
        self.assertTrue(cell(5, 0.5, "synchronous", 1, orbit="oval", backward_m=1e-3).synchronous_oval())
        self.assertFalse(circle(5, 0.5).synchronous_oval())
        self.assertFalse(cell(5, 0.5, "synchronous", 1, backward_m=1e-3).synchronous_oval())

    def test_what_rubs(self):
        self.assertTrue(cell(2, 0.5, "unsettled").rubs())
        for name in ("non_contact", "initial_contact", "failed"):
            self.assertFalse(cell(2, 0.5, name).rubs())
