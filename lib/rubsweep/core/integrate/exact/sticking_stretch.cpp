#include "rubsweep/core/integrate/exact/sticking_stretch.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "rubsweep/core/contact/friction_law.hpp"
#include "rubsweep/core/contact/wall.hpp"
#include "rubsweep/core/integrate/run/turn_book.hpp"
#include "rubsweep/core/numerics/certified_step.hpp"
#include "rubsweep/core/numerics/cubic_maximum.hpp"
#include "rubsweep/core/numerics/full_turn.hpp"

namespace rubsweep::integrate::exact {
namespace {

/// Spacing of cubics in radians of a vibration. They miss its peaks by less than h^4 / 384 of its amplitude:
/// 2e-9 for the vibration by unbalance, and 1e-6 for faster vibrations, which are comparatively small.
constexpr double peak_step = 0.03, fast_peak_step = 0.15;
/// Longest Taylor piece, in radians of the fastest vibration; only longer steps in closed form save time.
constexpr double piece = 8;
/// A vibration below this share of a clearance is ignored: it adds less than that to a peak.
constexpr double unseen = 1e-10;
constexpr double least_block = 8;  ///< Smallest number of cubics in a block that is first bounded as a whole.
constexpr double same_normal = 1e-14;  ///< Angle of a ring's normal that is only rounding of the states.

/// Duration, at most `longest_rad`, in which a guard cannot reach zero. The guard is the sum of the slow
/// parts of `view` and of its free vibration, taken at its largest or at its present value.
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
    const bool normal_stands = contact::linear(contact.wall) || contact.surface_speed_m_per_s == 0;
    const contact::FrictionTerms terms = contact::friction_terms(contact.friction);
    // A stretch ends at the limit of friction. If friction drops as soon as the contact slips, a state at the
    // limit does not show whether the contact is held or released; Taylor pieces pass this instant.
    dry_.push_back(normal_stands && terms.holding != 0 && !terms.jumps());
    const bool dry = terms.holding != 0 && terms.holding == terms.dry;
    steady_.push_back(contact::linear(contact.wall) && (dry || !contact::acts(contact.friction)));
  }
}

const StickingMode* StickingStretch::mode_of(const std::vector<contact::Mode>& modes,
                                             const std::vector<contact::Slip>& slips,
                                             std::span<const double> state) {
  key_.clear();
  normals_.clear();
  sticks_.assign(modes.size(), false);
  ways_.assign(modes.size(), 0);
  for (std::size_t i = 0; i < modes.size(); ++i) {
    const auto& c = system_.contacts[i];
    key_.push_back(static_cast<int>(modes[i]));
    if (modes[i] == contact::Mode::open) {
      if (!contact::linear(c.wall)) return nullptr;
      continue;
    }
    sticks_[i] = dry_[i] && slips[i] == contact::Slip::sticking;
    if (!sticks_[i] && !steady_[i]) return nullptr;
    if (dry_[i]) ways_[i] = contact::sign_of(slips[i]);
    key_.push_back(static_cast<int>(ways_[i]));
    if (contact::linear(c.wall)) continue;
    const Eigen::Map<const Eigen::VectorXd> u(state.data(), system_.coordinates());
    normals_.push_back(Eigen::Vector2d(c.first_row.dot(u.transpose()) + c.offset[0],
                                       c.second_row.dot(u.transpose()) + c.offset[1])
                           .normalized());
  }
  const auto [found, fresh] = modes_.try_emplace(key_);
  MadeMode& made = found->second;
  const auto near = [](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return (a - b).cwiseAbs().maxCoeff() < same_normal;
  };
  if (fresh || !std::ranges::equal(made.normals, normals_, near))
    made = {normals_,
            StickingMode::make(normals_.empty() ? system_ : with_flat_rings(), modes, sticks_, ways_),
            {}};
  if (!made.mode) return nullptr;
  if (made.watched.empty()) watch(made);
  made_ = &made;
  return &*made.mode;
}

void StickingStretch::watch(MadeMode& made) const {
  for (const StickingView& force : made.mode->forces())
    made.watched.push_back({false, {force, {}}, 1, &run::TurnReport::peak_contact_force_n});
  const Eigen::RowVectorXd none = Eigen::RowVectorXd::Zero(system_.coordinates());
  const auto add = [&](const auto& map, double run::TurnReport::*peak) {
    made.watched.push_back(
        {true,
         {made.mode->view(map.row(0), none, 0, 0), made.mode->view(map.row(1), none, 0, 0)},
         system_.scale.length_m,
         peak});
  };
  add(system_.observed, &run::TurnReport::peak_displacement_m);
  for (const auto& casing : system_.casings) add(casing.map, &run::TurnReport::peak_casing_displacement_m);
}

