#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <variant>
#include <vector>

#include "rubsweep/core/contact/contact_mode.hpp"
#include "rubsweep/core/contact/dry_friction.hpp"
#include "rubsweep/core/integrate/run/pulse_times.hpp"
#include "rubsweep/core/integrate/run/scaled_system.hpp"
#include "rubsweep/core/integrate/taylor/contact_directions.hpp"
#include "rubsweep/core/integrate/taylor/contact_jacobian.hpp"
#include "rubsweep/core/integrate/taylor/contact_series.hpp"
#include "rubsweep/core/integrate/taylor/creep.hpp"
#include "rubsweep/core/integrate/taylor/expand_in_registers.hpp"
#include "rubsweep/core/integrate/taylor/state_series.hpp"
#include "rubsweep/core/integrate/taylor/sticking_contacts.hpp"
#include "rubsweep/core/numerics/taylor_series.hpp"

namespace rubsweep::integrate::taylor {

/// Motion of a scaled system from one instant as a power series of the phase, within one joint contact mode:
/// u'' = linear structure + unbalance + pulses + forces of the touching contacts.
template <int N>
class Expansion {
 public:
  using Vector = Eigen::Matrix<double, N, 1>;

  explicit Expansion(const run::ScaledSystem<N>& system, const SeriesOptions& options = {})
      : system_(system),
        structure_(system),
        series_(system.coordinates(), options),
        acceleration_(system.coordinates()),
        contacts_(system.contacts.size()),
        jacobians_(system.contacts.size()),
        creeps_(system.contacts.size()),
        creeping_(system.contacts.size(), false),
        sticking_(system) {
    for (const auto& contact : system.contacts) laws_.emplace_back(contact);
    pulses_.reserve(system.pulses.size());
    touching_.reserve(contacts_.size());
    for (const auto& contact : system.contacts) directions_.push_back(directions_of(contact));
  }

  /// Expands from `state` (u then u') at `phase_rad` in the revolution, with the pulses acting there. Per
  /// contact: `modes`; `slips`, used with dry friction; `poised` (may be empty).
  void expand(const double* state, double phase_rad, const run::PulseTimes& pulses,
              const std::vector<contact::Mode>& modes, const std::vector<contact::Slip>& slips,
              const std::vector<bool>& poised = {}) {
    series_.begin(state);
    begin_contacts(modes, slips, poised);
    start_drives(phase_rad, pulses);
    if constexpr (N != Eigen::Dynamic) {
      if (expanded_in_registers()) return complete_contacts();
    }
    for (int k = 0; k < order(); ++k) {
      accelerate(k);
      series_.v(k + 1) = acceleration_ * numerics::one_over(k + 1);
      series_.u(k + 2) = series_.v(k + 1) * numerics::one_over(k + 2);
    }
    complete_contacts();
  }

  /// Sets whether contact `i` creeps from the next expansion on. It starts with its slip at the start of the
  /// present expansion.
  void set_creeping(std::size_t i, bool creeps) {
    creeping_[i] = creeps;
    if (creeps) creeps_[i].begin(laws_[i], slip(i));
  }
  Creep& creep(std::size_t i) { return creeps_[i]; }
  /// Whether some contact creeps in the present expansion.
  bool any_creeps() const {
    return std::ranges::any_of(touching_, [&](std::size_t i) { return contacts_[i].creep() != nullptr; });
  }
  /// Slip of contact `i` at the start of the expansion.
  double slip(std::size_t i) const {
    const ContactSeries& c = contacts_[i];
    const numerics::Twin d = c.distance()[0], v = c.velocity()[0];
    const double sliding =
        laws_[i].annular ? (d[0] * v[1] - d[1] * v[0]) / std::sqrt(d[0] * d[0] + d[1] * d[1]) : v[1];
    return laws_[i].slip_scale_m_per_s * sliding + laws_[i].surface_speed_m_per_s;
  }

  /// Index of the only touching contact, if it slips and the structure is diagonal; otherwise empty.
  std::optional<std::size_t> only_slip() const {
    if (!system_.diagonal || touching_.size() != 1 || sticking_.count() > 0) return std::nullopt;
    return touching_[0];
  }
  /// Whether the structure is diagonal and nothing touches.
  bool flies() const { return system_.diagonal && touching_.empty(); }
  const DiagonalStructure<N>& structure() const { return structure_; }
  const ContactDirections<N>& directions(std::size_t i) const { return directions_[i]; }

  const StickingContacts<N>& sticking() const { return sticking_; }

  /// Changes the velocities of `state` by friction impulses at the contacts that stick or creep, so that
  /// their sliding speeds change by `by`.
  void change_slips(const contact::StickVector& by, double* state) const {
    const contact::StickVector impulse = contact::holding_forces(sticking_.mobility(), by);
    Eigen::Map<Vector> v(state + system_.coordinates(), system_.coordinates());
    for (Eigen::Index j = 0; j < by.size(); ++j)
      v -= impulse(j) * sticking_.push(sticking_[j], contacts_[sticking_[j]]);
  }

