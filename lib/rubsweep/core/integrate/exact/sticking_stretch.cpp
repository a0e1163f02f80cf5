#include "rubsweep/core/integrate/exact/sticking_stretch.hpp"

#include <algorithm>
#include <cmath>

#include "rubsweep/core/contact/friction_law.hpp"
#include "rubsweep/core/contact/wall.hpp"
#include "rubsweep/core/numerics/certified_step.hpp"
#include "rubsweep/core/numerics/cubic_maximum.hpp"
#include "rubsweep/core/numerics/full_turn.hpp"

namespace rubsweep::integrate::exact {
namespace {

/// Spacing of cubics in radians of a vibration: they miss its peaks by less than h^4 / 384 of its amplitude:
/// 2e-9 for the unbalance's own vibration, 1e-6 for faster ones, which are small beside it.
constexpr double peak_step = 0.03, fast_peak_step = 0.15;
/// Longest piece of Taylor series, in radians of the fastest vibration: a step has to go further.
constexpr double piece = 8;
/// A vibration below this share of a clearance adds less than that to any peak.
constexpr double unseen = 1e-10;

/// Duration for which no guard, made of the slow parts of `view` and, for its free vibration, the largest
/// value or the present one, can come to zero; `longest_rad` at most.
double certified_by(const StickingView& view, const StickingMotion& motion, double growth,
                    double longest_rad) {
  const Eigen::Index k = motion.free.size() / 2;
  const double grown = std::exp(growth * longest_rad), swing = std::abs(view.harmonic);
  double envelope = 0, curvature = swing;
  for (Eigen::Index j = 0; j < k; ++j) {
    const double length = std::hypot(motion.free(j), motion.free(k + j)) * grown;
    envelope += view.size(j) * length;
    curvature += view.curvature(j) * length;
  }
  const double slope = view.on_drift.dot(motion.drift_rate.transpose());
  const ValueAndRate now = value_of(view, motion);
  const std::complex<double> harmonic = view.harmonic * std::polar(1.0, motion.phase_rad);
  const double steady =
      now.value - harmonic.real() - (k > 0 ? view.on_free.dot(motion.free.transpose()) : 0.0);
  if (std::max(steady, steady + slope * longest_rad) + swing + envelope < 0) return longest_rad;
  double certain = 0;
  if (const double top = steady + harmonic.real() + envelope; top < 0)
    certain = numerics::safe_step(top, slope - harmonic.imag(), swing);
  if (now.value < 0) certain = std::max(certain, numerics::safe_step(now.value, now.rate, curvature));
  return std::min(certain, longest_rad);
}

}  // namespace

StickingStretch::StickingStretch(const scene::Scene& scene) : system_(run::scale<Eigen::Dynamic>(scene)) {
  for (const auto& contact : system_.contacts) {
    dry_.push_back(contact::linear(contact.wall) && contact::dry_coefficient(contact.friction) != 0);
    slippery_.push_back(contact::linear(contact.wall) && !contact::acts(contact.friction));
  }
}

const StickingMode* StickingStretch::mode_of(const std::vector<contact::Mode>& modes,
                                             const std::vector<contact::Slip>& slips) {
  key_.clear();
  std::vector<bool> sticks(modes.size(), false);
  for (std::size_t i = 0; i < modes.size(); ++i) {
    key_.push_back(static_cast<int>(modes[i]));
    if (modes[i] == contact::Mode::open) {
      if (!contact::linear(system_.contacts[i].wall)) return nullptr;
      continue;
    }
    sticks[i] = dry_[i] && slips[i] == contact::Slip::sticking;
    if (!sticks[i] && !slippery_[i]) return nullptr;
  }
  auto found = modes_.find(key_);
  if (found == modes_.end()) found = modes_.emplace(key_, StickingMode::make(system_, modes, sticks)).first;
  return found->second ? &*found->second : nullptr;
}

double StickingStretch::certified_rad(double longest_rad) const {
  const double growth = std::max(0.0, mode_->growth());
  if (growth * longest_rad > 1) longest_rad = 1 / growth;
  for (const StickingGuard& guard : mode_->guards())
    longest_rad = certified_by(guard.view, motion_, growth, longest_rad);
  return longest_rad;
}

bool StickingStretch::go_on(const run::TurnRequest& request, const std::vector<contact::Mode>& modes,
                            const std::vector<contact::Slip>& slips, double end_phase_rad, long most_steps,
                            StretchState& place, run::TurnReport& report) {
  mode_ = mode_of(modes, slips);
  if (mode_ == nullptr) return false;
  state_ =
      Eigen::Map<const Eigen::VectorXd>(place.state.data(), static_cast<Eigen::Index>(place.state.size()));
  mode_->begin(place.phase_rad, state_, motion_);
  double fastest = 1;
  for (Eigen::Index j = 0; j < mode_->pairs(); ++j) fastest = std::max(fastest, mode_->rate(j));
  const double least_rad = std::min(1.0, piece / fastest);
  bool any = false;
  for (long k = 0; k < most_steps; ++k) {
    const double left = end_phase_rad - motion_.phase_rad;
    const double step = left > least_rad ? certified_rad(left) : 0;
    if (!(step > least_rad)) break;
    pass(request, step, place, report);
    any = true;
  }
  if (!any) return false;
  place.phase_rad = motion_.phase_rad;
  mode_->put_state(motion_, state_);
  Eigen::Map<Eigen::VectorXd>(place.state.data(), state_.size()) = state_;
  return true;
}

void StickingStretch::pass(const run::TurnRequest& request, double duration_rad, StretchState& place,
                           run::TurnReport& report) {
  ++steps_;
  if (request.samples_per_revolution > 0) put_samples(request, duration_rad, report);
  if (request.peaks) raise_peaks(duration_rad, report);
  mode_->put_flows(duration_rad, flows_);
  mode_->move(duration_rad, flows_, motion_);
  mode_->move_tangents(duration_rad, flows_, place.tangent_vectors);
  report.touched = true;
  report.contact_fraction += duration_rad / numerics::full_turn;
}

void StickingStretch::put_samples(const run::TurnRequest& request, double duration_rad,
                                  run::TurnReport& report) {
  const auto states = static_cast<std::size_t>(state_.size());
  for (int& k = report.sample_count; k < request.samples_per_revolution; ++k) {
    const double ahead = numerics::full_turn * k / request.samples_per_revolution - motion_.phase_rad;
    if (!(ahead < duration_rad)) return;
    at_ = motion_;
    mode_->put_flows(ahead, flows_);
    mode_->move(ahead, flows_, at_);
    mode_->put_state(at_, Eigen::Map<Eigen::VectorXd>(
                              report.samples.data() + static_cast<std::size_t>(k) * states, state_.size()));
  }
}

double StickingStretch::peak_step_rad() const {
  double fastest = 1;
  const Eigen::Index k = mode_->pairs();
  const auto seen = [&](Eigen::Index j) {
    const double length = std::hypot(motion_.free(j), motion_.free(k + j));
    return length > unseen || std::ranges::any_of(mode_->forces(), [&](const StickingView& force) {
             return force.size(j) * length > unseen * std::abs(value_of(force, motion_).value);
           });
  };
  for (Eigen::Index j = 0; j < k; ++j) {
    if (mode_->rate(j) > fastest && seen(j)) fastest = mode_->rate(j);
  }
  return std::min(peak_step, fast_peak_step / fastest);
}

/// Cubics through values and rates at places that what still vibrates allows.
void StickingStretch::raise_peaks(double duration_rad, run::TurnReport& report) {
  const double pieces = std::max(1.0, std::ceil(duration_rad / peak_step_rad())),
               size = duration_rad / pieces;
  const Eigen::Index n = system_.coordinates();
  const auto square = [n](const auto& map, const Eigen::VectorXd& state) {
    const Eigen::Vector2d z = map * state.head(n), v = map * state.tail(n);
    return ValueAndRate{z.squaredNorm(), 2 * z.dot(v)};
  };
  const auto largest = [size](const ValueAndRate& from, const ValueAndRate& to) {
    return numerics::cubic_maximum(from.value, size * from.rate, to.value, size * to.rate);
  };
  const auto raise_length = [&](const auto& map, double& peak_m) {
    const double top = largest(square(map, state_), square(map, next_));
    peak_m = std::max(peak_m, std::sqrt(std::max(0.0, top)) * system_.scale.length_m);
  };
  at_ = motion_;
  StickingMotion before;
  next_.resize(state_.size());
  mode_->put_state(at_, state_);
  mode_->put_flows(size, flows_);
  for (double k = 0; k < pieces; ++k) {
    before = at_;
    mode_->move(size, flows_, at_);
    mode_->put_state(at_, next_);
    raise_length(system_.observed, report.peak_displacement_m);
    for (const auto& casing : system_.casings) raise_length(casing.map, report.peak_casing_displacement_m);
    for (const StickingView& force : mode_->forces())
      report.peak_contact_force_n =
          std::max(report.peak_contact_force_n, largest(value_of(force, before), value_of(force, at_)));
    state_.swap(next_);
  }
}

}  // namespace rubsweep::integrate::exact
