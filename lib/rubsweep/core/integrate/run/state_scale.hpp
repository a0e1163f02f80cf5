#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "rubsweep/core/scene/scene.hpp"

namespace rubsweep::integrate::run {

/// Units of the state of a run. A state is (u, u'): displacements q = length_m u, and velocities with time in
/// radians of a rotation at `speed_rad_per_s`; at 1 rad/s this is time in seconds. All conversions between SI
/// and such states are made here in the same order of operations, so that they always agree bit by bit.
struct StateScale {
  double length_m = 0;         ///< > 0
  double speed_rad_per_s = 0;  ///< > 0

  double unit_velocity_m_per_s() const { return length_m * speed_rad_per_s; }
  double unit_acceleration_m_per_s2() const { return length_m * speed_rad_per_s * speed_rad_per_s; }
  /// Newtons per unit of scaled displacement, and per unit of scaled velocity.
  double stiffness_n(double stiffness_n_per_m) const { return stiffness_n_per_m * length_m; }
  double damping_n(double damping_ns_per_m) const { return damping_ns_per_m * length_m * speed_rad_per_s; }
  /// Duration in radians of rotation, or in seconds if the scale has seconds.
  double duration(double duration_s) const { return duration_s * speed_rad_per_s; }

  /// Converts SI values to a state of 2n numbers, and back.
  std::vector<double> state(const Eigen::VectorXd& displacement_m,
                            const Eigen::VectorXd& velocity_m_per_s) const;
  Eigen::VectorXd displacement_m(std::span<const double> state) const;
  Eigen::VectorXd velocity_m_per_s(std::span<const double> state) const;

  /// The same length unit with time in seconds: the states of the exact solver.
  StateScale in_seconds() const { return {length_m, 1}; }
  /// Converts a state of this scale (any Eigen vector) in place to `in_seconds()`, and back.
  template <class State>
  void to_seconds(State&& state) const {
    state.tail(state.size() / 2) *= speed_rad_per_s;
  }
  template <class State>
  void from_seconds(State&& state) const {
    state.tail(state.size() / 2) /= speed_rad_per_s;
  }

  /// State of `in_seconds()` from a section of this scale.
  template <class State>
  State state_in_seconds(std::span<const double> section) const {
    State state =
        Eigen::Map<const Eigen::VectorXd>(section.data(), static_cast<Eigen::Index>(section.size()));
    to_seconds(state);
    return state;
  }
  /// Section of this scale from a state of `in_seconds()`. Allocates nothing once `section` is large enough.
  template <class State>
  void put_section(const State& state, std::vector<double>& section) const {
    section.assign(state.data(), state.data() + state.size());
    from_seconds(Eigen::Map<Eigen::VectorXd>(section.data(), state.size()));
  }
};

/// Scale of the sections of a scene: its length scale, and radians of its shaft's rotation.
StateScale state_scale(const scene::Scene& scene);

/// Start of the scene as a section in this scale.
std::vector<double> scaled_initial_state(const scene::Scene& scene);

/// Sets the start of the scene to `section`, 2n numbers in the scale of state_scale().
void set_initial_state(scene::Scene& scene, std::span<const double> section);

/// The scene at the start of revolution `revolution`, with `section` as its initial state.
scene::Scene scene_at(scene::Scene scene, std::span<const double> section, long revolution);

}  // namespace rubsweep::integrate::run
