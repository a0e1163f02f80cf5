#include "basin_slice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "rubsweep/core/error.hpp"
#include "rubsweep/core/response/motion/motion_class.hpp"
#include "rubsweep/maps/batch/csv_table.hpp"
#include "rubsweep/maps/report/map_cells.hpp"
#include "rubsweep/maps/sweep/row.hpp"

namespace rubsweep::apps {
namespace {

using batch::csv_number;
using response::motion::MotionClass;

constexpr std::array<const char*, 3> lengths{"peak_displacement_m", "amplitude_1x_forward_m",
                                             "amplitude_1x_backward_m"};

/// Reads the columns of map.csv that distinguish attractors.
class MotionReader {
 public:
  explicit MotionReader(const batch::CsvReader& map)
      : class_(map.column("class")), order_(map.column("order")), status_(map.column("status")) {
    for (std::size_t i = 0; i < lengths.size(); ++i) lengths_[i] = map.column(lengths[i]);
  }

  sweep::SampledMotion motion(const batch::CsvReader& row) const {
    sweep::Row read;
    const auto found = response::motion::motion_class_of(row.cells()[class_]);
    if (!found) {
      throw IoError(fmt::format("{}:{}: '{}' is no class of motion", row.path().string(), row.place().line,
                                row.cells()[class_]));
    }
    read.motion_class = *found;
    const double order = row.number(order_);
    if (!std::isnan(order)) read.order = static_cast<int>(order);
    if (!std::isnan(row.number(lengths_[0]))) {
      read.measures.emplace();
      read.measures->contact.peak_displacement_m = row.number(lengths_[0]);
      read.measures->amplitude_1x_forward_m = row.number(lengths_[1]);
      read.measures->amplitude_1x_backward_m = row.number(lengths_[2]);
    }
    return sweep::sampled_motion(read);
  }

  const std::string& status(const batch::CsvReader& row) const { return row.cells()[status_]; }

