from files import FileTest
from map_cells import COLUMNS, read_map
from sample_machine import cell, circle, oval


class ReadMap(FileTest):
    def test_reads_columns_by_name(self):
        names = ",".join(reversed(COLUMNS)) + ",proof\n"
        path = self.write("map.csv", names + "0.5,1e-3,0.5,,complex,2,subharmonic,0.2,75,floquet\n,,,,,,failed,0.1,45,\n,,,,,,failed,,45,\n")
        first, failed = read_map(path, 30)
        self.assertEqual((first.speed, first.ratio, first.order, first.hits), (2.5, 0.2, 2, 0.5))
        self.assertEqual((first.amplitude_1x_m, first.dominant_order, first.comb_spacing), (1e-3, 0.5, None))
        self.assertEqual((failed.order, failed.hits), (None, 0))


class Kinds(FileTest):
    def test_a_domains_own_motion_hits_once_in_n_turns(self):
        self.assertTrue(cell(2.2, 0.2, "subharmonic", 2, 0.5).own_domain())
        self.assertFalse(cell(2.2, 0.2, "subharmonic", 2, 1.0).own_domain())
        self.assertFalse(cell(2.2, 0.2, "chaotic").own_domain())

    def test_circles_and_ovals(self):
        self.assertTrue(circle(2, 0.5).synchronous_circle())
        self.assertFalse(cell(2, 0.5, "synchronous", 1).synchronous_circle())
        self.assertTrue(oval(5, 0.5).oval())
        self.assertFalse(cell(5, 0.5, "quasi_periodic", orbit="oval").oval())

    def test_what_rubs(self):
        self.assertTrue(cell(2, 0.5, "unsettled").rubs())
        for name in ("non_contact", "initial_contact", "failed"):
            self.assertFalse(cell(2, 0.5, name).rubs())
