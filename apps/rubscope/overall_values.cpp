#include "rubscope/overall_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <span>

#include "rubsweep/core/model/speed_text.hpp"
#include "rubsweep/core/response/spectrum/full_spectrum.hpp"
#include "rubsweep/maps/batch/csv_table.hpp"

namespace rubsweep::apps {

namespace {

using batch::csv_number;
using recording::MachineGroup;
using recording::Place;
using recording::Recording;
using std::numbers::pi;

/// Root mean square within a band of readings that are differentiated (order > 0) or integrated (< 0). Empty
/// where a reading is missing.
std::optional<double> rms_in(std::span<const double> readings, double rate_hz, Band band, int order) {
  const std::size_t count = readings.size();
  if (!std::ranges::all_of(readings, [](double value) { return std::isfinite(value); })) return std::nullopt;
  if (count < 2) return 0;
  double mean = 0, weights = 0;
  for (const double value : readings) mean += value / static_cast<double>(count);
  std::vector<std::complex<double>> windowed;
  for (std::size_t k = 0; k < count; ++k) {
    const double weight = 1 - std::cos(2 * pi * static_cast<double>(k) / static_cast<double>(count));
    weights += weight * weight;
    windowed.emplace_back(weight * (readings[k] - mean));
  }
  response::spectrum::SpectrumWorkspace workspace;
  const auto lines = response::spectrum::transform(windowed, workspace);
  double squares = 0;
  for (std::size_t k = 1; k <= count / 2; ++k) {
    const double frequency_hz = static_cast<double>(k) * rate_hz / static_cast<double>(count);
    if (frequency_hz < band.from_hz || frequency_hz > band.to_hz) continue;
    // The line at minus this frequency has the same size; half the sampling rate has none.
    const double sides = 2 * k == count ? 1 : 2;
    squares += sides * std::norm(lines[k]) * std::pow(2 * pi * frequency_hz, 2 * order);
  }
  return std::sqrt(squares / (static_cast<double>(count) * weights));
}

/// Displacement in the direction of a probe, as far from its lowest to its highest value as it goes within
/// eight turns.
double peak_to_peak_m(const Recording& recording, double angle_deg) {
  constexpr int turns_together = 8;
  const std::complex<double> direction =
      recording.plane ? std::polar(1.0, -angle_deg * pi / 180) : std::complex<double>(1);
  const int stretches = std::max(1, recording.turns() / turns_together);
  const int turns = std::min(recording.turns(), turns_together);
  double sum = 0;
  for (int stretch = 0; stretch < stretches; ++stretch) {
    const auto samples =
        std::span(recording.displacement_m)
            .subspan(static_cast<std::size_t>(stretch * turns) * recording::samples_per_revolution,
                     static_cast<std::size_t>(turns) * recording::samples_per_revolution);
    double low = INFINITY, high = -INFINITY;
    for (const std::complex<double> z : samples) {
      low = std::min(low, (z * direction).real());
      high = std::max(high, (z * direction).real());
    }
    sum += high - low;
  }
  return sum / stretches;
}

/// The largest value that zones judge, its limits and their unit.
struct Judged {
  double value = 0;
  std::optional<ZoneLimits> limits{};
  bool velocity = false, own_limits = false;
};

std::optional<Judged> judged(const Recording& recording, const std::vector<OverallValue>& values) {
  if (values.empty() || recording.place == Place::shaft_absolute) return std::nullopt;
  Judged largest{.velocity = recording.place == Place::casing};
  const auto no_rms = [](const OverallValue& value) { return !value.velocity_rms_m_per_s; };
  if (largest.velocity && std::ranges::any_of(values, no_rms)) return std::nullopt;
  for (const OverallValue& value : values)
    largest.value = std::max(largest.value, value.velocity_rms_m_per_s.value_or(value.peak_to_peak_m));
  if (!largest.velocity) largest.limits = shaft_limits(recording.mean_speed_hz());
  if (largest.velocity && recording.machine_group) largest.limits = casing_limits(*recording.machine_group);
  const auto& own = largest.velocity ? recording.zone_limits_mm_per_s : recording.zone_limits_um;
  largest.own_limits = own.has_value();
  if (own) {
    largest.limits = own;
    for (double& limit : *largest.limits) limit *= largest.velocity ? 1e-3 : 1e-6;
  }
  return largest;
}

std::string zone_text(const Judged& judged) {
  const double scale = judged.velocity ? 1e3 : 1e6;
  const char* const unit = judged.velocity ? "mm/s" : "um";
  if (judged.limits) {
    const auto& [ab, bc, cd] = *judged.limits;
    return fmt::format("          zone {} of {}: A to {:.3g}, B to {:.3g}, C to {:.3g} {} {}\n",
                       zone_of(judged.value, *judged.limits),
                       judged.own_limits ? "the limits given" : "ISO 20816-3", scale * ab, scale * bc,
                       scale * cd, unit, judged.velocity ? "rms" : "peak to peak");
  }
  if (!judged.velocity) return "          no zone: ISO 20816-3 has limits from 600 to 30000 rpm\n";
  const char best = zone_of(judged.value, casing_limits(MachineGroup::large_flexible)),
             worst = zone_of(judged.value, casing_limits(MachineGroup::medium_rigid));
  return fmt::format(
      "          zone {} of ISO 20816-3{}\n",
      best == worst ? std::string(1, best) : fmt::format("{} to {}", best, worst),
      best == worst ? ", whatever the machine" : ": machine_group in the description tells which");
}

}  // namespace

Band velocity_band(double speed_hz) {
  constexpr double slow_hz = 10;
  return {speed_hz < slow_hz ? 2.0 : 10.0, 1000};
}

ZoneLimits casing_limits(MachineGroup group) {
  switch (group) {
    case MachineGroup::large_flexible: return {3.5e-3, 7.1e-3, 11e-3};
    case MachineGroup::medium_rigid: return {1.4e-3, 2.8e-3, 4.5e-3};
    case MachineGroup::large_rigid:
    case MachineGroup::medium_flexible: break;
  }
  return {2.3e-3, 4.5e-3, 7.1e-3};
}

std::optional<ZoneLimits> shaft_limits(double speed_hz) {
  constexpr double slowest_rpm = 600, fastest_rpm = 30000;
  const double rpm = model::rpm_per_hz * speed_hz;
  if (rpm < slowest_rpm || rpm > fastest_rpm) return std::nullopt;
  const double root = std::sqrt(rpm);
  return ZoneLimits{4800e-6 / root, 9000e-6 / root, 13200e-6 / root};
}

char zone_of(double value, const ZoneLimits& limits) {
  return static_cast<char>('A' + std::ranges::count_if(limits, [&](double limit) { return value > limit; }));
}

std::vector<OverallValue> overall_values(const Recording& recording) {
  std::vector<OverallValue> values;
  for (const recording::ProbeSignal& probe : recording.probes) {
    OverallValue& value = values.emplace_back();
    value.column = probe.column;
    value.peak_to_peak_m = peak_to_peak_m(recording, probe.angle_deg);
    const int times = recording.integration.times;
    if (recording.place == Place::casing)
      value.velocity_rms_m_per_s = rms_in(probe.values, recording.sampling_rate_hz,
                                          velocity_band(recording.mean_speed_hz()), 1 - times);
    if (times == 2)
      value.acceleration_rms_m_per_s2 =
          rms_in(probe.values, recording.sampling_rate_hz, acceleration_band, 0);
  }
  return values;
}

std::string overall_csv(const Recording& recording, const std::vector<OverallValue>& values) {
  std::string text;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const OverallValue& value = values[i];
    text += fmt::format("overall_peak_to_peak_{}_m,{},\n", i + 1, csv_number(value.peak_to_peak_m));
    if (const auto rms = value.velocity_rms_m_per_s)
      text += fmt::format("velocity_rms_{}_m_per_s,{},\n", i + 1, csv_number(*rms));
    if (const auto rms = value.acceleration_rms_m_per_s2)
      text += fmt::format("acceleration_rms_{}_m_per_s2,{},\n", i + 1, csv_number(*rms));
  }
  const auto judged_value = judged(recording, values);
  if (!judged_value || !judged_value->limits) return text;
  for (std::size_t i = 0; i < 3; ++i)
    text += fmt::format("{}zone_{}_to_{},{},\n", judged_value->own_limits ? "" : "iso_20816_", "abc"[i],
                        judged_value -> velocity ? "m_per_s" : "m", csv_number((*judged_value->limits)[i]));
  return text;
}

