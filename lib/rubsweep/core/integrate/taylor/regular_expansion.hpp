#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include "rubsweep/core/integrate/law/dynamics.hpp"
#include "rubsweep/core/integrate/run/scaled_system.hpp"
#include "rubsweep/core/integrate/taylor/guard_search.hpp"
#include "rubsweep/core/integrate/taylor/regular_contact.hpp"
#include "rubsweep/core/integrate/taylor/regular_series.hpp"
#include "rubsweep/core/integrate/taylor/regular_time.hpp"
#include "rubsweep/core/integrate/taylor/step_length.hpp"
#include "rubsweep/core/integrate/taylor/sticking_contacts.hpp"
#include "rubsweep/core/numerics/dense/eigenvalues.hpp"
#include "rubsweep/core/numerics/matrix_flow.hpp"
#include "rubsweep/core/numerics/taylor_series.hpp"

namespace rubsweep::integrate::taylor {

/// Motion of a scaled system as power series of a regular time s, within one joint contact mode. A force K
/// p^n with n = 1.5 or 2.5 has no power series of the phase at the penetration p = 0, where contacts begin
/// and end. With the root w = sqrt(p) and the pace d phase / ds = w (Sundman's transformation), dw/ds = p' /
/// 2 and K p^n = K w^(2 n) are analytic there. Far from such a point the pace is 1.
template <int N>
class RegularExpansion {
 public:
  /// `system` must outlive this object. `accuracy` as in SeriesOptions.
  RegularExpansion(const run::ScaledSystem<N>& system, double accuracy)
      : system_(system),
        accuracy_(accuracy),
        structure_rate_(
            numerics::dense::spectral_radius(numerics::generator_of(system.stiffness, system.damping))),
        sticking_(system),
        series_(system) {
    for (const auto& contact : system.contacts) {
      laws_.emplace_back(contact);
      contacts_.emplace_back(PowerLaw(contact.law.get(), contact.length_m));
    }
    for (int k = 0; k <= order; ++k)
      largest_term_[static_cast<std::size_t>(k)] =
          k >= order - 1 ? accuracy_ : std::pow(accuracy_, static_cast<double>(k) / order);
    for (auto* list : {&touching_, &near_}) list->reserve(contacts_.size());
    touches_.reserve(contacts_.size());
    reach_.resize(system.coordinates());
    pulses_.reserve(system.pulses.size());
  }

  /// Expands from `state` (u then u') and its rate with the modes, slips and dampings of `law`. False where
  /// there is no such series: a contact obeys another law, touches without closing, is near its beginning or
  /// end with another n, or there beside a second one that is so, has another n or sticks; or the number of
  /// coordinates is odd.
  template <class State>
  bool expand(const State& state, const State& rate, double phase_rad, const law::Dynamics<N, false>& law) {
    if (system_.coordinates() % 2 != 0) return false;
    series_.begin(&state[0], numerics::Twin{std::cos(phase_rad), std::sin(phase_rad)});
    start_pulses(phase_rad, law.pulses());
    if (!begin_contacts(state, rate, law)) return false;
    for (int k = 0; k < order; ++k) {
      make_rate(k);
      if (sticking_.count() > 0) hold(k);
      if (k == 0 && pacer_ && pacer_->root()[0] == 0 && pacer_->closing_term(0) <= 0) return false;
      advance(k);
    }
    for (const Touch& touch : touches_) {
      if (pacer_) put_distance(touch, order);
      touch.contact->set_velocity(order, series_.velocity(*touch.scaled, order));
    }
    return true;
  }

  /// The longest s over which the series are accurate.
  double converged() {
    const double length = std::max(1.0, series_.size(0, 0)), speed = std::max(1.0, series_.size(1, 0));
    double longest = longest_parameter;
    for (int k = order - most_gap; k <= order; ++k) {
      const double term = std::max(series_.size(0, k) / length, series_.size(1, k) / speed),
                   largest = largest_term_[static_cast<std::size_t>(k)];
      if (!std::isfinite(term)) return 0;
      longest = numerics::longest_below(longest, term, k, largest);
    }
    for (int k = order - most_gap; pacer_ && k <= order; ++k) {
      const double root = pacer_->root()[0] + std::abs(pacer_->root()[1]) * longest;
      longest = numerics::longest_below(longest, std::abs(pacer_->root()[k]), k,
                                        largest_term_[static_cast<std::size_t>(k)] * root);
    }
    near_.clear();
    series_.put_reach(longest, reach_);
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
      if (contacts_[i].mode() == contact::Mode::open) {
        if (stays_open(i)) continue;
        const Touch open{&contacts_[i], &system_.contacts[i]};
        for (int k = 0; k <= order; ++k) put_distance(open, k);
        contacts_[i].make_open_penetration(order);
      }
      near_.push_back(i);
      longest = guards_converged_rad(contacts_[i], order, accuracy_, longest);
    }
    return longest;
  }
  /// Largest advance of the phase within s = `end`: up to it, polynomials treat rounding as the motion would.
  double most_rad(double end) const {
    const double structure = structure_rate_ * structure_rate_;
    double square = structure, damping = 0;
    for (const std::size_t i : touching_) {
      const RegularContact& c = contacts_[i];
      double deepest = std::max(0.0, c.penetration_term(0));
      if (c.is_pace()) deepest = std::max(deepest, numerics::power(time_.pace_at(end), 2));
      square += c.power().slope(deepest) * laws_[i].mobility;
      damping += c.impact_damping() * c.power().force_n(deepest) * laws_[i].mobility;
    }
    // A fast vibration that is well damped dies out within a step, and so may a larger error of it.
    const bool dies_out = touching_.size() == 1 && 4 * structure < square && damping * damping > square / 4;
    return (dies_out ? longest_of_damped : longest_times_fastest) / std::max(1 + damping, std::sqrt(square));
  }

