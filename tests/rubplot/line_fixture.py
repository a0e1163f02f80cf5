"""A directory as rubline writes it, of two cells."""

from files import FileTest
from rubplot.line_tables import Line

HEADER = "pass,value,class,order,orbit,whirl,comb_spacing,peak_displacement_m\n"


class LineTest(FileTest):
    def setUp(self):
        super().setUp()
        self.write("config.yaml", "stops:\n  - kind: one_side\n    angle_deg: 90\n    clearance_m: 0.001\n")
        self.write("bifurcation.csv", "pass,value,x_m,y_m\nup,50,0.001,0.002\nup,50,0,-0.003\n")
        self.write("cascade.csv", "pass,value,order,amplitude_m\nup,50,0,9\nup,50,1,0.002\nup,60,-2.5,0.001\nup,60,7,2.5e-9\n")
        self.cells("up,50,subharmonic,2,complex,mixed,,0.004\nup,60,chaotic,,,,,\n")

    def cells(self, rows, comment="# along speed_hz\n"):
        self.write("line.csv", "# rubsweep 1\n" + comment + HEADER + rows)

    def line(self):
        return Line(self.directory)
