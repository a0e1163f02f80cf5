#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "rubsweep/core/contact/wall.hpp"
#include "rubsweep/core/integrate/run/state_scale.hpp"
#include "rubsweep/core/model/friction.hpp"
#include "rubsweep/core/scene/scene.hpp"

namespace rubsweep::integrate::run {

/// One contact in scaled units. Forces stay in newtons, so that peaks and `push` need no further scale.
/// Vectors at the contact are given in two fixed directions: normal and tangent of a flat wall, x and y in an
/// annular stop.
template <int N>
struct ScaledContact {
  /// d = (first_row u + offset[0], second_row u + offset[1])
  Eigen::Matrix<double, 1, N> first_row, second_row;
  Eigen::Matrix<double, N, 1> first_push, second_push;  ///< scaled acceleration per newton on the casing
  contact::Wall wall;              ///< shape of the wall; displacements count from `offset`
  std::array<double, 2> offset{};  ///< offset of the wall in the two directions
  double clearance = 0;
  double stiffness = 0;  ///< N per scaled penetration
  double damping = 0;    ///< N per scaled closing speed
  model::Friction friction;
  double slip_scale_m_per_s = 0;  ///< slip = slip_scale * (d' . tangent) + surface speed
  double surface_speed_m_per_s = 0;
  /// Law of a non-linear contact, for which `stiffness` is a secant and `damping` 0; otherwise null.
  std::shared_ptr<const contact::CurvedLaw> law;
  double length_m = 0;  ///< L, the length unit of penetrations

  /// Scaled relative acceleration of rotor and casing along the first direction, per newton between them.
  double mobility() const { return -first_row.dot(first_push.transpose()); }
};

/// A half-sine pulse as part of the acceleration: top sin(rate * time since its start) while it acts.
template <int N>
struct ScaledPulse {
  Eigen::Matrix<double, N, 1> top;
  double rate = 0;  ///< angle of the half-sine per radian of rotation
  /// Not empty: a part of the second harmonic, which always acts. The value is the time from its start to the
  /// start of every revolution.
  std::optional<double> always_elapsed{};
};

/// The casing of a contact. Only the contact and the casing's mount act on it, so that with an open contact
/// it vibrates as an oscillator whose energy never grows.
template <int N>
struct ScaledCasing {
  std::size_t contact = 0;
  Eigen::Matrix<double, 2, N> map;  ///< (x, y) in units of L
  Eigen::Vector2d sag;              ///< position under constant forces
  double rate = 0;                  ///< undamped angular frequency

  /// Upper bound of all later displacements while the contact is open, from the energy of the vibration.
  template <class State>
  double reach(const State& state) const {
    const Eigen::Index n = state.size() / 2;
    const Eigen::Vector2d z = map * state.head(n) - sag, v = map * state.tail(n) / rate;
    return sag.norm() + std::sqrt(z.squaredNorm() + v.squaredNorm());
  }
};

/// A scene in the units of a StateScale. The scale of its sections makes every tolerance a pure number:
/// length in L = scene.length_scale_m, time in radians of shaft rotation. After division by the mass matrix,
/// the equations of motion are
///
///     u'' = -stiffness u - damping u' + cosine cos(phase) + sine sin(phase) + constant + pulses + contacts.
///
/// N coordinates, or Eigen::Dynamic.
template <int N>
struct ScaledSystem {
  using Vector = Eigen::Matrix<double, N, 1>;
  using Matrix = Eigen::Matrix<double, N, N>;

  bool diagonal = false;  ///< true: stiffness and damping are diagonal; the diagonals suffice
  Vector stiffness_diagonal, damping_diagonal;
  Matrix stiffness, damping;
  Vector cosine, sine, constant;
  /// Pulses of the scene, then the parts of its second harmonic; PulseTimes knows when they act.
  std::vector<ScaledPulse<N>> pulses;
  Eigen::Matrix<double, 2, N> observed;  ///< (x, y) of the observed point in units of L
  std::vector<ScaledContact<N>> contacts;
  std::vector<ScaledCasing<N>> casings;  ///< the moving casings
  StateScale scale;

  Eigen::Index coordinates() const { return stiffness_diagonal.size(); }
};

/// The scene in scaled units, divided by its mass matrix. Throws SolverError if it has not N coordinates.
template <int N>
ScaledSystem<N> scale(const scene::Scene& scene, const StateScale& scale);

/// Converts a scene to the scale of its sections.
template <int N>
ScaledSystem<N> scale(const scene::Scene& scene) {
  return scale<N>(scene, state_scale(scene));
}

extern template ScaledSystem<2> scale<2>(const scene::Scene&, const StateScale&);
extern template ScaledSystem<4> scale<4>(const scene::Scene&, const StateScale&);
extern template ScaledSystem<6> scale<6>(const scene::Scene&, const StateScale&);
extern template ScaledSystem<Eigen::Dynamic> scale<Eigen::Dynamic>(const scene::Scene&, const StateScale&);

}  // namespace rubsweep::integrate::run
