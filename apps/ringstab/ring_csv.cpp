#include "ring_csv.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "rubsweep/maps/batch/csv_table.hpp"

namespace rubsweep::apps {

using namespace ring;

namespace {

using batch::csv_number;

const char* state_of(const Signature& signature) {
  if (signature.stable()) return "stable";
  if (signature.growing_pairs == 0) return "divergence";
  return signature.growing_real == 0 ? "flutter" : "divergence+flutter";
}

std::string rpm_text(double rad_per_s) { return csv_number(rad_per_s / rad_per_s_of_rpm); }

template <std::size_t count>
std::string line(const std::array<std::string, count>& cells) {
  return batch::csv_row(cells) + "\n";
}

void append_point(const Track& track, const TrackPoint& point, std::string& text) {
  std::vector<std::pair<int, std::complex<double>>> roots;
  for (std::size_t i = 0; i < point.mode.size(); ++i) {
    const std::complex<double> value = point.spectrum.values(static_cast<Eigen::Index>(i));
    if (value.imag() >= 0) roots.emplace_back(point.mode[i], value);
  }
  std::sort(roots.begin(), roots.end(), [](const auto& a, const auto& b) {
    return a.first != b.first ? a.first < b.first : a.second.real() < b.second.real();
  });
  for (const auto& [mode, value] : roots) {
    text += line<4>({rpm_text(point.speed_rad_per_s), track.names[static_cast<std::size_t>(mode)],
                     csv_number(value.real()), csv_number(value.imag())});
  }
}

}  // namespace

std::string ring_comments() {
  return "# units: named in the columns; a positive real part grows; frequencies in the rotating frame; "
         "loads "
         "from 0\n";
}

std::string eigenvalues_csv(const Track& track) {
  std::string text = "speed_rpm,mode,real_per_s,imaginary_rad_per_s\n";
  for (const TrackPoint& point : track.points) {
    if (point.asked) append_point(track, point, text);
  }
  return text;
}

std::string onsets_csv(const std::vector<Onset>& onsets) {
  std::string text = "kind,speed_rpm,modes,note\n";
  for (const Onset& onset : onsets) {
    text += line<4>({onset.kind, rpm_text(onset.speed_rad_per_s),
                     fmt::format("{}", fmt::join(onset.modes, " + ")), onset.note});
  }
  return text;
}

std::string critical_speeds_csv(const std::vector<CriticalSpeed>& speeds) {
  std::string text = "name,closed_form_rpm,numeric_rpm\n";
  for (const CriticalSpeed& speed : speeds) {
    text += line<3>({speed.name, rpm_text(speed.closed_form_rad_per_s),
                     speed.numeric_rad_per_s ? rpm_text(*speed.numeric_rad_per_s) : ""});
  }
  return text;
}

std::vector<StaticLoad> static_loads(const Study& study) {
  std::vector<StaticLoad> loads;
  for (const double speed : speeds_rad_per_s(study)) {
    loads.push_back(static_load(study.system, speed));
  }
  return loads;
}

std::string static_load_csv(const Study& study, const std::vector<StaticLoad>& loads) {
  std::string text = "speed_rpm,load,normal_force_n,slip_m_per_s,valid\n";
  for (std::size_t i = 0; i < loads.size(); ++i) {
    const char* valid = loads[i].valid() ? "yes" : "no";
    for (std::size_t j = 0; j < loads[i].normal_n.size(); ++j) {
      text += line<5>({csv_number(study.speeds_rpm[i]), fmt::format("{}", j),
                       csv_number(loads[i].normal_n[j]), csv_number(loads[i].slip_m_per_s[j]), valid});
    }
  }
  return text;
}

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

}  // namespace rubsweep::apps
