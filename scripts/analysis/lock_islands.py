"""The program behind lock_islands.sh, which says what it does."""

from command import run_program
from map_cells import read_map
from rubplot.failure import Failure

LOCK_SPEEDS = (2, 3, 5)
ABOVE = 0.12


def islands(cells):
    """Sets of places (speed, ratio) of the cells that rub."""
    speeds = {speed: i for i, speed in enumerate(sorted({cell.speed for cell in cells}))}
    ratios = {ratio: i for i, ratio in enumerate(sorted({cell.ratio for cell in cells}))}
    left = {(speeds[cell.speed], ratios[cell.ratio]): cell.speed for cell in cells if cell.rubs()}
    found = []
    while left:
        reached, island = [next(iter(left))], []
        while reached:
            place = reached.pop()
            if place in left:
                island.append(left.pop(place))
                i, k = place
                reached += [(i - 1, k), (i + 1, k), (i, k - 1), (i, k + 1)]
        found.append(island)
    return found


def contains_lock_speed(island, step):
    return any(min(island) - step / 2 <= lock <= max(island) + step / 2 for lock in LOCK_SPEEDS)


def begins(cells):
    """Speeds at which a stretch of rub begins, the slowest speed of the map not among them."""
    found, before = [], None
    for cell in sorted(cells, key=lambda cell: (cell.ratio, cell.speed)):
        if before is not None and before.ratio == cell.ratio and cell.rubs() and not before.rubs():
            found.append(cell.speed)
        before = cell
    return found


def just_above(speed):
    return any(0 <= speed / lock - 1 <= ABOVE for lock in LOCK_SPEEDS)


def summary(cells):
    speeds = sorted({cell.speed for cell in cells})
    step = speeds[1] - speeds[0]
    found = islands(cells)
    with_lock = [island for island in found if contains_lock_speed(island, step)]
    first = begins(cells)
    return (f"{len(with_lock)} of {len(found)} islands with a lock speed, {sum(map(len, with_lock))} of "
            f"{sum(map(len, found))} cells; {sum(map(just_above, first))} of {len(first)} stretches begin just above one, "
            f"as {sum(map(just_above, speeds[1:]))} of {len(speeds) - 1} speeds are")


def main(arguments):
    try:
        natural_frequency_hz = float(arguments[0])
    except ValueError:
        raise Failure(f"'{arguments[0]}' is no natural frequency in Hz") from None
    for path in arguments[1:]:
        print(f"{path}: {summary(read_map(path, natural_frequency_hz))}")


if __name__ == "__main__":
    run_program(main, usage="lock_islands.sh NATURAL_FREQUENCY_HZ MAP.csv...", least=2)
