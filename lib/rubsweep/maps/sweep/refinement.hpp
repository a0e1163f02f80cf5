#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "rubsweep/core/model/key.hpp"

namespace rubsweep::sweep {

struct Grid;

/// Options of a refined map, which computes a coarse lattice of cells, and further cells only where labels
/// differ.
struct Refinement {
  int levels = 1;  ///< the lattice has every 2^levels-th cell of each axis, and the last cell
  int probes = 0;  ///< further cells inside every block of the lattice, to find islands

  static void visit_fields(auto& self, auto&& visit) {
    visit("levels", self.levels,
          key(model::IntegerRange{1, 12}, "the map begins with every 2^levels-th cell of both axes",
              model::needed));
    visit("probes", self.probes,
          key(model::IntegerRange{0, 1000}, "further cells inside every block between those lines"));
  }
};

inline constexpr int unknown_label = -1;  ///< Label of a cell that was not computed.

/// Cells that a refined map needs next, ascending; empty when the map is complete. `labels` has one number
/// for each cell of the grid: unknown_label, or any other number, equal for cells with the same motion.
///
/// A block is a rectangle of cells between lattice lines. It is not split if all its known labels are equal:
/// those of its corners, its probes, and cells on its edges that its neighbours needed. Any other block is
/// split in the middle of both sides, until its corners are neighbouring cells. The first two axes with
/// several values span the blocks; each combination of values on the other axes has its own blocks. A cell
/// that was needed once stays needed, whatever is found later. In the end the same cells are therefore
/// computed, in any order and after any interruption.
std::vector<std::size_t> wanted_cells(const Grid& grid, std::span<const int> labels);

/// Refinement level at which a cell is first needed; 0 for the lattice and the probes.
int refinement_level(const Grid& grid, std::size_t cell);

/// Labels of all cells of a complete refined map: those of a block get the common label of its known cells.
std::vector<int> painted_labels(const Grid& grid, std::span<const int> labels);

/// For each cell of a complete refined map, the computed cell whose motion it shows. A computed cell shows
/// its own motion. Any other cell shows that of the last computed cell before it, or the first after it, with
/// the same painted label.
std::vector<std::size_t> shown_cells(const Grid& grid, std::span<const int> labels);

/// Side, in cells, of the smallest square island that surely contains a cell of the lattice or a probe. Where
/// only one axis has several values, it is the length in cells.
std::size_t island_bound(const Grid& grid);

/// Uncertainty exponent a of the boundaries in a complete refined map: the total area of the blocks of one
/// size that are not uniform is proportional to size^a. At 1 the boundaries are lines. Below 1 they are
/// fractal down to the cells, and more levels help little. Empty where fewer than three sizes have such
/// blocks.
std::optional<double> boundary_exponent(const Grid& grid, std::span<const int> labels);

}  // namespace rubsweep::sweep
