import contextlib
import io

import aperiodic_cells
from files import FileTest

MAP = """# a map
class,speed_hz,whirl_ratio,lyapunov_per_revolution,status,comb_spacing
chaotic,45,0.07052631578947369,0.18234,ok,
quasi_periodic,48,0.1,,ok,0.6
quasi_periodic,48.5,0.1,-0.0001234,ok,
unsettled,51,0.2,,spectrum,
subharmonic,54,0.2,,ok,
"""


class AperiodicCells(FileTest):
    def test_lists_all_but_periodic_cells_and_ovals(self):
        said = io.StringIO()
        with contextlib.redirect_stdout(said):
            aperiodic_cells.main([self.write("name/map.csv", MAP)])
        self.assertEqual(
            said.getvalue().split("\n"),
            [
                "map,speed_hz,whirl_ratio,class,lyapunov_per_revolution,status",
                "name,45,0.071,chaotic,0.18,ok",
                "name,48.5,0.100,quasi_periodic,-0.00012,ok",
                "name,51,0.200,unsettled,,spectrum",
                "",
            ],
        )
