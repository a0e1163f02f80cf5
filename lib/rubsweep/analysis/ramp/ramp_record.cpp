#include "rubsweep/analysis/ramp/ramp_record.hpp"

#include <algorithm>
#include <numbers>

#include "rubsweep/core/response/spectrum/discrete_lines.hpp"

namespace rubsweep::ramp {
namespace {

/// Displacement at time t_s between two samples, by the cubic through their displacements and velocities.
std::complex<double> between(const RampSample& a, const RampSample& b, double t_s) {
  const double h = b.t_s - a.t_s, x = (t_s - a.t_s) / h;
  const Eigen::Vector2d z = (1 + 2 * x) * (1 - x) * (1 - x) * a.displacement_m +
                            x * x * (3 - 2 * x) * b.displacement_m +
                            h * x * (1 - x) * ((1 - x) * a.velocity_m_per_s - x * b.velocity_m_per_s);
  return {z.x(), z.y()};
}

double turns_of(const SpeedRamp& ramp) { return ramp.angle_rad(ramp.duration_s()) / (2 * std::numbers::pi); }

}  // namespace

RampRecord::RampRecord(const SpeedRamp& ramp)
    : ramp_(ramp),
      points_(std::clamp<std::size_t>(static_cast<std::size_t>(ramp.duration_s() * ramp.fastest_hz() / 2), 1,
                                      most_envelope_points)),
      every_(1 + static_cast<long>(turns_of(ramp) / spectrum_turns / static_cast<double>(most_spectra))) {}

void RampRecord::add(const RampStretch& stretch) {
  add_to_envelope(stretch);
  add_to_spans(stretch);
  for (const RampSample& sample : stretch.samples) {
    add_to_orbits(sample);
    if (last_) add_to_spectra(sample);
    last_ = sample;
  }
}

void RampRecord::add_to_envelope(const RampStretch& stretch) {
  const double width_s = ramp_.duration_s() / static_cast<double>(points_);
  const double middle_s = (stretch.begin_s + stretch.end_s) / 2;
  const auto place = std::min(static_cast<std::size_t>(middle_s / width_s), points_ - 1);
  const double t_s = (static_cast<double>(place) + 0.5) * width_s;
  if (envelope_.empty() || envelope_.back().t_s != t_s) {
    envelope_.push_back({});
    envelope_.back().t_s = t_s;
    envelope_.back().speed_hz = ramp_.speed_hz(t_s);
  }
  EnvelopePoint& point = envelope_.back();
  for (const RampSample& sample : stretch.samples) {
    point.lowest_x_m = std::min(point.lowest_x_m, sample.displacement_m.x());
    point.highest_x_m = std::max(point.highest_x_m, sample.displacement_m.x());
    point.lowest_y_m = std::min(point.lowest_y_m, sample.displacement_m.y());
    point.highest_y_m = std::max(point.highest_y_m, sample.displacement_m.y());
  }
  point.peak_displacement_m = std::max(point.peak_displacement_m, stretch.peak_displacement_m);
  point.peak_contact_force_n = std::max(point.peak_contact_force_n, stretch.peak_contact_force_n);
  point.hits += stretch.hits;
  point.touching_s += stretch.touching_s;
  point.duration_s += stretch.end_s - stretch.begin_s;
}

void RampRecord::add_to_orbits(const RampSample& sample) {
  const std::size_t next = orbits_.size();
  const double begin_s = ramp_.duration_s() * (static_cast<double>(next) + 0.5) / orbits_of_a_ramp;
  if (next < static_cast<std::size_t>(orbits_of_a_ramp) && sample.t_s >= begin_s)
    orbits_.push_back({ramp_.speed_hz(sample.t_s), {}});
  if (orbits_.empty()) return;
  std::vector<RampSample>& samples = orbits_.back().samples;
  const double angle =
      ramp_.angle_rad(sample.t_s) - ramp_.angle_rad(samples.empty() ? sample.t_s : samples.front().t_s);
  if (angle <= 2 * std::numbers::pi * turns_of_an_orbit) samples.push_back(sample);
}

void RampRecord::add_to_spectra(const RampSample& sample) {
  for (;; ++next_angle_sample_) {
    const double t_s = ramp_.time_s(static_cast<double>(next_angle_sample_) / spectrum_samples);
    if (!(t_s < sample.t_s) || t_s < last_->t_s) return;
    turns_.push_back(between(*last_, sample, t_s));
    if (turns_.size() == static_cast<std::size_t>(spectrum_turns) * spectrum_samples) take_spectrum();
  }
}

void RampRecord::take_spectrum() {
  if (window_ % every_ == 0) {
    const double middle_s = ramp_.time_s((static_cast<double>(window_) + 0.5) * spectrum_turns);
    spectra_.push_back({middle_s, ramp_.speed_hz(middle_s),
                        response::spectrum::windowed_spectrum(turns_, spectrum_turns, workspace_)});
  }
  ++window_;
  turns_.clear();
}

void RampRecord::add_to_spans(const RampStretch& stretch) {
  if (!stretch.touched) return;
  const bool goes_on =
      last_contact_s_ && ramp_.angle_rad(stretch.begin_s) - ramp_.angle_rad(*last_contact_s_) <=
                             2 * std::numbers::pi * most_free_turns;
  if (!goes_on) spans_.push_back({ramp_.speed_hz(stretch.begin_s), 0});
  spans_.back().to_hz = ramp_.speed_hz(stretch.end_s);
  last_contact_s_ = stretch.end_s;
}

}  // namespace rubsweep::ramp
