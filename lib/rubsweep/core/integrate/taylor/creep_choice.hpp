#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "rubsweep/core/contact/contact_mode.hpp"
#include "rubsweep/core/contact/dry_friction.hpp"
#include "rubsweep/core/integrate/law/dynamics.hpp"
#include "rubsweep/core/integrate/taylor/expansion.hpp"

namespace rubsweep::integrate::taylor {

/// Duration up to which the change by the latest sweep of `creep` is at most `smallest`; zero where it is
/// larger from the start.
inline double unchanged_rad(const Creep& creep, int order, double smallest) {
  if (std::abs(creep.change(0)) > smallest) return 0;
  double longest = std::numeric_limits<double>::infinity();
  for (int k = 1; k < order; ++k) {
    const double change = std::abs(creep.change(k));
    if (change * std::pow(std::min(longest, 1.0), k) > smallest)
      longest = std::min(longest, std::pow(smallest / change, 1.0 / k));
  }
  return longest;
}

/// Expands a motion by `expand(state)`, with the creeping contacts set by `Expansion::set_creeping`, until
/// sweeps change only the rounding. What remains of the transient in the slips of `state` is removed if this
/// changes the slips only by rounding. Returns the duration over which the result is accurate, at most
/// `longest_rad`. Returns zero, with `state` unchanged, where this is less than `worth_rad`. `settled` is
/// scratch for a state.
template <int N, class Expand>
double settle_creep(Expansion<N>& motion, const Expand& expand, std::vector<double>& state,
                    std::vector<double>& settled, double longest_rad, double worth_rad) {
  constexpr double rounding = 1e-16, start_noise = 1e-13;
  settled = state;
  double moved = 0, reach = 0;
  for (int sweep = 0; sweep < most_creep_sweeps; ++sweep) {
    expand(settled);
    const double speed = std::max(1.0, motion.series().speed());
    const double wanted = motion.series().converged_rad(longest_rad);
    if (!(wanted >= worth_rad)) return 0;
    reach = wanted;
    double change = 0;
    contact::StickVector by(static_cast<Eigen::Index>(motion.sticking().count()));
    for (Eigen::Index j = 0; j < by.size(); ++j) {
      const std::size_t i = motion.sticking()[j];
      by(j) = 0;
      if (!motion.contact(i).creep()) continue;
      Creep& creep = motion.creep(i);
      if (!creep.sweep(motion.contact(i), motion.order())) return 0;
      by(j) = (creep.slip_m_per_s() - motion.slip(i)) / motion.law(i).slip_scale_m_per_s;
      change = std::max(change, std::abs(creep.change(0)));
      reach = std::min(reach, unchanged_rad(creep, motion.order(), rounding * speed));
    }
    if (reach >= wanted) break;
    motion.change_slips(by, settled.data());
    moved = 0;
    for (std::size_t k = state.size() / 2; k < state.size(); ++k)
      moved = std::max(moved, std::abs(settled[k] - state[k]));
    // By now the remaining transient of the slip is known, and it is too large.
    if (moved > start_noise * speed && change < 0.1 * moved) return 0;
  }
  if (moved > start_noise * std::max(1.0, motion.series().speed()) || reach < worth_rad) return 0;
  motion.series().put_state(0, state.data());
  return reach;
}

/// Largest `Dynamics::friction_ratio` of the touching contacts that neither creep nor stick.
template <int N>
double friction_ratio(const Expansion<N>& motion, const law::Dynamics<N, false>& dynamics,
                      const std::vector<double>& state) {
  double largest = 0;
  for (std::size_t i = 0; i < dynamics.modes().size(); ++i) {
    if (dynamics.modes()[i] != contact::Mode::open && motion.contact(i).friction_varies())
      largest = std::max(largest, dynamics.friction_ratio(i, state));
  }
  return largest;
}

/// Chooses the pieces of a run that are expanded with creeping contacts. In these pieces friction is steep,
/// the slip's own transient has decayed, and the piece is long enough to justify the sweeps.
template <int N>
class CreepChoice {
 public:
  /// Contacts may creep where `Dynamics::friction_ratio` exceeds `creep_above`.
  explicit CreepChoice(double creep_above) : creep_above_(creep_above) {}

  void begin_turn() { pieces_to_wait_ = 0; }
  /// Excludes creep from the next few pieces.
  void wait() { pieces_to_wait_ = pieces_until_creep; }
  /// Whether the next piece may creep at this largest friction ratio. Counts pieces that wait.
  bool due(double ratio) {
    if (!(ratio > creep_above_)) return false;
    if (pieces_to_wait_ == 0) return true;
    --pieces_to_wait_;
    return false;
  }

  /// Repeats the expansion, by `expand(state)`, with all contacts with steep friction creeping. False, with
  /// the expansion unchanged, where creep may not last. `longest_rad`: longest piece without regard to
  /// friction; `usual_rad`: longest piece without creep; `state` and `settled` as in `settle_creep`.
  template <class Expand>
  bool begin(Expansion<N>& motion, const law::Dynamics<N, false>& dynamics, const Expand& expand,
             std::vector<double>& state, std::vector<double>& settled, double longest_rad, double usual_rad) {
    start_creep(motion, dynamics, state);
    known_rad_ = settle_creep(motion, expand, state, settled, longest_rad, least_gain * usual_rad);
    if (known_rad_ > 0) return true;
    wait();
    stop_creep(motion, dynamics);
    expand(state);
    return false;
  }
  /// Duration over which the series of the creeping contacts are accurate.
  double known_rad() const { return known_rad_; }
  /// Ends creep from the next expansion on.
  void end(Expansion<N>& motion, const law::Dynamics<N, false>& dynamics) {
    if (known_rad_ > 0) stop_creep(motion, dynamics);
    known_rad_ = 0;
  }

 private:
  /// Number of pieces to wait. In each usual piece the remaining transient of a slip falls to a hundredth or
  /// less.
  static constexpr int pieces_until_creep = 6;
  static constexpr double least_gain = 12;  ///< least length of a piece with creep, in usual pieces

  void start_creep(Expansion<N>& motion, const law::Dynamics<N, false>& dynamics,
                   const std::vector<double>& state) const {
    std::size_t held = motion.sticking().count();
    for (std::size_t i = 0; i < dynamics.modes().size(); ++i) {
      if (dynamics.modes()[i] == contact::Mode::open || !motion.contact(i).friction_varies()) continue;
      const bool creeps = held < contact::most_sticking && dynamics.friction_ratio(i, state) > creep_above_;
      motion.set_creeping(i, creeps);
      if (creeps) ++held;
    }
  }
  static void stop_creep(Expansion<N>& motion, const law::Dynamics<N, false>& dynamics) {
    for (std::size_t i = 0; i < dynamics.modes().size(); ++i) motion.set_creeping(i, false);
  }

  double creep_above_;
  double known_rad_ = 0;
  int pieces_to_wait_ = 0;
};

}  // namespace rubsweep::integrate::taylor
