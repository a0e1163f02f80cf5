#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "rubsweep/core/model/key.hpp"

namespace rubsweep::sweep {

struct Grid;

/// How a map is computed without most of its cells: from a coarse lattice on, only where labels differ.
struct Refinement {
  int levels = 1;  ///< the lattice holds every 2^levels-th cell of each axis, and the last
  int probes = 0;  ///< further cells inside every block of the lattice, so that islands are met

  static void visit_fields(auto& self, auto&& visit) {
    visit("levels", self.levels,
          key(model::IntegerRange{1, 12}, "the map begins with every 2^levels-th cell of both axes",
              model::needed));
    visit("probes", self.probes,
          key(model::IntegerRange{0, 1000}, "further cells inside every block between those lines"));
  }
};

/// A cell that was not computed, in a span of labels.
inline constexpr int unknown_label = -1;

/// Which cells a refined map needs next, ascending; none when it is complete. `labels`: one for each cell of
/// the grid, unknown_label or any other number, equal where two cells have the same motion.
///
/// A block is a rectangle of cells between lattice lines. One in which all known labels are equal, corners,
/// probes and what its neighbours asked for on its edges, stays as it is; any other is split in the middle of
/// both sides until its corners are neighbours. The first two axes with several values span the blocks; every
/// other axis has maps of its own. What is asked for grows with what is known, so that in the end the same
/// cells are computed in whatever order and after whatever break.
std::vector<std::size_t> wanted_cells(const Grid& grid, std::span<const int> labels);

/// Refinement level at which a cell is first evaluated; 0 on the lattice and for probes.
int refinement_level(const Grid& grid, std::size_t cell);

/// Labels of all cells of a complete refined map: those of a block whose known labels are equal belong to
/// every cell of it.
std::vector<int> painted_labels(const Grid& grid, std::span<const int> labels);

/// For each cell of a complete refined map the computed cell whose motion it shows: itself, or the last one
/// before it, else the first one after it, that has its painted label.
std::vector<std::size_t> shown_cells(const Grid& grid, std::span<const int> labels);

/// Side, in cells, of the smallest square island that none of the cells of the lattice and none of the probes
/// can miss; where one axis alone has several values, as many cells one after the other.
std::size_t island_bound(const Grid& grid);

/// Uncertainty exponent of the boundaries of a complete refined map: the share of the area in blocks of a
/// size that are not uniform grows with that size to this power. 1: lines; less: they are fractal down to the
/// cells, and more levels gain little. Empty where fewer than three sizes have such blocks.
std::optional<double> boundary_exponent(const Grid& grid, std::span<const int> labels);

}  // namespace rubsweep::sweep
