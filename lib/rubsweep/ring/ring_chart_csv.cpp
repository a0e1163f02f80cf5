#include "rubsweep/ring/ring_chart_csv.hpp"

#include <fmt/format.h>

#include <array>

#include "rubsweep/batch/csv_table.hpp"

namespace rubsweep::ring {
namespace {

using batch::csv_number;

const char* state_of(const Signature& signature) {
  if (signature.stable()) return "stable";
  if (signature.growing_pairs == 0) return "divergence";
  return signature.growing_real == 0 ? "flutter" : "divergence+flutter";
}

}  // namespace

std::string chart_header(const ChartAxis& axis) {
  return fmt::format("{},speed_rpm,state,growth_per_s,frequency_rad_per_s,unstable_eigenvalues,status",
                     to_string(axis.parameter));
}

std::string chart_rows(const Study& study, const ChartLine& line) {
  const std::string value = csv_number(line.value);
  if (line.status != "ok") return fmt::format("{},,,,,,{}", value, line.status);
  std::string text;
  for (std::size_t i = 0; i < line.points.size(); ++i) {
    const ChartPoint& point = line.points[i];
    text += fmt::format("{}{},{},{},{},{},{},ok", i > 0 ? "\n" : "", value, csv_number(study.speeds_rpm[i]),
                        state_of(point.signature), csv_number(point.growth_per_s),
                        csv_number(point.frequency_rad_per_s), point.signature.unstable_eigenvalues());
  }
  return text;
}

std::string chart_csv(const Study& study, const std::vector<std::optional<ChartLine>>& lines) {
  std::string text = chart_header(*study.chart) + "\n";
  for (const auto& line : lines) {
    if (line) text += chart_rows(study, *line) + "\n";
  }
  return text;
}

std::string chart_onsets_csv(const Study& study, const std::vector<std::optional<ChartLine>>& lines) {
  std::string text = fmt::format("{},kind,speed_rpm,note\n", to_string(study.chart->parameter));
  for (const auto& line : lines) {
    if (!line) continue;
    for (const Onset& onset : line->onsets) {
      const std::array<std::string, 4> cells{csv_number(line->value), onset.kind,
                                             csv_number(onset.speed_rad_per_s / rad_per_s_of_rpm),
                                             onset.note};
      text += batch::csv_row(cells) + "\n";
    }
  }
  return text;
}

}  // namespace rubsweep::ring
