#include "rubsweep/maps/report/map_csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <concepts>
#include <functional>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

#include "rubsweep/core/error.hpp"
#include "rubsweep/maps/batch/csv_table.hpp"
#include "rubsweep/maps/report/study_columns.hpp"

namespace rubsweep::report {
namespace {

using response::motion::Measures;
using sweep::Row;

std::string text_of(const std::string& text) { return text; }
std::string text_of(double value) { return batch::csv_number(value); }
std::string text_of(bool value) { return value ? "yes" : "no"; }
std::string text_of(std::integral auto value) { return fmt::format("{}", value); }

template <class Enum>
requires std::is_enum_v<Enum> std::string text_of(Enum value) { return std::string(to_string(value)); }

template <class Value>
std::string text_of(const std::optional<Value>& value) {
  return value ? text_of(*value) : std::string();
}

/// Text of the member `get` of the row.
template <auto get>
std::string of_row(const Row& row) {
  return text_of(std::invoke(get, row));
}

/// Text of the member `get` of the measures; empty where no motion was measured.
template <auto get>
std::string measured(const Row& row) {
  return row.measures ? text_of(std::invoke(get, *row.measures)) : std::string();
}

std::string kind_name(const Row& row) { return std::string(sweep::kind_of(row).name); }

double hits_per_revolution(const Measures& m) { return static_cast<double>(m.contact.hits) / m.turns; }
double contact_fraction(const Measures& m) { return m.contact.contact_fraction; }
double peak_displacement_m(const Measures& m) { return m.contact.peak_displacement_m; }
double peak_contact_force_n(const Measures& m) { return m.contact.peak_contact_force_n; }

double peak_casing_displacement_m(const Measures& m) { return m.contact.peak_casing_displacement_m; }

std::optional<double> dominant_order(const Measures& m) {
  return m.dominant ? std::optional(m.dominant->order) : std::nullopt;
}

std::optional<double> dominant_amplitude_m(const Measures& m) {
  return m.dominant ? std::optional(m.dominant->amplitude_m) : std::nullopt;
}

std::optional<double> least_mean_life(const Row& row) {
  return row.survival ? std::optional(row.survival->least_mean_life()) : std::nullopt;
}

std::optional<int> escapes(const Row& row) {
  return row.survival ? std::optional(row.survival->escapes) : std::nullopt;
}

using enum Comparison;

constexpr std::array columns{
    MapColumn{"speed_hz", "Hz", key, "shaft speed", of_row<&Row::speed_hz>},
    MapColumn{"whirl_ratio", "", key, "excursion of the quiet motion / clearance left at the first stop",
              of_row<&Row::whirl_ratio>},
    MapColumn{"eccentricity_m", "m", number, "eccentricity of the disc", of_row<&Row::eccentricity_m>},
    MapColumn{"class", "", label, "what the motion is called, see below", of_row<&Row::motion_class>},
    MapColumn{"order", "", label, "n of a motion that repeats after n turns", of_row<&Row::order>},
    MapColumn{"orbit", "", text, "its shape: circle, oval or complex", measured<&Measures::orbit>},
    MapColumn{"whirl", "", text, "its sense: forward, backward or mixed", measured<&Measures::whirl>},
    MapColumn{"proof", "", ignored, "what the class rests on: rest, floquet, floquet_observed or observed",
              of_row<&Row::proof>},
    MapColumn{"robust", "", ignored, "does the class stay when the kick changes by 1e-6? yes or no",
              of_row<&Row::robust>},
    MapColumn{"comb_spacing", "", number, "distance of the lines of a closed comb, in orders",
              measured<&Measures::comb_spacing>},
    MapColumn{"hits_per_revolution", "", number, "changes from open to touching, all stops together",
              measured<hits_per_revolution>},
    MapColumn{"contact_fraction", "", number, "share of the time with a contact touching",
              measured<contact_fraction>},
    MapColumn{"peak_displacement_m", "m", number, "largest distance from the unloaded position",
              measured<peak_displacement_m>},
    MapColumn{"peak_contact_force_n", "N", number, "largest normal force at any one contact",
              measured<peak_contact_force_n>},
    MapColumn{"amplitude_1x_forward_m", "m", number, "line of the full spectrum at +1X",
              measured<&Measures::amplitude_1x_forward_m>},
    MapColumn{"amplitude_1x_backward_m", "m", number, "line of the full spectrum at -1X",
              measured<&Measures::amplitude_1x_backward_m>},
    MapColumn{"dominant_order", "", number, "order of the largest line but 0X", measured<dominant_order>},
    MapColumn{"dominant_amplitude_m", "m", number, "amplitude of that line", measured<dominant_amplitude_m>},
    MapColumn{"floquet_modulus", "", ignored, "largest multiplier of a proven orbit over its period",
              of_row<&Row::floquet_modulus>},
    MapColumn{"lyapunov_per_revolution", "", ignored, "largest Lyapunov exponent where no period was found",
              of_row<&Row::lyapunov_per_revolution>},
    MapColumn{"last_contact_revolution", "", ignored, "counted from 1; empty: no wall was ever reached",
              of_row<&Row::last_contact_revolution>},
    MapColumn{"revolutions", "", ignored, "revolutions run until the verdict", of_row<&Row::revolutions>},
    MapColumn{"status", "", ignored, "ok, or what happened, joined by ';'", of_row<&Row::status>},
    MapColumn{"start", "", ignored, "how the run began: kick, quiet, contact or state", of_row<&Row::start>},
    MapColumn{"peak_casing_displacement_m", "m", number,
              "largest distance of a casing from its unloaded place", measured<peak_casing_displacement_m>},
    MapColumn{"peak_over_clearance", "", number, "peak_displacement_m / clearance of the first stop",
              of_row<&Row::peak_over_clearance>},
    MapColumn{
        "chaos_life_revolutions", "", ignored,
        "chaotic: its mean life is this or more, to 95 %; without an escape censored, by how long was looked",
        of_row<least_mean_life>},
    MapColumn{"chaos_escapes", "", ignored, "chaotic: how often it or a companion left it while followed",
              of_row<escapes>},
    MapColumn{"kind", "", ignored, "what figures part the motions by: class, order, shape", kind_name},
};

}  // namespace

std::span<const MapColumn> map_columns() { return columns; }

std::size_t place_of_column(std::string_view name) {
  const auto column = std::ranges::find(columns, name, &MapColumn::name);
  if (column == columns.end()) throw SolverError(fmt::format("map.csv has no column '{}'", name));
  return static_cast<std::size_t>(column - columns.begin());
}

std::string_view cell_in(std::string_view map_line, std::size_t column) {
  for (; column > 0; --column) map_line.remove_prefix(map_line.find(',') + 1);
  return map_line.substr(0, map_line.find(','));
}

double number_in(std::string_view map_line, std::size_t column) {
  const std::string_view cell = cell_in(map_line, column);
  double value = 0;
  std::from_chars(cell.data(), cell.data() + cell.size(), value);
  return value;
}

std::string describe_map_columns() {
  std::string text = "Columns of map.csv, empty where they do not apply:\n";
  for (const MapColumn& column : columns)
    text += fmt::format("  {:<23}  {}\n", column.name, column.description);
  text += describe_study_columns() + describe_unit_columns();
  text += "Classes:\n";
  for (const auto motion_class : response::motion::motion_classes) {
    const auto row = row_of(motion_class);
    text += fmt::format("  {:<23}  {}\n", row.word, row.description);
  }
  return text;
}

std::string columns_compared(Comparison comparison) {
  std::string names;
  for (const MapColumn& column : columns) {
    if (column.comparison == comparison) names.append(names.empty() ? "" : ", ").append(column.name);
  }
  return names;
}

std::string map_header(const sweep::Study& study) {
  std::vector<std::string> names;
  for (const MapColumn& column : map_columns()) names.emplace_back(column.name);
  for (std::string& name : sweep::key_names(study.grid)) names.push_back(std::move(name));
  for (const StudyColumn& column : study_columns(study)) names.emplace_back(column.name);
  return batch::csv_row(names);
}

std::string map_line(const sweep::Row& row, const sweep::Study& study) {
  std::vector<std::string> cells;
  for (const MapColumn& column : map_columns()) cells.push_back(column.text(row));
  for (const double value : row.key_values) cells.push_back(batch::csv_number(value));
  for (const StudyColumn& column : study_columns(study)) cells.push_back(column.text(row));
  return batch::csv_row(cells);
}

std::string map_comments(const sweep::Study& study) {
  const std::vector<std::string> keys = sweep::key_names(study.grid);
  return fmt::format(
      "# units: SI, named in the columns; orders and ratios are pure numbers; forward whirl is positive\n"
      "{}",
      keys.empty() ? "" : fmt::format("# keys {}\n", batch::csv_row(keys)));
}

}  // namespace rubsweep::report
