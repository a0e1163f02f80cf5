#include "rubsweep/analysis/page/findings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <utility>

#include "rubsweep/core/error.hpp"
#include "rubsweep/core/model/speed_text.hpp"
#include "rubsweep/core/response/motion/motion_class.hpp"

namespace rubsweep::page {
namespace {

using response::motion::MotionClass;

using Rows = std::vector<std::size_t>;

class Words {
 public:
  Words(const MapTable& map, const sweep::Grid& grid)
      : map_(map), measure_(grid.measure), keys_(sweep::key_names(grid)) {}

  Rows rows_where(const std::function<bool(std::size_t)>& holds) const {
    Rows rows;
    for (std::size_t row = 0; row < map_.rows; ++row)
      if (holds(row)) rows.push_back(row);
    return rows;
  }

  std::string share(const Rows& rows) const {
    const double percent = 100.0 * static_cast<double>(rows.size()) / static_cast<double>(map_.rows);
    return fmt::format("{} cell{} ({:.1f} %)", rows.size(), rows.size() == 1 ? "" : "s", percent);
  }

  double speed(std::size_t row) const { return map_.number("speed_hz", row).value_or(0); }
  double unbalance(std::size_t row) const { return map_.number(to_string(measure_), row).value_or(0); }
  std::string amount(double unbalance) const {
    return measure_ == sweep::UnbalanceMeasure::whirl_ratio
               ? fmt::format("whirl ratio {:.4g}", unbalance)
               : fmt::format("eccentricity {:.4g} mm", 1e3 * unbalance);
  }
  std::string place(std::size_t row) const {
    std::string text = fmt::format("{} and {}", model::speed_text(speed(row), 4), amount(unbalance(row)));
    for (const std::string& key : keys_)
      text += fmt::format(", {} {:.4g}", key, map_.number(key, row).value_or(0));
    return text;
  }
  std::string speeds(const Rows& rows) const {
    const auto [low, high] =
        std::minmax_element(rows.begin(), rows.end(), [&](auto a, auto b) { return speed(a) < speed(b); });
    if (speed(*low) == speed(*high)) return "at " + model::speed_text(speed(*low), 4);
    return "from " + model::speed_range_text(speed(*low), speed(*high), 4);
  }

  /// Name of the motion of a row, such as "subharmonic 1/3" or "quasi-periodic".
  std::string motion(std::size_t row) const {
    std::string name(map_.word("class", row));
    std::replace(name.begin(), name.end(), '_', '-');
    const double order = map_.number("order", row).value_or(1);
    return order > 1 ? fmt::format("{} 1/{}", name, order) : name;
  }

