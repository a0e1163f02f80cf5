from files import FileTest
from rubplot import domain_map
from rubplot.csv_table import TableError
from rubplot.domain_map import Cell

HEADER = "whirl_ratio,speed_hz,class,order,orbit,whirl,comb_spacing\n"


class ReadCells(FileTest):
    def cells(self, rows, *arguments):
        return domain_map.read_cells(self.write("map.csv", HEADER + rows), *arguments)

    def test_the_kind_is_that_of_the_map(self):
        path = self.write("map.csv", "whirl_ratio,speed_hz,class,order,kind\n0.1,30,synchronous,1,synchronous_circle\n")
        self.assertEqual([cell.kind for cell in domain_map.read_cells(path, "whirl_ratio")], ["synchronous_circle"])

    def test_speeds_are_over_the_natural_frequency_where_there_is_one(self):
        row = "0.1,45,chaotic,,,,\n"
        self.assertEqual(self.cells(row, "whirl_ratio", 30), [Cell(1.5, 0.1, "chaotic")])
        self.assertEqual(self.cells(row, "whirl_ratio"), [Cell(45, 0.1, "chaotic")])

    def test_a_map_without_cells_or_column_is_refused(self):
        with self.assertRaisesRegex(TableError, "no cells"):
            self.cells(",45,failed,,,,\n", "whirl_ratio")
        with self.assertRaisesRegex(TableError, "no column 'eccentricity_m'"):
            self.cells("0.1,45,chaotic,,,,\n", "eccentricity_m")


class Edges(FileTest):
    def test_cells_reach_half_way_to_their_neighbours(self):
        self.assertEqual(domain_map.edges([1, 2, 4, 2]), {1: (0.5, 1.5), 2: (1.5, 3), 4: (3, 5)})
        low, high = domain_map.edges([1])[1]
        self.assertAlmostEqual(high - low, 0.1)


class Labels(FileTest):
    def block(self, columns, rows, kind):
        return [Cell(x, y, kind) for x in columns for y in rows]

    def test_a_label_stands_in_the_middle_of_its_domain(self):
        cells = self.block(range(5), range(5), "subharmonic_3") + self.block(range(5, 10), range(5), "non_contact")
        self.assertEqual(domain_map.labels(cells), [domain_map.Label(2, 2, "1/3")])

    def test_a_label_hides_no_other_kind(self):
        # 60 columns: a label reaches one cell beyond its own.
        cells = self.block([7], range(5), "subharmonic_2") + self.block([x for x in range(60) if x != 7], range(5), "chaotic")
        self.assertEqual(domain_map.labels(cells), [])
        cells = self.block([6, 7, 8], range(5), "subharmonic_2") + self.block(
            [x for x in range(60) if x not in (6, 7, 8)], range(5), "chaotic"
        )
        self.assertEqual(domain_map.label_text(domain_map.labels(cells)), "7 2 1/2")

    def test_orders_from_eight_on_share_a_kind_and_have_no_label(self):
        self.assertEqual(domain_map.labels(self.block(range(9), range(9), "subharmonic_8")), [])


class CellLines(FileTest):
    def test_a_line_holds_place_edges_and_kind(self):
        lines = list(domain_map.cell_lines([Cell(1, 0.25, "chaotic"), Cell(2, 0.75, "failed")]))
        self.assertEqual(lines, ["1 0.25 0.5 1.5 0 0.5 chaotic 1", "2 0.75 1.5 2.5 0.5 1 failed 1"])

    def test_strength_is_a_share_and_whole_where_there_is_none(self):
        header = "speed_hz,whirl_ratio,class,order,orbit,whirl,comb_spacing,robust_share\n"
        path = self.write("map.csv", header + "30,0.1,chaotic,,complex,mixed,,0.25\n60,0.1,chaotic,,complex,mixed,,\n")
        strengths = [cell.strength for cell in domain_map.read_cells(path, "whirl_ratio", None, "speed_hz", "robust_share")]
        self.assertEqual(strengths, [0.25, 1])
        self.assertEqual([cell.strength for cell in domain_map.read_cells(path, "whirl_ratio")], [1, 1])


class Boundaries(FileTest):
    ROWS = "family,kind,speed_hz,whirl_ratio\n0,fold,30,0.1\n0,fold,60,0.2\n0,fold,,\n1,period_halving,90,0.3\n1,period_halving,,\n"

    def test_lines_by_kind_over_the_natural_frequency(self):
        found = domain_map.read_boundaries(self.write("boundaries.csv", self.ROWS), "whirl_ratio", 30)
        self.assertEqual(found, {"doubling": [[(3, 0.3)]], "fold": [[(1, 0.1), (2, 0.2)]]})

    def test_a_block_for_each_kind_and_a_point_that_is_seen(self):
        lines = domain_map.boundary_lines({"doubling": [[(3, 0.5)]], "fold": [[(1, 0.25), (2, 0.75)]]})
        self.assertEqual(
            [line.split() for line in lines],
            [[], ["3", "0.5"], ["3", "0.5"], [], [], ["1", "0.25"], ["2", "0.75"], []],
        )

    def test_lines_of_another_map_are_left_out(self):
        path = self.write("boundaries.csv", "# rubsweep 0\n# digest abc\n" + self.ROWS)
        self.assertEqual(len(domain_map.read_boundaries(path, "whirl_ratio", 30, "abc")), 2)
        self.assertEqual(domain_map.read_boundaries(path, "whirl_ratio", 30, "abd"), {})

    def test_no_file_no_lines(self):
        self.assertEqual(domain_map.read_boundaries(self.path("none.csv"), "whirl_ratio"), {})