std::string overall_text(const Recording& recording, const std::vector<OverallValue>& values,
                         const model::ShownLengths& shown) {
  if (values.empty()) return {};
  std::string text;
  for (const OverallValue& value : values) {
    text += fmt::format("{}'{}' {} peak to peak", text.empty() ? "overall   " : "; ", value.column,
                        model::length_text(value.peak_to_peak_m, shown, model::LengthUnit::um));
    if (const auto rms = value.velocity_rms_m_per_s) text += fmt::format(", {:.4g} mm/s rms", 1e3 * *rms);
    if (const auto rms = value.acceleration_rms_m_per_s2) text += fmt::format(", {:.4g} m/s2 rms", *rms);
  }
  text += '\n';
  if (recording.place == Place::casing) {
    const Band band = velocity_band(recording.mean_speed_hz());
    text += fmt::format("          velocity from {:g} to {:g} Hz", band.from_hz,
                        std::min(band.to_hz, recording.sampling_rate_hz / 2));
    if (recording.integration.times == 2)
      text += fmt::format(", acceleration from {:g} to {:g} Hz", acceleration_band.from_hz,
                          std::min(acceleration_band.to_hz, recording.sampling_rate_hz / 2));
    const auto no_rms = [](const OverallValue& value) { return !value.velocity_rms_m_per_s; };
    text += std::ranges::any_of(values, no_rms) ? "; no rms where readings are missing\n" : "\n";
  }
  if (const auto judged_value = judged(recording, values)) text += zone_text(*judged_value);
  return text;
}

}  // namespace rubsweep::apps
