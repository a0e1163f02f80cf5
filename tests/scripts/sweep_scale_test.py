from files import FileTest
from sweep_scale import grid, table_row


class Grid(FileTest):
    def test_the_product_is_the_number_of_cells(self):
        for cells, found in ((1000, (40, 25)), (1000000, (1000, 1000)), (7, (7, 1)), (12, (4, 3))):
            self.assertEqual(grid(cells), found)


class TableRow(FileTest):
    def test_row(self):
        rows = [{"class": "non_contact"}, {"class": "chaotic"}, {"class": "failed"}, {"class": "non_contact"}]
        self.assertEqual(table_row(1000, 0.5, rows), "| 4 | 50 % | 1.0 | 0.50 | 8 |")
