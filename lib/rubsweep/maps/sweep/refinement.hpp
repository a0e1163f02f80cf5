#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "rubsweep/core/model/key.hpp"

namespace rubsweep::sweep {

struct Grid;

/// Options of a refined map, which computes a coarse lattice of cells and more of them only where labels
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

/// Label of a cell that was not computed.
inline constexpr int unknown_label = -1;

/// Cells that a refined map needs next, ascending; none when it is complete. `labels` has one number for each
/// cell of the grid: unknown_label, or any other number, equal for cells with the same motion.
///
/// A block is a rectangle of cells between lattice lines. It stays as it is if all known labels in it are
/// equal: of its corners, its probes, and cells on its edges that its neighbours needed. Any other block is
/// split in the middle of both sides, until its corners are neighbouring cells. The first two axes with
/// several values span the blocks, and each combination of the other axes has blocks of its own. A cell once
/// needed stays needed whatever else becomes known, so that in the end the same cells are computed in any
/// order and after any interruption.
std::vector<std::size_t> wanted_cells(const Grid& grid, std::span<const int> labels);

/// Refinement level at which a cell is first needed; 0 for the lattice and the probes.
int refinement_level(const Grid& grid, std::size_t cell);

/// Labels of all cells of a complete refined map. The common label of a block's known cells holds for all its
/// cells.
std::vector<int> painted_labels(const Grid& grid, std::span<const int> labels);

/// For each cell of a complete refined map the computed cell whose motion it shows. That is the cell itself
/// if computed, else the last cell before it, or the first after it, with its painted label.
std::vector<std::size_t> shown_cells(const Grid& grid, std::span<const int> labels);

/// Side, in cells, of the smallest square island that surely has a cell of the lattice or a probe in it.
/// Where only one axis has several values, the length in cells.
std::size_t island_bound(const Grid& grid);

/// Uncertainty exponent a of the boundaries in a complete refined map: the area of all blocks of a size that
/// are not uniform grows as size^a. At 1 the boundaries are lines. Below 1 they are fractal down to the
/// cells, and more levels gain little. Empty where fewer than three sizes have such blocks.
std::optional<double> boundary_exponent(const Grid& grid, std::span<const int> labels);

}  // namespace rubsweep::sweep