 private:
  std::size_t class_, order_, status_;
  std::array<std::size_t, lengths.size()> lengths_{};
};

std::array<std::string, 2> start_at(const SlicePlane& plane, std::size_t index) {
  const std::size_t columns = plane.values[0].size();
  return {csv_number(plane.values[0][index % columns]), csv_number(plane.values[1][index / columns])};
}

std::string shares(const sweep::Basins& basins, std::size_t starts) {
  std::string text;
  int number = 0;
  for (const sweep::Attractor& attractor : basins.attractors) {
    text +=
        fmt::format("{:>8}  {:5.1f} +- {:.1f} %  attractor {}: {}", attractor.samples, 100 * attractor.share,
                    100 * attractor.standard_error, ++number, attractor.motion.name);
    if (attractor.motion.repeats)
      text += fmt::format(", largest displacement {:.4g} mm", 1e3 * attractor.motion.orbit_m.front());
    text += '\n';
  }
  if (basins.failed > 0) {
    text += fmt::format("{:>8}  {:5.1f} %         failed, counted to none\n", basins.failed,
                        100 * static_cast<double>(basins.failed) / static_cast<double>(starts));
  }
  return text;
}

std::string entropies(const basin::LabelGrid& grid, std::size_t labels) {
  if (std::min(grid.columns, grid.rows) < entropy_box)
    return fmt::format("basin entropy: none, the slice has fewer than {0} x {0} starts\n", entropy_box);
  const basin::BasinEntropy entropy = basin::basin_entropy(grid, entropy_box);
  std::string text = fmt::format(
      "basin entropy {:.3f} (0: every box of {} x {} starts leads to one attractor; {:.3f}: all {} mixed "
      "evenly in every box)\n",
      entropy.all, entropy_box, entropy_box, std::log(static_cast<double>(labels)), labels);
  if (entropy.boundary == 0) return text + "boundary basin entropy: none, no box holds a boundary\n";
  return text + fmt::format("boundary basin entropy {:.3f} ({} log 2 = {:.3f}: {})\n", entropy.boundary,
                            entropy.boundary > std::numbers::ln2 ? "above" : "not above", std::numbers::ln2,
                            entropy.boundary > std::numbers::ln2 ? "the boundary is fractal down to this grid"
                                                                 : "it does not show a fractal boundary");
}

std::string exponent(const basin::LabelGrid& grid) {
  const auto found = basin::uncertainty_exponent(grid);
  if (!found)
    return "uncertainty exponent: none, fewer than three sizes of box tell certain from uncertain starts\n";
  return fmt::format(
      "uncertainty exponent {:.2f} +- {:.2f} (1: the boundary is a line; near 0 it is fractal): a start "
      "known twice as "
      "well is uncertain {:.2f} times as often\n",
      found->value, found->standard_error, std::exp2(-found->value));
}

}  // namespace

BasinSlice read_basin_slice(const std::filesystem::path& map, const SlicePlane& plane,
                            const sweep::Grid& grid) {
  batch::CsvReader rows(map);
  const MotionReader reader(rows);
  report::CellsOfRows cells(rows, grid);
  std::vector<sweep::SampledMotion> motions(sweep::cell_count(grid));
  BasinSlice slice{plane, {}, std::vector<std::string>(motions.size())};
  while (rows.next()) {
    const std::size_t start = cells.take(rows);
    motions[start] = reader.motion(rows);
    slice.statuses[start] = reader.status(rows);
  }
  cells.require_all();
  sweep::AttractorCount count;
  for (const sweep::SampledMotion& motion : motions) count.add(motion);
  slice.basins = count.basins();
  return slice;
}

std::string slice_csv(const BasinSlice& slice) {
  const SlicePlane& plane = slice.plane;
  std::string text = fmt::format("{},{},attractor,label,status\n", plane.names[0], plane.names[1]);
  for (std::size_t i = 0; i < slice.statuses.size(); ++i) {
    const auto number = static_cast<std::size_t>(slice.basins.numbers[i]);
    const auto [across, up] = start_at(plane, i);
    text += fmt::format("{},{},{},{},{}\n", across, up, number == 0 ? "" : fmt::format("{}", number),
                        number == 0 ? "failed" : slice.basins.attractors[number - 1].motion.name,
                        slice.statuses[i]);
  }
  return text;
}

std::string attractors_csv(const BasinSlice& slice) {
  const SlicePlane& plane = slice.plane;
  std::string text = fmt::format("attractor,label,starts,share,standard_error,{},{},{},{},{}\n", lengths[0],
                                 lengths[1], lengths[2], plane.names[0], plane.names[1]);
  int number = 0;
  for (const sweep::Attractor& attractor : slice.basins.attractors) {
    ++number;
    const auto first = std::ranges::find(slice.basins.numbers, number);
    const auto [across, up] = start_at(plane, static_cast<std::size_t>(first - slice.basins.numbers.begin()));
    const std::vector<double>& orbit = attractor.motion.orbit_m;
    text +=
        fmt::format("{},{},{},{},{},{},{},{},{},{}\n", number, attractor.motion.name, attractor.samples,
                    csv_number(attractor.share), csv_number(attractor.standard_error),
                    csv_number(orbit.at(0)), csv_number(orbit.at(1)), csv_number(orbit.at(2)), across, up);
  }
  return text;
}

std::string slice_summary(const BasinSlice& slice) {
  const basin::LabelGrid grid = slice.grid();
  const auto& [across, up] = slice.plane.values;
  std::string text = fmt::format("{} x {} starts, {} from {:.6g} to {:.6g}, {} from {:.6g} to {:.6g}\n",
                                 grid.columns, grid.rows, slice.plane.names[0], across.front(), across.back(),
                                 slice.plane.names[1], up.front(), up.back());
  text += shares(slice.basins, grid.labels.size());
  const std::size_t labels = slice.basins.attractors.size() + (slice.basins.failed > 0 ? 1 : 0);
  if (labels < 2) return text + "one attractor: no boundary, and so neither entropy nor exponent\n";
  return text + entropies(grid, labels) + exponent(grid);
}

}  // namespace rubsweep::apps