/// The system with a flat wall, perpendicular to the normal, for each annular stop that holds the rotor.
run::ScaledSystem<Eigen::Dynamic> StickingStretch::with_flat_rings() const {
  run::ScaledSystem<Eigen::Dynamic> flat = system_;
  auto normal = normals_.begin();
  for (std::size_t i = 0; i < flat.contacts.size(); ++i) {
    auto& c = flat.contacts[i];
    if (!sticks_[i] || contact::linear(c.wall)) continue;
    const Eigen::Vector2d n = *normal++;
    const auto& ring = system_.contacts[i];
    c.first_row = n.x() * ring.first_row + n.y() * ring.second_row;
    c.second_row = n.x() * ring.second_row - n.y() * ring.first_row;
    c.first_push = n.x() * ring.first_push + n.y() * ring.second_push;
    c.second_push = n.x() * ring.second_push - n.y() * ring.first_push;
    c.offset = {n.x() * ring.offset[0] + n.y() * ring.offset[1],
                n.x() * ring.offset[1] - n.y() * ring.offset[0]};
    c.clearance -= c.offset[0];
  }
  return flat;
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
  mode_ = mode_of(modes, slips, place.state);
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
  mode_->move_tangents(duration_rad, flows_, motion_, place.tangent_vectors);
  mode_->move(duration_rad, flows_, motion_);
  run::add_contact(duration_rad / numerics::full_turn, report);
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

/// Upper bound of a peak within `duration_rad` of `motion`. Slow parts are taken as straight lines plus their
/// curvature. Vibrations that turn by more than a radian are taken at their full amplitude.
double StickingStretch::bound(const Watched& watched, double duration_rad) const {
  const Eigen::Index k = mode_->pairs();
  const double grown = std::exp(std::max(0.0, mode_->growth()) * duration_rad);
  Eigen::Vector2d from(0, 0), to(0, 0), more(0, 0);
  for (Eigen::Index row = 0; row < (watched.length ? 2 : 1); ++row) {
    const StickingView& view = watched.views[static_cast<std::size_t>(row)];
    ValueAndRate slow = value_of(view, at_);
    double bend = std::abs(view.harmonic);
    for (Eigen::Index j = 0; j < k; ++j) {
      const double length = std::hypot(at_.free(j), at_.free(k + j)) * grown;
      if (mode_->rate(j) * duration_rad < 1) {
        bend += view.curvature(j) * length;
        continue;
      }
      more(row) += view.size(j) * length;
      slow.value -= view.on_free(j) * at_.free(j) + view.on_free(k + j) * at_.free(k + j);
      slow.rate -= view.rate_on_free(j) * at_.free(j) + view.rate_on_free(k + j) * at_.free(k + j);
    }
    from(row) = slow.value;
    to(row) = slow.value + duration_rad * slow.rate;
    more(row) += bend * duration_rad * duration_rad / 2;
  }
  return watched.scale * (watched.length ? std::max(from.norm(), to.norm()) + more.norm()
                                         : std::max(from(0), to(0)) + more(0));
}

/// Raises the peaks by cubics through values and rates, as close together as the remaining vibration needs. A
/// fast vibration needs many of them; then blocks of cubics are first bounded as a whole.
void StickingStretch::raise_peaks(double duration_rad, run::TurnReport& report) {
  const double pieces = std::max(1.0, std::ceil(duration_rad / peak_step_rad())),
               size = duration_rad / pieces, block = std::max(1.0, std::floor(peak_step / size));
  const double blocks = block < least_block ? 0 : std::floor(pieces / block);
  mode_->put_flows(size, flows_);
  at_ = motion_;
  if (blocks > 0) raise_peaks_by_blocks(blocks, block, size, report);
  raise_peaks_by_cubics(pieces - blocks * block, size, report);
}

/// Moves `at_` on by this number of blocks of cubics. The most promising block of each peak comes first;
/// blocks without a higher peak are skipped.
void StickingStretch::raise_peaks_by_blocks(double blocks, double block, double size,
                                            run::TurnReport& report) {
  promising_.resize(made_->watched.size());
  for (Promising& place : promising_) place.bound = -std::numeric_limits<double>::infinity();
  mode_->put_flows(block * size, block_flows_);
  for (double k = 0; k < blocks; ++k) {
    for (std::size_t i = 0; i < promising_.size(); ++i) {
      const double most = bound(made_->watched[i], block * size);
      if (most > promising_[i].bound) promising_[i] = {most, at_};
    }
    mode_->move(block * size, block_flows_, at_);
  }
  for (const Promising& place : promising_) {
    at_ = place.at;
    raise_peaks_by_cubics(block, size, report);
  }
  at_ = motion_;
  const auto may_rise = [&](const Watched& watched) {
    return bound(watched, block * size) > report.*watched.peak * (1 + unseen);
  };
  for (double k = 0; k < blocks; ++k) {
    if (std::ranges::any_of(made_->watched, may_rise)) {
      raise_peaks_by_cubics(block, size, report);
    } else {
      mode_->move(block * size, block_flows_, at_);
    }
  }
}

/// Moves `at_` on by `pieces` cubics of this size.
void StickingStretch::raise_peaks_by_cubics(double pieces, double size, run::TurnReport& report) {
  const auto square = [](const Watched& watched, const StickingMotion& motion) {
    const ValueAndRate x = value_of(watched.views[0], motion);
    if (!watched.length) return x;
    const ValueAndRate y = value_of(watched.views[1], motion);
    return ValueAndRate{x.value * x.value + y.value * y.value, 2 * (x.value * x.rate + y.value * y.rate)};
  };
  for (double k = 0; k < pieces; ++k) {
    before_ = at_;
    mode_->move(size, flows_, at_);
    for (const Watched& watched : made_->watched) {
      const ValueAndRate from = square(watched, before_), to = square(watched, at_);
      const double top = numerics::cubic_maximum(from.value, size * from.rate, to.value, size * to.rate);
      double& peak = report.*watched.peak;
      peak = std::max(peak, watched.scale * (watched.length ? std::sqrt(std::max(0.0, top)) : top));
    }
  }
}

}  // namespace rubsweep::integrate::exact
