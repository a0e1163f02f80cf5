#include "rubsweep/analysis/page/orbits.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "rubsweep/analysis/page/compressed.hpp"
#include "rubsweep/core/contact/wall.hpp"
#include "rubsweep/core/error.hpp"
#include "rubsweep/core/scene/build_scene.hpp"
#include "rubsweep/maps/batch/parallel_run.hpp"

namespace rubsweep::page {
namespace {

struct Miss {
  std::size_t place = 0;
  double distance = 0;
};

/// Sample between `first` and `last` at which the straight line between these two has its largest error.
Miss largest_miss(std::span<const std::vector<double>> signals, std::size_t first, std::size_t last) {
  Miss worst;
  for (std::size_t k = first + 1; k < last; ++k) {
    const double share = static_cast<double>(k - first) / static_cast<double>(last - first);
    for (const std::vector<double>& signal : signals) {
      const double line = signal[first] + share * (signal[last] - signal[first]);
      const double distance = std::abs(signal[k] - line);
      if (distance > worst.distance) worst = {k, distance};
    }
  }
  return worst;
}

double extent(std::span<const double> values) {
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  return *high - *low;
}

/// Samples on both sides of each sign change of a gap.
std::vector<std::size_t> changes_of_contact(const SettledOrbit& orbit) {
  std::vector<std::size_t> places;
  for (std::size_t k = 1; k < orbit.signals.front().size(); ++k) {
    bool changes = false;
    for (std::size_t i = 4; i < orbit.signals.size(); i += 3)
      changes = changes || (orbit.signals[i][k - 1] < 0) != (orbit.signals[i][k] < 0);
    if (!changes) continue;
    if (places.empty() || places.back() != k - 1) places.push_back(k - 1);
    places.push_back(k);
  }
  return places;
}

void append_gaps(std::string& bytes, std::span<const std::size_t> places) {
  std::string gaps;
  for (std::size_t i = 0; i < places.size(); ++i)
    append(gaps, static_cast<std::uint16_t>(i == 0 ? places[0] : places[i] - places[i - 1]));
  append_planes(bytes, gaps, 2);
}

void append_signals(std::string& bytes, const SettledOrbit& orbit) {
  const double tolerance = drawing_tolerance * std::max(extent(orbit.signals[0]), extent(orbit.signals[1]));
  const std::vector<std::size_t> places = needed_samples(orbit.signals, tolerance, changes_of_contact(orbit));
  append(bytes, static_cast<std::uint16_t>(places.size()));
  append(bytes, static_cast<std::uint16_t>(orbit.signals.size()));
  append_gaps(bytes, places);
  for (const std::vector<double>& signal : orbit.signals) {
    std::vector<double> kept;
    for (const std::size_t place : places) kept.push_back(signal[place]);
    append_levels(bytes, kept);
  }
}

void append_section(std::string& bytes, const SettledOrbit& orbit) {
  std::vector<double> x, y;
  for (const std::complex<double>& point : orbit.section_m) {
    x.push_back(point.real());
    y.push_back(point.imag());
  }
  append(bytes, static_cast<std::uint16_t>(x.size()));
  append_levels(bytes, x);
  append_levels(bytes, y);
}

void append_spectrum(std::string& bytes, const response::spectrum::FullSpectrum& spectrum) {
  const int reach = static_cast<int>(highest_order * spectrum.turns);
  const int first = std::max(spectrum.first_line(), -reach), last = std::min(spectrum.last_line(), reach);
  double largest = 0;
  for (int k = first; k <= last; ++k) largest = std::max(largest, spectrum.amplitude(k));
  std::string lines, amplitudes;
  std::uint16_t count = 0;
  for (int k = first; k <= last; ++k) {
    if (largest == 0 || spectrum.amplitude(k) < smallest_line * largest) continue;
    ++count;
    append(lines, static_cast<std::uint16_t>(k));
    append(amplitudes, static_cast<std::uint16_t>(std::lround(65535 * spectrum.amplitude(k) / largest)));
  }
  append(bytes, static_cast<std::uint16_t>(spectrum.turns));
  append(bytes, count);
  append(bytes, static_cast<float>(largest));
  bytes += lines + amplitudes;
}

/// Number of values that remain of `count` values at this stride.
std::size_t left(std::size_t count, std::size_t stride) {
  const std::size_t first = stride / 2;
  return first < count ? (count - first - 1) / stride + 1 : 0;
}

thread_local response::motion::Workspace orbit_workspace;

KnownMotion known_motion(const MapTable& map, std::size_t row) {
  KnownMotion known{map.word("class", row), std::nullopt, 0, false};
  if (const auto order = map.number("order", row)) known.order = static_cast<int>(*order);
  known.revolutions = static_cast<long>(map.number("revolutions", row).value_or(0));
  known.proven = map.word("proof", row).starts_with("floquet");
  known.hertz_force_n = map.number("hertz_force_n", row);
  return known;
}

std::vector<Wall> walls_of(const model::Machine& machine, double speed_hz) {
  const scene::Cell cell = scene::build_cell(machine, speed_hz, scene::Eccentricity{0});
  std::vector<Wall> walls;
  for (const scene::Contact& contact : cell.scene.contacts) {
    const contact::Outline outline = contact::outline(contact.wall);
    walls.push_back({.around = outline.around,
                     .normal = {outline.normal.x(), outline.normal.y()},
                     .centre_m = {outline.centre.x(), outline.centre.y()},
                     .clearance_m = contact.clearance_m,
                     .at_orbit = contact.rotor_point == cell.scene.observed_point});
  }
  return walls;
}

}  // namespace

std::vector<std::size_t> needed_samples(std::span<const std::vector<double>> signals, double tolerance,
                                        std::span<const std::size_t> always) {
  const std::size_t end = signals.front().size() - 1;
  std::vector<std::size_t> places{0};
  for (const std::size_t place : always)
    if (place > places.back() && place < end) places.push_back(place);
  places.push_back(end);

  std::vector<std::pair<std::size_t, std::size_t>> waiting;
  for (std::size_t i = 1; i < places.size(); ++i) waiting.emplace_back(places[i - 1], places[i]);
  while (!waiting.empty()) {
    const auto [first, last] = waiting.back();
    waiting.pop_back();
    const Miss miss = largest_miss(signals, first, last);
    if (miss.distance <= tolerance) continue;
    places.push_back(miss.place);
    waiting.emplace_back(first, miss.place);
    waiting.emplace_back(miss.place, last);
  }
  std::sort(places.begin(), places.end());
  return places;
}

void append_levels(std::string& bytes, std::span<const double> values) {
  const double low = values.empty() ? 0 : *std::min_element(values.begin(), values.end());
  // Levels are measured from the rounded floats that are written, so that the rounding does not shift the
  // values.
  const auto base = static_cast<float>(low);
  const auto width = static_cast<float>(values.empty() ? 0 : extent(values) / levels);
  append(bytes, base);
  append(bytes, width);
  std::string differences;
  long before = 0;
  for (const double value : values) {
    const long level =
        width > 0 ? std::lround((value - static_cast<double>(base)) / static_cast<double>(width)) : 0;
    append(differences, static_cast<std::uint16_t>(level - before));
    before = level;
  }
  append_planes(bytes, differences, 2);
}

std::string encode_orbit(std::size_t cell, const SettledOrbit& orbit) {
  std::string body;
  append(body, static_cast<std::uint32_t>(orbit.first_revolution));
  append(body, static_cast<std::uint16_t>(orbit.turns));
  append(body, static_cast<std::uint16_t>(orbit.steps_per_turn));
  append_signals(body, orbit);
  append_section(body, orbit);
  append_spectrum(body, orbit.spectrum);
  std::string bytes;
  append(bytes, static_cast<std::uint32_t>(cell));
  append(bytes, static_cast<std::uint32_t>(body.size()));
  return bytes + body;
}

std::vector<std::size_t> ThinnedGrid::cells() const {
  std::vector<std::size_t> kept;
  for (std::size_t j = unbalance_stride / 2; j < unbalances; j += unbalance_stride)
    for (std::size_t i = speed_stride / 2; i < speeds; i += speed_stride) kept.push_back(j * speeds + i);
  return kept;
}

ThinnedGrid thinned_grid(std::size_t speeds, std::size_t unbalances, std::size_t most) {
  ThinnedGrid grid{speeds, unbalances};
  while (left(speeds, grid.speed_stride) * left(unbalances, grid.unbalance_stride) > most) {
    // Thins the axis with the smaller stride, unless it has only one value left.
    const bool speed = left(unbalances, grid.unbalance_stride) == 1 ||
                       (grid.speed_stride <= grid.unbalance_stride && left(speeds, grid.speed_stride) > 1);
    ++(speed ? grid.speed_stride : grid.unbalance_stride);
  }
  return grid;
}

std::optional<Orbits> record_orbits(const sweep::Study& study, const MapTable& map,
                                    std::vector<std::size_t> cells, int threads,
                                    const std::function<void()>& on_cell, const std::atomic<bool>& stop) {
  const scene::PreparedMachine prepared = scene::prepare_machine(study.machine);
  std::vector<std::string> records(cells.size());
  const std::size_t finished = batch::parallel_run(
      cells.size(), threads,
      [&](std::size_t i) {
        const auto orbit =
            settled_orbit(study, prepared, cells[i], known_motion(map, cells[i]), orbit_workspace);
        if (orbit) records[i] = encode_orbit(cells[i], *orbit);
      },
      [&](std::size_t) { on_cell(); }, stop);
  if (finished != cells.size()) return std::nullopt;

  Orbits orbits{std::move(cells), 0, {}};
  for (std::size_t begin = 0; begin < records.size(); begin += cells_per_block) {
    std::string block;
    for (std::size_t i = begin; i < std::min(begin + cells_per_block, records.size()); ++i) {
      if (!records[i].empty()) ++orbits.recorded;
      block += records[i];
    }
    orbits.blocks.push_back(compressed(block));
  }
  return orbits;
}

Walls walls_of(const sweep::Study& study) {
  const sweep::Grid& grid = study.grid;
  const double speed_hz = grid.speed_hz.front();
  if (grid.axes.empty()) return {{walls_of(study.machine, speed_hz)}, {0}};
  Walls walls;
  const std::size_t plane = grid.speed_hz.size() * grid.unbalance.size();
  for (std::size_t cell = 0; cell < sweep::cell_count(grid); cell += plane) {
    std::vector<Wall> list;
    try {
      list = walls_of(study.with_keys(sweep::key_values(grid, cell)).machine, speed_hz);
    } catch (const ConfigError&) {
      list.clear();
    }
    const auto known = std::ranges::find(walls.lists, list);
    walls.list_of_keys.push_back(static_cast<std::size_t>(known - walls.lists.begin()));
    if (known == walls.lists.end()) walls.lists.push_back(std::move(list));
  }
  return walls;
}

}  // namespace rubsweep::page