 private:
  const MapTable& map_;
  sweep::UnbalanceMeasure measure_;
  std::vector<std::string> keys_;
};

/// Plural of a word. Keys of the configuration stay unchanged.
std::string plural(const std::string& name) {
  return name.find_first_of("._") == std::string::npos ? name + "s" : "values of " + name;
}

std::string axis(std::vector<double> values, const std::string& name, const std::string& unit, double scale) {
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  if (values.size() == 1) return fmt::format("{} {:.4g}{}", name, scale * *low, unit);
  return fmt::format("{} {} from {:.4g} to {:.4g}{}", values.size(), plural(name), scale * *low,
                     scale * *high, unit);
}

std::string speed_axis(const std::vector<double>& values) {
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  if (values.size() == 1) return "speed " + model::speed_text(*low, 4);
  return fmt::format("{} speeds from {}", values.size(), model::speed_range_text(*low, *high, 4));
}

std::string size_of(const MapTable& map, const sweep::Grid& grid) {
  const std::string speed = speed_axis(grid.speed_hz);
  const std::string unbalance = grid.measure == sweep::UnbalanceMeasure::whirl_ratio
                                    ? axis(grid.unbalance, "whirl ratio", "", 1)
                                    : axis(grid.unbalance, "eccentricity value", " mm", 1e3);
  std::string keys;
  for (const sweep::KeyAxis& swept : grid.axes) keys += ", " + axis(swept.values, swept.keys.front(), "", 1);
  return fmt::format("{} cells: {}, {}{}.", map.rows, speed, unbalance, keys);
}

/// Row out of `rows` with the largest number in a column; empty where no row has a number there.
std::optional<std::size_t> largest(const MapTable& map, const Rows& rows, std::string_view column) {
  std::optional<std::size_t> best;
  for (const std::size_t row : rows) {
    const auto value = map.number(column, row);
    if (value && (!best || *value > *map.number(column, *best))) best = row;
  }
  return best;
}

void add_rub(const MapTable& map, const Words& words, const Rows& rub, std::vector<std::string>& said) {
  if (rub.empty()) {
    said.emplace_back("Rub lasts in no cell.");
    return;
  }
  const auto lowest = *std::min_element(
      rub.begin(), rub.end(), [&](auto a, auto b) { return words.unbalance(a) < words.unbalance(b); });
  said.push_back(fmt::format("Rub lasts in {}, {}; the smallest unbalance with it is {}, at {}.",
                             words.share(rub), words.speeds(rub), words.amount(words.unbalance(lowest)),
                             model::speed_text(words.speed(lowest), 4)));
  std::map<std::string, Rows> by_motion;
  for (const std::size_t row : rub) by_motion[words.motion(row)].push_back(row);
  const auto most = std::max_element(by_motion.begin(), by_motion.end(), [](const auto& a, const auto& b) {
    return a.second.size() < b.second.size();
  });
  said.push_back(fmt::format("The most frequent rub is {}: {}, {}.", most->first, words.share(most->second),
                             words.speeds(most->second)));
  if (const auto row = largest(map, rub, "peak_contact_force_n"))
    said.push_back(fmt::format("The largest contact force is {:.4g} N, at {} ({}).",
                               *map.number("peak_contact_force_n", *row), words.place(*row),
                               words.motion(*row)));
  if (const auto row = largest(map, rub, "peak_displacement_m"))
    said.push_back(fmt::format("The largest displacement is {:.4g} mm, at {} ({}).",
                               1e3 * *map.number("peak_displacement_m", *row), words.place(*row),
                               words.motion(*row)));
}

void add_evidence(const MapTable& map, const Words& words, std::vector<std::string>& said) {
  const auto add = [&](const Rows& rows, const char* sentence) {
    if (!rows.empty()) said.push_back(fmt::format(fmt::runtime(sentence), words.share(rows)));
  };
  const auto proof = [&](std::string_view word) {
    return words.rows_where([&](std::size_t row) { return map.word("proof", row) == word; });
  };
  const auto is = [&](std::string_view word) {
    return words.rows_where([&](std::size_t row) { return map.word("class", row) == word; });
  };
  add(is("chaotic"), "Chaos, by a positive Lyapunov exponent, is found in {}.");
  add(proof("rest"), "In {} it is proven that the rotor never touches again.");
  add(proof("floquet"), "In {} the orbit is proven to attract a ball about it that the run has entered.");
  add(proof("floquet_observed"),
      "In {} the multipliers say that the orbit is stable, while no ball about it is proven.");
  add(proof("observed"), "In {} the verdict rests on what the last windows show.");
  add(words.rows_where([&](std::size_t row) { return map.word("robust", row) == "no"; }),
      "A kick that differs by a millionth leads to another class in {}.");
  add(is("unsettled"), "Undecided when the run ended: {}.");
  add(is("failed"), "Failed, for the reason that their status names: {}.");
}

}  // namespace

PaintedTable painted_table(const MapTable& map, const sweep::Grid& grid) {
  const std::size_t cells = sweep::cell_count(grid);
  PaintedTable table{{map.version, map.digest, cells, {}}, {}, std::vector<int>(cells, sweep::unknown_label)};
  std::vector<std::size_t> row_of(cells, map.rows);
  std::map<std::pair<std::string_view, double>, int> numbers;
  for (std::size_t row = 0; row < map.rows; ++row) {
    const std::size_t cell = map.cells[row];
    const std::pair name(map.word("class", row), map.number("order", row).value_or(0));
    table.labels[cell] = numbers.try_emplace(name, static_cast<int>(numbers.size())).first->second;
    row_of[cell] = row;
    table.computed.push_back(cell);
  }
  if (const auto wanted = sweep::wanted_cells(grid, table.labels); !wanted.empty())
    throw IoError(fmt::format("map.csv: lacks {} cells that its refined map wants", wanted.size()));
  std::ranges::sort(table.computed);
  const std::vector<std::size_t> shown = sweep::shown_cells(grid, table.labels);

  constexpr std::array<std::string_view, 5> of_the_block{"class", "order", "orbit", "whirl", "comb_spacing"};
  const std::vector<sweep::KeyValue> place = sweep::columns_of_place(grid, 0);
  for (const MapColumn& column : map.columns) {
    const bool of_block = std::ranges::find(of_the_block, column.name) != of_the_block.end();
    const auto axis = std::ranges::find(place, column.name, &sweep::KeyValue::key);
    MapColumn& whole = table.map.columns.emplace_back(MapColumn{column.name, {}, {}});
    for (std::size_t cell = 0; cell < cells; ++cell) {
      const bool known = row_of[cell] < map.rows;
      const std::size_t row = row_of[shown[cell]];
      if (!column.numbers.empty()) {
        const double empty = std::numeric_limits<double>::quiet_NaN();
        whole.numbers.push_back(
            axis != place.end()
                ? sweep::columns_of_place(grid, cell).at(static_cast<std::size_t>(axis - place.begin())).value
            : known || of_block ? column.numbers[row]
                                : empty);
      } else {
        whole.words.push_back(known || of_block         ? column.words[row]
                              : column.name == "status" ? std::string(not_computed)
                                                        : std::string());
      }
    }
  }
  return table;
}

std::vector<std::string> findings(const MapTable& map, const sweep::Grid& grid) {
  const Words words(map, grid);
  std::vector<std::string> said{size_of(map, grid)};
  const auto rubs = [&](std::size_t row) {
    const std::string_view motion = map.word("class", row);
    // Cells that were not computed have no measures, so that only their class is used.
    if (map.word("status", row) == not_computed) {
      const auto motion_class = response::motion::motion_class_of(motion);
      return motion_class && *motion_class != MotionClass::unsettled && row_of(*motion_class).rubs;
    }
    return motion != "non_contact" && map.number("contact_fraction", row).value_or(0) > 0;
  };
  add_rub(map, words, words.rows_where(rubs), said);
  add_evidence(map, words, said);
  return said;
}

}  // namespace rubsweep::page
