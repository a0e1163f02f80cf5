#include "rubsweep/maps/report/study_columns.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <charconv>
#include <concepts>
#include <functional>
#include <numbers>

#include "rubsweep/maps/batch/csv_table.hpp"
#include "rubsweep/maps/report/map_csv.hpp"
#include "rubsweep/maps/sweep/hertz_secant.hpp"

namespace rubsweep::report {
namespace {

using sweep::Row;

std::string text_of(double value) { return batch::csv_number(value); }
std::string text_of(std::integral auto value) { return fmt::format("{}", value); }

/// Text of the optional member `part` of a row, or of a member of this part.
template <auto part>
std::string given(const Row& row) {
  return row.*part ? text_of(*(row.*part)) : "";
}
template <auto part, auto get>
std::string given(const Row& row) {
  return row.*part ? text_of(*(row.*part).*get) : "";
}

const sweep::RubInterval* first_interval(const Row& row) {
  return row.threshold && !row.threshold->intervals.empty() ? &row.threshold->intervals.front() : nullptr;
}

std::string threshold(const Row& row) {
  const sweep::RubInterval* first = first_interval(row);
  return first ? batch::csv_number(first->from) : "";
}

std::string threshold_motion(const Row& row) {
  const sweep::RubInterval* first = first_interval(row);
  return first ? first->motions.front() : "";
}

/// Intervals with rub, such as "35.1..70.3 subharmonic 1/2; 90..400 chaotic + subharmonic 1/3". No comma, so
/// that no cell is quoted.
std::string intervals(const Row& row) {
  std::string text;
  if (!row.threshold) return text;
  for (const sweep::RubInterval& interval : row.threshold->intervals) {
    text += fmt::format("{}{}..{} {}", text.empty() ? "" : "; ", interval.from, interval.to,
                        fmt::join(interval.motions, " + "));
  }
  return text;
}

constexpr std::array of_thresholds{
    StudyColumn{"threshold", "smallest number of the scan after which rub goes on", threshold},
    StudyColumn{"threshold_motion", "the motion just above it", threshold_motion},
    StudyColumn{"rub_intervals", "every stretch after which rub goes on, with the motions it leads to",
                intervals},
    StudyColumn{"probes", "numbers that were tried", given<&Row::threshold, &sweep::Threshold::probes>},
    StudyColumn{"failed_probes", "of them, those whose run failed",
                given<&Row::threshold, &sweep::Threshold::failed>},
};

std::string attractors(const Row& row) {
  return row.basins ? fmt::format("{}", row.basins->attractors.size()) : "";
}

/// Basins with their shares, such as "non_contact 0.6+-0.01; subharmonic 1/2 0.4+-0.01 (1.9 mm)".
std::string basins(const Row& row) {
  std::string text;
  if (!row.basins) return text;
  for (const sweep::Attractor& attractor : row.basins->attractors) {
    text += fmt::format("{}{} {}+-{:.2g}", text.empty() ? "" : "; ", attractor.motion.name, attractor.share,
                        attractor.standard_error);
    if (attractor.motion.repeats) text += fmt::format(" ({:.4g} mm)", 1e3 * attractor.motion.orbit_m.front());
  }
  return text;
}

/// Sum of the shares of all attractors that rub.
std::string rub_probability(const Row& row) {
  if (!row.basins) return "";
  double share = 0;
  for (const sweep::Attractor& attractor : row.basins->attractors) {
    if (attractor.motion.rubs) share += attractor.share;
  }
  return batch::csv_number(share);
}

constexpr std::array of_basins{
    StudyColumn{"attractors", "how many motions the samples lead to, told apart by their orbits", attractors},
    StudyColumn{"rub_probability", "share of the samples after which rub goes on", rub_probability},
    StudyColumn{"basins", "share of each attractor, its standard error, and its largest displacement",
                basins},
    StudyColumn{"failed_samples", "samples whose run failed", given<&Row::basins, &sweep::Basins::failed>},
};

constexpr std::array of_refinement{StudyColumn{
    "level", "how often the block of the cell was split before it was met", given<&Row::refinement_level>}};

constexpr std::array of_robustness{
    StudyColumn{"robust_share", "share of the neighbouring kicks that lead to the same class and order",
                given<&Row::robust_share>}};

constexpr double degrees = 180 / std::numbers::pi;

std::string peak_twist_deg(const Row& row) {
  return row.measures ? batch::csv_number(row.measures->contact.peak_twist_rad * degrees) : "";
}

std::string peak_torque_nm(const Row& row) {
  return row.measures ? batch::csv_number(row.measures->contact.peak_torque_nm) : "";
}

constexpr std::array of_torsion{
    StudyColumn{"peak_twist_deg", "largest angle between rotor and drive", peak_twist_deg},
    StudyColumn{"peak_torque_nm", "largest torque in the drive", peak_torque_nm},
};

constexpr std::array of_hertz{
    StudyColumn{"hertz_iterations", "how often the secant of the line contact was taken anew",
                given<&Row::hertz, &sweep::HertzSecant::iterations>},
    StudyColumn{"hertz_force_n",
                "force of that secant, of the stop with hertz that has the smallest design_force_n",
                given<&Row::hertz, &sweep::HertzSecant::force_n>},
    StudyColumn{"hertz_stiffness_n_per_m", "the stiffness that it gives that stop",
                given<&Row::hertz, &sweep::HertzSecant::stiffness_n_per_m>},
};

/// Columns that some studies have in addition, in the order of the file.
struct Group {
  std::string_view when;
  std::span<const StudyColumn> columns;
  bool (*are_of)(const sweep::Study&);
};

bool twists(const sweep::Study& study) {
  const model::RotorKit* kit = model::kit_of(study.machine);
  return kit != nullptr && kit->torsion;
}

constexpr std::array groups{
    Group{"rotor.torsion", of_torsion, twists},
    Group{"response.hertz_iterations and a stop with hertz", of_hertz, sweep::takes_secants_anew},
    Group{"response.robustness probability", of_robustness,
          [](const sweep::Study& study) { return study.robustness == sweep::Robustness::probability; }},
    Group{"sweep.refine", of_refinement,
          [](const sweep::Study& study) { return study.grid.refinement.has_value(); }},
    Group{"study.kind threshold", of_thresholds,
          [](const sweep::Study& study) { return study.threshold.has_value(); }},
    Group{"study.kind basin", of_basins, [](const sweep::Study& study) { return study.basin.has_value(); }},
};

struct UnitColumn {
  std::string_view name, description;
};
/// Columns in the units of the configuration, in the order of the file.
constexpr std::array unit_columns{
    UnitColumn{"speed_rpm", "shaft speed in revolutions per minute"},
    UnitColumn{"unbalance_g_mm", "unbalance of the rotor in g mm"},
    UnitColumn{"balance_grade_mm_per_s", "balance quality grade at the rated speed, in mm/s"},
};

/// Function that gives the number in the column called `name` of a row.
using CellOf = std::function<double(std::string_view name)>;

std::string cells_by(const CellOf& cell, const sweep::Grid& grid) {
  std::string text;
  if (!grid.written_speed.is_si())
    text.append(",").append(sweep::in_units(grid.written_speed, cell("speed_hz")));
  if (!grid.written_unbalance.is_si())
    text.append(",").append(sweep::in_units(grid.written_unbalance, cell("eccentricity_m")));
  return text;
}

}  // namespace

std::vector<StudyColumn> all_study_columns() {
  std::vector<StudyColumn> columns;
  for (const Group& group : groups) columns.insert(columns.end(), group.columns.begin(), group.columns.end());
  return columns;
}

std::vector<StudyColumn> study_columns(const sweep::Study& study) {
  std::vector<StudyColumn> columns;
  for (const Group& group : groups) {
    if (group.are_of(study)) columns.insert(columns.end(), group.columns.begin(), group.columns.end());
  }
  return columns;
}

std::string describe_study_columns() {
  std::string text;
  for (const Group& group : groups) {
    text += fmt::format("Columns behind them with {}:\n", group.when);
    for (const StudyColumn& column : group.columns)
      text += fmt::format("  {:<23}  {}\n", column.name, column.description);
  }
  return text;
}

std::string unit_header(const sweep::Grid& grid) {
  std::string names;
  for (const auto* axis : {&grid.written_speed, &grid.written_unbalance}) {
    if (!axis->is_si()) names += "," + axis->key;
  }
  return names;
}

std::string unit_cells(const sweep::Row& row, const sweep::Grid& grid) {
  return cells_by(
      [&](std::string_view name) { return name == "speed_hz" ? row.speed_hz : row.eccentricity_m; }, grid);
}

std::string unit_cells(std::string_view map_line, const sweep::Grid& grid) {
  return cells_by(
      [&](std::string_view name) {
        std::string_view rest = map_line;
        for (std::size_t column = place_of_column(name); column > 0; --column)
          rest.remove_prefix(rest.find(',') + 1);
        double value = 0;
        std::from_chars(rest.data(), rest.data() + rest.size(), value);
        return value;
      },
      grid);
}

std::string_view without_unit_columns(std::string_view header) {
  for (bool found = true; found;) {
    found = false;
    for (const UnitColumn& column : unit_columns) {
      if (!header.ends_with(fmt::format(",{}", column.name))) continue;
      header.remove_suffix(column.name.size() + 1);
      found = true;
    }
  }
  return header;
}

std::string describe_unit_columns() {
  std::string text = "Columns behind all others where the sweep is written in these units:\n";
  for (const UnitColumn& column : unit_columns)
    text += fmt::format("  {:<23}  {}\n", column.name, column.description);
  return text;
}

}  // namespace rubsweep::report
