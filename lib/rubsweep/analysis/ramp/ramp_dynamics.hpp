#pragma once

#include <Eigen/Core>
#include <cmath>
#include <utility>
#include <vector>

#include "rubsweep/core/integrate/law/dynamics.hpp"
#include "rubsweep/core/integrate/law/own_system.hpp"
#include "rubsweep/core/structure/tabled_support.hpp"

namespace rubsweep::ramp {

/// Support whose coefficients follow the speed, in the units of the scene.
struct RampSupport {
  structure::TabledSupport support;
  Eigen::Matrix<double, Eigen::Dynamic, 2> inverse;  ///< M^-1 map^T
};

/// Terms that a speed ramp adds to the right-hand side of a scene at its reference speed. Lengths are scaled
/// by L, time by the reference speed. W is the shaft speed divided by the reference speed, phi the shaft
/// angle.
struct RampForces {
  double start_speed = 0;       ///< shaft speed / reference speed at the start
  double acceleration = 0;      ///< change of W per radian of rotation at reference speed
  Eigen::VectorXcd unbalance;   ///< M^-1 e U / L: forces Re(unbalance (W^2 - i W') e^{i phi})
  Eigen::VectorXcd bow;         ///< M^-1 b / (L reference speed^2): forces Re(bow e^{i phi}); empty: none
  Eigen::VectorXcd second;      ///< like bow, forces Re(second e^{2 i phi}); empty: none
  Eigen::MatrixXd circulatory;  ///< M^-1 C / reference speed: forces -W circulatory u; empty: none
  Eigen::MatrixXd gyroscopic;   ///< M^-1 G: forces -W gyroscopic u'; empty: none
  std::vector<RampSupport> supports;
  double reference_rad_per_s = 0;
};

/// Right-hand side, for AdaptiveRun, of a rotor whose shaft speed changes. A state holds u, u', the shaft
/// angle phi and its speed W in units of the reference speed. The speed of the rubbing surfaces follows W.
template <int N>
class RampDynamics : private integrate::law::OwnSystem<N>, public integrate::law::Dynamics<N, false> {
  using Base = integrate::law::Dynamics<N, false>;
  using OwnSystem = integrate::law::OwnSystem<N>;

 public:
  RampDynamics(const integrate::run::ScaledSystem<N>& system, double smoothing_width, RampForces forces)
      : OwnSystem(system), Base(OwnSystem::own, smoothing_width), forces_(std::move(forces)) {
    for (const auto& contact : system.contacts)
      reference_surface_m_per_s_.push_back(contact.surface_speed_m_per_s);
  }

  template <class State>
  void operator()(const State& state, State& rate, double phase) {
    loose(state, rate, phase);
    Base::hold(state, rate);
  }

  template <class State>
  void loose(const State& state, State& rate, double phase) {
    const Eigen::Index n = OwnSystem::own.coordinates();
    set_surface_speeds(state);
    Base::loose(state, rate, phase);
    const auto [angle, speed] = turning(state);
    typename Base::Map acceleration(&rate[0] + n, n);
    const double cosine = std::cos(angle), sine = std::sin(angle), change = forces_.acceleration;
    // (W^2 - i W') e^{i phi}.
    const double real = speed * speed * cosine + change * sine,
                 imaginary = speed * speed * sine - change * cosine;
    acceleration += forces_.unbalance.real() * real - forces_.unbalance.imag() * imaginary;
    if (forces_.bow.size() > 0) acceleration += forces_.bow.real() * cosine - forces_.bow.imag() * sine;
    if (forces_.second.size() > 0)
      acceleration += forces_.second.real() * (cosine * cosine - sine * sine) -
                      forces_.second.imag() * (2 * sine * cosine);
    if (forces_.gyroscopic.size() > 0) {
      const typename Base::ConstMap v(&state[0] + n, n);
      acceleration.noalias() -= speed * (forces_.gyroscopic * v);
    }
    if (forces_.circulatory.size() > 0) {
      const typename Base::ConstMap u(&state[0], n);
      acceleration.noalias() -= speed * (forces_.circulatory * u);
    }
    for (const auto& [support, inverse] : forces_.supports) {
      const double reference = forces_.reference_rad_per_s;
      const structure::SupportMatrices lacking = support.lacking(speed * reference);
      const typename Base::ConstMap u(&state[0], n), v(&state[0] + n, n);
      const Eigen::Vector2d force = lacking.stiffness * (support.map * u) / (reference * reference) +
                                    lacking.damping * (support.map * v) / reference;
      acceleration.noalias() -= inverse * force;
    }
    rate[static_cast<std::size_t>(2 * n)] = speed;
    rate[static_cast<std::size_t>(2 * n) + 1] = change;
  }

  template <class State>
  double slip_m_per_s(std::size_t i, const State& state) const {
    const double at_reference = Base::slip_m_per_s(i, state);
    const double surface = OwnSystem::own.contacts[i].surface_speed_m_per_s;
    return at_reference - surface + turning(state).second * reference_surface_m_per_s_[i];
  }

  template <class State>
  double slip(std::size_t i, const State& state) const {
    return slip_m_per_s(i, state) / OwnSystem::own.contacts[i].slip_scale_m_per_s;
  }

  /// State at the start of the ramp, with the shaft at angle 0.
  std::vector<double> whole_state(std::vector<double> section) const {
    section.push_back(0);
    section.push_back(forces_.start_speed);
    return section;
  }

 private:
  /// Angle and speed of the shaft in a state.
  template <class State>
  std::pair<double, double> turning(const State& state) const {
    const auto n = static_cast<std::size_t>(2 * OwnSystem::own.coordinates());
    return {state[n], state[n + 1]};
  }

  template <class State>
  void set_surface_speeds(const State& state) {
    const double speed = turning(state).second;
    Base::surface_growth_ = speed == 0 ? 0 : forces_.acceleration / speed;
    auto& contacts = OwnSystem::own.contacts;
    for (std::size_t i = 0; i < contacts.size(); ++i)
      contacts[i].surface_speed_m_per_s = speed * reference_surface_m_per_s_[i];
  }

  RampForces forces_;
  std::vector<double> reference_surface_m_per_s_;  ///< surface speed of each contact
};

}  // namespace rubsweep::ramp
