#include "bench/long_double_run.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <variant>

#include "rubsweep/core/contact/friction_law.hpp"
#include "rubsweep/core/error.hpp"
#include "rubsweep/core/integrate/run/state_scale.hpp"
#include "rubsweep/core/overloaded.hpp"
#include "rubsweep/core/scene/quiet_motion.hpp"

namespace rubsweep::bench {
namespace {

using Real = LongDoubleRun::Real;
using Vector = LongDoubleRun::Vector;
using State = LongDoubleRun::State;

constexpr long most_steps = 1'000'000;
constexpr Real turn_rad = 2 * std::numbers::pi_v<Real>;

auto displacements(const State& state) {
  return Eigen::Map<const Vector>(state.data(), static_cast<Eigen::Index>(state.size() / 2));
}

auto velocities(const State& state) {
  return Eigen::Map<const Vector>(state.data() + state.size() / 2,
                                  static_cast<Eigen::Index>(state.size() / 2));
}

Real friction_coefficient(const model::Friction& friction, Real slip) {
  const contact::FrictionTerms terms = contact::friction_terms(friction);
  Real mu = terms.constant + terms.viscous_s_per_m * slip;
  for (std::size_t i = 0; i < terms.count; ++i)
    mu += terms.tanh[i].height * std::tanh(terms.tanh[i].steepness_s_per_m * slip);
  return mu;
}

/// Factor for the length of the next step, for a method of order 7.
Real length_factor(Real allowed_over_error) {
  return std::clamp(Real(0.9) * std::pow(allowed_over_error, Real(0.125)), Real(0.2), Real(2));
}

}  // namespace

bool LongDoubleRun::applies(const scene::Scene& scene) {
  return !scene.twist && scene.impulses.empty() &&
         std::ranges::none_of(scene.contacts, [](const scene::Contact& contact) {
           return contact.law || contact::holding_coefficient(contact.friction) != 0;
         });
}

LongDoubleRun::LongDoubleRun(const scene::Scene& scene, Real tolerance)
    : length_m_(scene.length_scale_m), speed_(scene.speed_rad_per_s), tolerance_(tolerance) {
  if (!applies(scene))
    throw std::invalid_argument("dry friction, curved contact laws, torsion or impulse trains");
  const structure::LinearSystem& system = scene.structure;
  const Real newtons = length_m_ * speed_ * speed_;
  inverse_mass_ = Matrix(system.mass.cast<Real>()).inverse();
  damping_ = inverse_mass_ * system.damping.cast<Real>() / speed_;
  stiffness_ = inverse_mass_ * system.stiffness.cast<Real>() / (speed_ * speed_);
  harmonic_cosine_ = inverse_mass_ * scene.harmonic_n.real().cast<Real>() / newtons;
  harmonic_sine_ = inverse_mass_ * scene.harmonic_n.imag().cast<Real>() / newtons;
  if (scene.second_harmonic_n.size() > 0) {
    second_cosine_ = inverse_mass_ * scene.second_harmonic_n.real().cast<Real>() / newtons;
    second_sine_ = inverse_mass_ * scene.second_harmonic_n.imag().cast<Real>() / newtons;
  }
  constant_ = inverse_mass_ * scene.constant_n.cast<Real>() / newtons;
  for (const scene::Pulse& pulse : scene.pulses) {
    const Real start = -Real(pulse.elapsed_s) * speed_;
    pulses_.push_back({inverse_mass_ * pulse.direction.cast<Real>() * Real(pulse.force_n) / newtons, start,
                       start + Real(pulse.duration_s) * speed_});
  }
  for (const scene::Contact& contact : scene.contacts) {
    contacts_.push_back({contact, scene::relative_map(system, contact).cast<Real>(),
                         contact::offset(contact.wall).cast<Real>() / length_m_,
                         Real(contact.clearance_m) / length_m_, Real(contact.stiffness_n_per_m) * length_m_,
                         Real(contact.damping_ns_per_m) * length_m_ * speed_});
  }
  const std::vector<double> start = integrate::run::scaled_initial_state(scene);
  restart({start.begin(), start.end()}, 0);
}

void LongDoubleRun::restart(const State& section, int turn) {
  state_ = section;
  phase_ = turn_rad * turn;
  choose_modes();
}

void LongDoubleRun::choose_modes() {
  for (Contact& c : contacts_) {
    const Motion m = motion(c, state_);
    c.mode = contact::mode_of(double(c.spring_n), double(c.damper_n), double(m.penetration),
                              double(m.closing_speed));
  }
}

LongDoubleRun::Motion LongDoubleRun::motion(const Contact& c, const State& state) const {
  const Eigen::Matrix<Real, 2, 1> d = c.relative * displacements(state) + c.offset,
                                  v = c.relative * velocities(state);
  const auto normal = std::visit(overloaded{[](const contact::FlatWall& flat) -> Eigen::Matrix<Real, 2, 1> {
                                              return flat.normal.cast<Real>();
                                            },
                                            [&](const contact::AnnularWall&) -> Eigen::Matrix<Real, 2, 1> {
                                              if (d.norm() == 0) return {0, 1};
                                              return d / d.norm();
                                            }},
                                 c.law.wall);
  return {normal, d.dot(normal) - c.clearance, v.dot(normal), normal(0) * v(1) - normal(1) * v(0)};
}

Vector LongDoubleRun::force_n(const Contact& c, const State& state) const {
  const contact::LinearLaw law = contact::law_of(c.mode);
  const Motion m = motion(c, state);
  const Real spring = c.spring_n * m.penetration;
  const Real total = law.spring * spring + law.damper * c.damper_n * m.closing_speed;
  const Real slip = length_m_ * speed_ * m.sliding_speed + c.law.surface_speed_m_per_s;
  const Real friction = friction_coefficient(c.law.friction, slip) * law.friction * spring;
  const Eigen::Matrix<Real, 2, 1> tangent(-m.normal(1), m.normal(0));
  return -(c.relative.transpose() * (m.normal * total + tangent * friction));
}

/// `middle`: a phase inside the step, which decides whether each pulse acts.
void LongDoubleRun::derivative(const State& state, State& slope, Real phase, Real middle) const {
  const auto q = displacements(state), v = velocities(state);
  Vector acceleration = constant_ + harmonic_cosine_ * std::cos(phase) - harmonic_sine_ * std::sin(phase) -
                        damping_ * v - stiffness_ * q;
  if (second_cosine_.size() > 0)
    acceleration += second_cosine_ * std::cos(2 * phase) - second_sine_ * std::sin(2 * phase);
  for (const Pulse& pulse : pulses_) {
    if (middle <= pulse.start || middle >= pulse.end) continue;
    const Real share = (phase - pulse.start) / (pulse.end - pulse.start);
    acceleration += pulse.force * std::sin(std::numbers::pi_v<Real> * share);
  }
  for (const Contact& c : contacts_) {
    if (c.mode != contact::Mode::open)
      acceleration += inverse_mass_ * force_n(c, state) / (length_m_ * speed_ * speed_);
  }
  std::copy(v.begin(), v.end(), slope.begin());
  std::copy(acceleration.begin(), acceleration.end(), slope.begin() + v.size());
}

Real LongDoubleRun::step(Real length, State& end) const {
  boost::numeric::odeint::runge_kutta_fehlberg78<State, Real> stepper;
  State error(state_.size());
  end.resize(state_.size());
  const auto system = [&, middle = phase_ + length / 2](const State& state, State& slope, Real phase) {
    derivative(state, slope, phase, middle);
  };
  stepper.do_step(system, state_, phase_, end, length, error);
  return std::abs(*std::max_element(error.begin(), error.end(),
                                    [](Real a, Real b) { return std::abs(a) < std::abs(b); }));
}

Real LongDoubleRun::guard(const Contact& c, const contact::GuardForm& form, const State& state) const {
  const Motion m = motion(c, state);
  return form.spring * m.penetration + form.damper * (c.damper_n / c.spring_n) * m.closing_speed;
}

Real LongDoubleRun::guard_rate(const Contact& c, const contact::GuardForm& form, const State& state,
                               Real phase) const {
  constexpr Real small = 1e-7L;
  State slope(state.size()), before = state, after = state;
  derivative(state, slope, phase, phase);
  for (std::size_t k = 0; k < state.size(); ++k) {
    before[k] -= small * slope[k];
    after[k] += small * slope[k];
  }
  return (guard(c, form, after) - guard(c, form, before)) / (2 * small);
}

std::optional<Real> LongDoubleRun::length_to_zero(const Contact& c, const contact::GuardForm& form,
                                                  Real length, const State& end) const {
  State there;
  const auto root = [this](const auto& function, Real low, Real high) {
    std::uintmax_t evaluations = 200;
    const auto near = [this](Real a, Real b) { return b - a <= 4e-19L * (phase_ + b); };
    return boost::math::tools::toms748_solve(function, low, high, near, evaluations).second;
  };
  const auto value = [&](Real part) {
    if (part == 0) return std::min(guard(c, form, state_), -std::numeric_limits<Real>::min());
    step(part, there);
    return guard(c, form, there);
  };
  const auto rate = [&](Real part) {
    if (part == 0) return guard_rate(c, form, state_, phase_);
    step(part, there);
    return guard_rate(c, form, there, phase_ + part);
  };
  const bool rises = rate(0) > 0, rises_at_end = rate(length) > 0;
  if (guard(c, form, end) > 0) {
    // A guard that falls at first may have started at zero; its root lies after its minimum.
    const Real bottom = !rises && rises_at_end ? root(rate, 0, length) : 0;
    return value(bottom) < 0 ? root(value, bottom, length) : 0;
  }
  // A guard that rises and falls again may have been positive between the ends.
  if (!rises || rises_at_end) return {};
  const Real top = root([&](Real part) { return -rate(part); }, 0, length);
  if (value(top) <= 0) return {};
  return root(value, 0, top);
}

/// Makes one step, which ends at the first change of a contact mode.
void LongDoubleRun::advance_piece(Real phase_end) {
  Real length = std::min(usual_length_, phase_end - phase_);
  State end;
  Real error = step(length, end);
  while (error > tolerance_ && length > 1e-9L) {
    length = usual_length_ = length * length_factor(tolerance_ / error);
    error = step(length, end);
  }
  if (length == usual_length_) usual_length_ *= length_factor(tolerance_ / error);
  std::optional<Ended> ended;
  for (std::size_t i = 0; i < contacts_.size(); ++i) {
    const contact::GuardForms forms = contact::guard_forms(contacts_[i].mode, contacts_[i].damper_n > 0);
    for (std::size_t k = 0; k < static_cast<std::size_t>(forms.count); ++k) {
      const auto reached = length_to_zero(contacts_[i], forms.list[k], length, end);
      if (!reached) continue;
      length = *reached;
      step(length, end);
      ended = {i, forms.list[k].next};
    }
  }
  state_ = end;
  phase_ += length;
  if (ended) contacts_[ended->contact].mode = ended->next;
}

void LongDoubleRun::advance_turn() {
  const Real turn_end = turn_rad * (std::floor(phase_ / turn_rad + Real(0.5)) + 1);
  std::vector<Real> ends{turn_end};
  for (const Pulse& pulse : pulses_) {
    for (const Real end : {pulse.start, pulse.end})
      if (end > phase_ && end < turn_end) ends.push_back(end);
  }
  std::sort(ends.begin(), ends.end());
  long steps = 0;
  for (const Real end : ends) {
    while (phase_ < end) {
      if (++steps > most_steps) throw SolverError("long double run: too many steps in one revolution");
      advance_piece(end);
    }
    phase_ = end;
  }
}

LongDoubleRun::Matrix monodromy(LongDoubleRun& run, const LongDoubleRun::State& section, int turn) {
  constexpr Real small = 2e-6L;
  const auto states = static_cast<Eigen::Index>(section.size());
  LongDoubleRun::Matrix derivative(states, states);
  const auto moved = [&](Eigen::Index which, Real by) {
    State start = section;
    start[static_cast<std::size_t>(which)] += by;
    run.restart(start, turn);
    run.advance_turn();
    return Vector(Eigen::Map<const Vector>(run.section().data(), states));
  };
  for (Eigen::Index k = 0; k < states; ++k) {
    derivative.col(k) =
        (8 * (moved(k, small) - moved(k, -small)) - (moved(k, 2 * small) - moved(k, -2 * small))) /
        (12 * small);
  }
  return derivative;
}

}  // namespace rubsweep::bench