  const StateSeries<N>& series() const { return series_; }
  int order() const { return series_.order(); }
  double accuracy() const { return series_.accuracy(); }
  void set_accuracy(double accuracy) { series_.set_accuracy(accuracy); }
  const ContactLaw& law(std::size_t i) const { return laws_[i]; }
  ContactSeries& contact(std::size_t i) { return contacts_[i]; }
  const ContactSeries& contact(std::size_t i) const { return contacts_[i]; }
  ContactJacobian& jacobian(std::size_t i) { return jacobians_[i]; }

 private:
  void begin_contacts(const std::vector<contact::Mode>& modes, const std::vector<contact::Slip>& slips,
                      const std::vector<bool>& poised) {
    sticking_.clear();
    touching_.clear();
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
      const auto& offset = system_.contacts[i].offset;
      contacts_[i].set_distance(at_contact(system_.contacts[i], series_.u(0)) +
                                numerics::Twin{offset[0], offset[1]});
      contacts_[i].set_velocity(0, at_contact(system_.contacts[i], series_.v(0)));
      const bool open = modes[i] == contact::Mode::open;
      contacts_[i].begin(laws_[i], modes[i], open ? 0 : slip(i), slips[i], i < poised.size() && poised[i]);
      if (!open) touching_.push_back(i);
      if (!open && creeping_[i]) contacts_[i].follow(creeps_[i]);
      if (contacts_[i].sticks()) sticking_.add(i);
      jacobians_[i].follow(contacts_[i]);
    }
  }

  /// An acting half-sine pulse, given by sine and cosine of its angle.
  struct ActingPulse {
    std::size_t index = 0;
    double sine = 0, cosine = 1;
  };

  /// Starts the recurrences for the coefficients of cosine and sine of the phase and of pulse angles.
  void start_drives(double phase_rad, const run::PulseTimes& pulses) {
    cosine_ = std::cos(phase_rad);
    sine_ = std::sin(phase_rad);
    pulses_.clear();
    for (const std::size_t i : pulses.acting()) {
      const double angle = system_.pulses[i].rate * (pulses.elapsed(i) + phase_rad);
      pulses_.push_back({i, std::sin(angle), std::cos(angle)});
    }
  }

  /// Expands in registers if no pulse acts, the structure is diagonal and at most one contact touches, which
  /// must slip. Otherwise returns false without doing anything.
  bool expanded_in_registers() {
    if (!pulses_.empty()) return false;
    const DriveTerms drives{numerics::both(cosine_), numerics::both(sine_)};
    if (const auto i = only_slip()) {
      std::visit(
          [&](const auto& directions) {
            expand_in_registers(structure_, directions, drives, contacts_[*i], series_);
          },
          directions_[*i]);
      return true;
    }
    if (!flies()) return false;
    NoContact none;
    expand_in_registers(structure_, none, drives, none, series_);
    return true;
  }

  /// Computes coefficient k of the acceleration; drives and contacts advance to the next one.
  void accelerate(int k) {
    Vector& a = acceleration_;
    if (system_.diagonal) {
      a = -system_.stiffness_diagonal.cwiseProduct(series_.u(k)) -
          system_.damping_diagonal.cwiseProduct(series_.v(k));
    } else {
      a.noalias() = system_.stiffness * series_.u(k);
      a.noalias() += system_.damping * series_.v(k);
      a = -a;
    }
    if (k == 0) a += system_.constant;
    a += system_.cosine * cosine_ + system_.sine * sine_;
    const double next = numerics::one_over(k + 1), cosine = cosine_;
    cosine_ = -next * sine_;
    sine_ = next * cosine;
    for (ActingPulse& pulse : pulses_) {
      a += system_.pulses[pulse.index].top * pulse.sine;
      const double rate = system_.pulses[pulse.index].rate * next, sine = pulse.sine;
      pulse.sine = rate * pulse.cosine;
      pulse.cosine = -rate * sine;
    }
    for (const std::size_t i : touching_) {
      const numerics::Twin force = contacts_[i].force_term(k);
      a += system_.contacts[i].first_push * force[0];
      a += system_.contacts[i].second_push * force[1];
    }
    if (sticking_.count() > 0) sticking_.hold(k, contacts_, a);
    for (const std::size_t i : touching_)
      contacts_[i].set_velocity(k + 1, at_contact(system_.contacts[i], acceleration_) * numerics::both(next));
  }

  /// Completes the velocities of open contacts for their guards.
  void complete_contacts() {
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
      if (contacts_[i].mode() != contact::Mode::open) continue;
      for (int k = 1; k < order(); ++k)
        contacts_[i].set_velocity(k, at_contact(system_.contacts[i], series_.v(k)));
    }
  }

  const run::ScaledSystem<N>& system_;
  DiagonalStructure<N> structure_;
  StateSeries<N> series_;
  Vector acceleration_;
  std::vector<ContactLaw> laws_;
  std::vector<ContactSeries> contacts_;
  std::vector<ContactJacobian> jacobians_;
  std::vector<Creep> creeps_;
  std::vector<char> creeping_;
  std::vector<ContactDirections<N>> directions_;  ///< for each contact
  std::vector<std::size_t> touching_;
  StickingContacts<N> sticking_;  ///< or creeping
  double cosine_ = 1, sine_ = 0;
  std::vector<ActingPulse> pulses_;
};

}  // namespace rubsweep::integrate::taylor
