"""A machine whose maps and traces are written down by the test."""

from map_cells import MapCell


def cell(speed, ratio, name, order=None, hits=0.0, orbit="complex", comb=None, amplitude_m=2e-3, dominant=1.0,
         contact=0.5, backward_m=0.0, farthest=2.0):
    """A cell at `speed` natural frequencies of 30 Hz."""
    return MapCell(30 * speed, speed, ratio, name, order, orbit, comb, hits, contact, amplitude_m, backward_m, dominant,
                   farthest, 12)


def domain(n, ratio, *speeds):
    """1/n cells that hit once in n turns."""
    return [cell(speed, ratio, "subharmonic", n, 1 / n) for speed in speeds]


def quiet(ratio, *speeds):
    return [cell(speed, ratio, "non_contact") for speed in speeds]


def circle(speed, ratio, amplitude_m=2e-3, contact=1.0):
    return cell(speed, ratio, "synchronous", 1, orbit="circle", amplitude_m=amplitude_m, contact=contact)


def oval(speed, ratio, hits=1.0):
    return cell(speed, ratio, "quasi_periodic", orbit="oval", comb=0.6, hits=hits, dominant=0.4)


class SampleMap:
    def __init__(self, cells, **values):
        self.cells = cells
        self.values = {"stops.0.clearance_m": 1e-3, "kick.duration_s": 0.005, **values}

    def number(self, path):
        return self.values[path]

    def gap_share(self):
        return 0.75


class SampleMachine:
    """`traces` answers for trajectory and spectrum: called with the role and the cell."""

    def __init__(self, traces=None, name="sample", **cells):
        self.name = name
        self.maps = {role: SampleMap(found) for role, found in cells.items()}
        self.memory = {}
        self._traces = traces

    def cells(self, role):
        return self.maps[role].cells

    def ratios(self, role):
        return {cell.ratio for cell in self.cells(role)}

    def each(self, function, cells):
        return [function(cell) for cell in cells]

    def trajectory(self, role, cell, names, revolutions=None, last_revolutions=None):
        return self._traces(role, cell)

    def spectrum(self, role, cell):
        return self._traces(role, cell)


def outcome_of(findings, title, machine):
    """Outcome for the machine of the one finding whose title has these words."""
    (finding,) = (one for one in findings if title in one.title)
    return finding.outcome(machine)

