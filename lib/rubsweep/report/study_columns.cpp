#include "rubsweep/report/study_columns.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>

#include "rubsweep/batch/csv_table.hpp"

namespace rubsweep::report {
namespace {

using sweep::Row;

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

/// "35.1..70.3 subharmonic 1/2; 90..400 chaotic + subharmonic 1/3": no comma, so that no cell is quoted.
std::string intervals(const Row& row) {
  std::string text;
  if (!row.threshold) return text;
  for (const sweep::RubInterval& interval : row.threshold->intervals) {
    text += fmt::format("{}{}..{} {}", text.empty() ? "" : "; ", interval.from, interval.to,
                        fmt::join(interval.motions, " + "));
  }
  return text;
}

std::string probes(const Row& row) { return row.threshold ? fmt::format("{}", row.threshold->probes) : ""; }

std::string failed_probes(const Row& row) {
  return row.threshold ? fmt::format("{}", row.threshold->failed) : "";
}

constexpr std::array of_thresholds{
    StudyColumn{"threshold", "smallest number of the scan after which rub goes on", threshold},
    StudyColumn{"threshold_motion", "the motion just above it", threshold_motion},
    StudyColumn{"rub_intervals", "every stretch after which rub goes on, with the motions it leads to",
                intervals},
    StudyColumn{"probes", "numbers that were tried", probes},
    StudyColumn{"failed_probes", "of them, those whose run failed", failed_probes},
};

}  // namespace

std::span<const StudyColumn> threshold_columns() { return of_thresholds; }

std::vector<StudyColumn> study_columns(const sweep::Study& study) {
  std::vector<StudyColumn> columns;
  if (study.threshold) columns.assign(of_thresholds.begin(), of_thresholds.end());
  return columns;
}

std::string describe_study_columns() {
  std::string text = "Columns behind them with study.kind threshold:\n";
  for (const StudyColumn& column : of_thresholds)
    text += fmt::format("  {:<23}  {}\n", column.name, column.description);
  return text;
}

}  // namespace rubsweep::report
