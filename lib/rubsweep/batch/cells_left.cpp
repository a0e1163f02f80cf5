#include "rubsweep/batch/cells_left.hpp"

#include <algorithm>

namespace rubsweep::batch {
namespace {

/// Small enough to look at all of them ten times a second.
constexpr std::size_t most_tiles = 4096;

/// So many measured cells of a neighbourhood count as much as the wider one around it.
constexpr double weight_of_wider = 0.5;

constexpr std::size_t tiles_along(std::size_t cells, std::size_t side) { return (cells - 1) / side + 1; }

}  // namespace

CellsLeft::CellsLeft(std::size_t columns, std::size_t rows, std::span<const std::size_t> cells)
    : columns_(columns), left_(cells.size()) {
  while (tiles_along(columns, side_) * tiles_along(rows, side_) > most_tiles) ++side_;
  width_ = tiles_along(columns, side_);
  height_ = tiles_along(rows, side_);
  tiles_.resize(width_ * height_);
  for (const std::size_t cell : cells) ++tiles_[tile_of(cell)].left;
}

std::size_t CellsLeft::tile_of(std::size_t cell) const {
  return cell / columns_ / side_ * width_ + cell % columns_ / side_;
}

void CellsLeft::finish(std::size_t cell, std::optional<double> seconds) {
  Tile& tile = tiles_[tile_of(cell)];
  --left_;
  ++finished_;
  --tile.left;
  if (!seconds) return;
  tile.seconds += *seconds;
  ++tile.measured;
}

std::vector<CellsLeft::Tile> CellsLeft::corner_sums() const {
  const std::size_t corners = width_ + 1;
  std::vector<Tile> sums(corners * (height_ + 1));
  for (std::size_t y = 0; y < height_; ++y) {
    Tile row;
    for (std::size_t x = 0; x < width_; ++x) {
      const Tile &tile = tiles_[y * width_ + x], &above = sums[y * corners + x + 1];
      row.seconds += tile.seconds;
      row.measured += tile.measured;
      sums[(y + 1) * corners + x + 1] = {above.seconds + row.seconds, above.measured + row.measured, 0};
    }
  }
  return sums;
}

double CellsLeft::finished_s() const {
  const Tile all = corner_sums().back();
  return all.measured == 0 ? 0
                           : all.seconds * static_cast<double>(finished_) / static_cast<double>(all.measured);
}

std::optional<double> CellsLeft::one_by_one_s() const {
  const std::vector<Tile> sums = corner_sums();
  const Tile& all = sums.back();
  if (all.measured == 0) return std::nullopt;
  const std::size_t corners = width_ + 1;
  std::size_t widest = 1;
  while (2 * widest < std::max(width_, height_)) widest *= 2;
  double seconds = 0;
  for (std::size_t i = 0; i < tiles_.size(); ++i) {
    if (tiles_[i].left == 0) continue;
    const std::size_t x = i % width_, y = i / width_;
    double mean = all.seconds / static_cast<double>(all.measured);
    for (std::size_t reach = widest; reach > 0; reach /= 2) {
      const std::size_t left = x - std::min(x, reach), right = std::min(x + reach + 1, width_),
                        above = (y - std::min(y, reach)) * corners,
                        below = std::min(y + reach + 1, height_) * corners;
      const double near_s = sums[below + right].seconds - sums[above + right].seconds -
                            sums[below + left].seconds + sums[above + left].seconds;
      const std::size_t near = sums[below + right].measured - sums[above + right].measured -
                               sums[below + left].measured + sums[above + left].measured;
      mean = (near_s + weight_of_wider * mean) / (static_cast<double>(near) + weight_of_wider);
    }
    seconds += static_cast<double>(tiles_[i].left) * mean;
  }
  return seconds;
}

}  // namespace rubsweep::batch
