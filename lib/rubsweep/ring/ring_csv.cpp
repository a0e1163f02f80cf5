#include "rubsweep/ring/ring_csv.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "rubsweep/batch/csv_table.hpp"

namespace rubsweep::ring {
namespace {

using batch::csv_number;

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

}  // namespace rubsweep::ring