  /// First change of a contact's mode, or end of its sticking, up to s = `end`, which moves there; without a
  /// contact if there is none. False where a guard is past zero at the start.
  struct Event {
    std::optional<std::size_t> contact{};
    contact::Mode next = contact::Mode::open;
    contact::Slip slip = contact::Slip::sticking;  ///< direction of the slip that begins instead
  };
  bool find_event(double& end, Event& event) {
    std::array<double, std::size_t{order}> powers;
    numerics::put_powers(end, order, powers.data());
    for (const std::size_t i : near_) {
      RegularContact& contact = contacts_[i];
      // Whether the guard is not past zero at the start; its first rise becomes the event.
      const auto look = [&](contact::Mode next, const auto& term,
                            contact::Slip slip = contact::Slip::sticking) {
        std::array<double, std::size_t{order}> guard;
        for (std::size_t k = 0; k < guard.size(); ++k) guard[k] = powers[k] * term(static_cast<int>(k));
        const auto rise = first_rise(guard, accuracy_);
        if (!rise) return true;
        end *= *rise;
        numerics::put_powers(end, order, powers.data());
        event = {i, next, slip};
        return *rise > 0;
      };
      if (contact.mode() == contact::Mode::open) {
        if (!look(contact::Mode::sprung, [&](int k) { return contact.penetration_term(k); })) return false;
        continue;
      }
      const bool opens = look(contact::Mode::open, [&](int k) {
        return contact.is_pace() ? -contact.root()[k] : -contact.penetration_term(k);
      });
      if (!opens) return false;
      const double damping = contact.impact_damping();
      const bool released = contact.mode() == contact::Mode::released;
      const double sign = released ? 1 : -1;
      if (damping > 0 && !look(released ? contact::Mode::sprung : contact::Mode::released, [&](int k) {
            return sign * ((k == 0 ? 1 : 0) + damping * contact.closing_term(k));
          }))
        return false;
      for (const contact::Slip slip : {contact::Slip::forward, contact::Slip::backward}) {
        const double way = contact::sign_of(slip);
        if (contact.sticks() && !look(
                                    contact.mode(),
                                    [&](int k) {
                                      return way * contact.holding().number(k) -
                                             contact.law().friction.holding * contact.spring_term(k);
                                    },
                                    slip))
          return false;
      }
      const double share = saturated_share(contact, order, end);
      if (share == 1) continue;
      event = {};
      end *= share;
      numerics::put_powers(end, order, powers.data());
    }
    return true;
  }

  const RegularTime& time() const { return time_; }
  const numerics::Series* pace() const { return pacer_ ? &time_.pace : nullptr; }  ///< null: s is the phase
  const std::vector<std::size_t>& touching() const { return touching_; }
  bool sticks() const { return sticking_.count() > 0; }
  RegularContact& contact(std::size_t i) { return contacts_[i]; }

  /// Writes u then u' at s.
  void put_state(double s, double* to) const { series_.put_state(s, order, to); }

 private:
  static constexpr int order = RegularSeries<N>::order;
  /// Without other forces, only each fifth term (with n = 2.5 each seventh) of a series is not zero.
  static constexpr int most_gap = 6;
  static constexpr double longest_parameter = 1e6;
  /// As longest_times_fastest, for a contact mode whose damping ratio is at least 1/4: 10^25 / 25! = 0.6 and
  /// e^(-10 / 4) = 0.08 are less than 1 together.
  static constexpr double longest_of_damped = 10;

  void start_pulses(double phase_rad, const run::PulseTimes& pulses) {
    pulses_.clear();
    for (const std::size_t i : pulses.acting()) {
      const double angle = system_.pulses[i].rate * (pulses.elapsed(i) + phase_rad);
      ActingPulse& pulse = pulses_.emplace_back();
      pulse.index = i;
      pulse.sine.set(0, std::sin(angle));
      pulse.cosine.set(0, std::cos(angle));
    }
  }

  template <class State>
  bool begin_contacts(const State& state, const State& rate, const law::Dynamics<N, false>& law) {
    touching_.clear();
    touches_.clear();
    sticking_.clear();
    pacer_ = nullptr;
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
      const contact::Mode mode = law.modes()[i];
      const bool open = mode == contact::Mode::open;
      RegularContact& c = contacts_[i];
      c.begin(laws_[i], mode, open ? 0 : law.slip_m_per_s(i, state), law.slips()[i]);
      if (open) continue;
      if (law.poised(i) || c.power().exponent == 0) return false;
      const bool paces = !c.power().whole() && !far_from_zero(i, law.kinematics(i, state, rate));
      if (paces && (pacer_ || !c.power().rooted())) return false;
      if (paces) pacer_ = &c;
      if (c.sticks()) sticking_.add(i);
      c.begin_power(law.impact_damping(i), paces);
      touching_.push_back(i);
      touches_.push_back({&c, &system_.contacts[i]});
    }
    time_.even = !pacer_;
    if (time_.even) return true;
    // The recurrence of a power whose 2 n is no integer holds by the phase alone.
    const auto by_phase = [](const Touch& touch) { return touch.contact->power().halves == 0; };
    if (sticking_.count() > 0 || std::ranges::any_of(touches_, by_phase)) return false;
    for (const Touch& touch : touches_) touch.contact->follow_pace();
    return true;
  }

  /// Whether the penetration stays above zero so long that series of the phase, whose pieces cost half as
  /// much, are better: longer than a share of a radian of the contact's vibration there.
  bool far_from_zero(std::size_t i, const contact::Kinematics& k) const {
    const PowerLaw& power = contacts_[i].power();
    const double p = k.penetration;
    if (p <= 0) return false;
    constexpr double share = 0.3;
    const double square = laws_[i].mobility * power.slope(p);
    return square * p * p > share * share * k.closing_speed * k.closing_speed &&
           2 * square * p > share * share * std::abs(k.closing_acceleration);
  }

  /// Whether an open contact surely stays so as long as no coordinate goes beyond `reach_`.
  bool stays_open(std::size_t i) {
    const auto& c = system_.contacts[i];
    const numerics::Twin from = series_.distance(c, 0) + numerics::Twin{c.offset[0], c.offset[1]};
    const double first = c.first_row.cwiseAbs().dot(reach_.transpose());
    if (!laws_[i].annular) return from[0] + first < laws_[i].clearance;
    const double second = c.second_row.cwiseAbs().dot(reach_.transpose());
    return std::hypot(std::abs(from[0]) + first, std::abs(from[1]) + second) < laws_[i].clearance;
  }

  struct Touch {
    RegularContact* contact = nullptr;
    const run::ScaledContact<N>* scaled = nullptr;
  };
  void put_distance(const Touch& touch, int k) {
    const auto& c = *touch.scaled;
    const numerics::Twin distance = series_.distance(c, k);
    touch.contact->set_distance(k, k == 0 ? distance + numerics::Twin{c.offset[0], c.offset[1]} : distance);
  }

  /// A separate function, so that it does not take registers from expansions in which nothing sticks.
  [[gnu::noinline]] void hold(int k) { sticking_.hold(k, contacts_, series_.acceleration(k)); }

  /// Computes coefficient k of the rates by the phase.
  void make_rate(int k) {
    series_.begin_rate(k);
    for (const ActingPulse& pulse : pulses_)
      series_.acceleration(k) += system_.pulses[pulse.index].top * pulse.sine[k];
    for (const Touch& touch : touches_) {
      if (pacer_ || k == 0) put_distance(touch, k);
      touch.contact->set_velocity(k, series_.velocity(*touch.scaled, k));
      series_.push(*touch.scaled, k, touch.contact->power_term(k));
    }
  }

  /// Computes coefficient k of the pace, then coefficient k + 1 of everything whose rate is known.
  void advance(int k) {
    if (pacer_ || !pulses_.empty()) time_.pace.set(k, pacer_ ? pacer_->root()[k] : k == 0 ? 1 : 0);
    const numerics::Series* const pace = this->pace();
    series_.advance(k, pace);
    for (ActingPulse& pulse : pulses_) {
      const double by = system_.pulses[pulse.index].rate * numerics::one_over(k + 1);
      const double sine = by * numerics::product_term(time_.pace, pulse.cosine, k);
      pulse.cosine.set(k + 1, -by * numerics::product_term(time_.pace, pulse.sine, k));
      pulse.sine.set(k + 1, sine);
    }
    for (const Touch& touch : touches_) touch.contact->advance(k, pace);
  }

  struct ActingPulse {
    std::size_t index = 0;
    numerics::Series sine, cosine;
  };

  const run::ScaledSystem<N>& system_;
  double accuracy_, structure_rate_;
  /// Largest term k of a converged series: the accuracy for the last two, as much by their growth for others.
  std::array<double, std::size_t{order} + 1> largest_term_{};
  std::vector<ContactLaw> laws_;
  std::vector<RegularContact> contacts_;
  std::vector<std::size_t> touching_, near_;  ///< near_: contacts that may change their mode
  std::vector<Touch> touches_;
  Eigen::Matrix<double, N, 1> reach_;
  const RegularContact* pacer_ = nullptr;  ///< contact whose root is the pace; null: the pace is 1
  std::vector<ActingPulse> pulses_;
  RegularTime time_;
  StickingContacts<N> sticking_;
  RegularSeries<N> series_;
};

}  // namespace rubsweep::integrate::taylor
