#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "rubsweep/model/friction.hpp"
#include "rubsweep/scene/scene.hpp"

namespace rubsweep::integrate {

/// One contact in scaled units. Forces stay in newtons, so that peaks and `push` need no second scale.
template <int N>
struct ScaledContact {
  Eigen::Matrix<double, 1, N> normal_row;    ///< p = normal_row u - clearance
  Eigen::Matrix<double, 1, N> tangent_row;   ///< slip = slip_scale * tangent_row u' + surface speed
  Eigen::Matrix<double, N, 1> normal_push;   ///< scaled acceleration per newton on the casing along the normal
  Eigen::Matrix<double, N, 1> tangent_push;  ///< the same along the tangent
  double clearance = 0;
  double stiffness = 0;  ///< N per scaled penetration
  double damping = 0;    ///< N per scaled closing speed
  model::Friction friction;
  double slip_scale_m_per_s = 0;
  double surface_speed_m_per_s = 0;
};

/// A scene in the units that make every tolerance a pure number: length in L = scene.length_scale_m, time in radians
/// of shaft rotation. u'' = -stiffness u - damping u' + cosine cos(phase) + sine sin(phase) + constant + pulse
/// + contacts, with the mass matrix already divided out. N coordinates, or Eigen::Dynamic.
template <int N>
struct ScaledSystem {
  using Vector = Eigen::Matrix<double, N, 1>;
  using Matrix = Eigen::Matrix<double, N, N>;

  bool diagonal = false;  ///< stiffness and damping are diagonal: the diagonals below suffice
  Vector stiffness_diagonal, damping_diagonal;
  Matrix stiffness, damping;
  Vector cosine, sine, constant;
  Vector pulse;                ///< acceleration at the top of the half-sine
  double pulse_rate = 0;       ///< phase of the half-sine per radian of rotation
  double pulse_end_rad = 0;    ///< 0: no pulse
  Eigen::Matrix<double, 2, N> observed;  ///< (x, y) of the observed point in units of L
  std::vector<ScaledContact<N>> contacts;
  double length_m = 0;
  double speed_rad_per_s = 0;

  Eigen::Index coordinates() const { return stiffness_diagonal.size(); }
};

/// Divides out mass and units. Throws SolverError when the scene's coordinates are not N.
template <int N>
ScaledSystem<N> scale(const scene::Scene& scene);

/// Initial state of the scene, scaled: u then u', 2n numbers.
std::vector<double> scaled_initial_state(const scene::Scene& scene);

extern template ScaledSystem<2> scale<2>(const scene::Scene&);
extern template ScaledSystem<4> scale<4>(const scene::Scene&);
extern template ScaledSystem<6> scale<6>(const scene::Scene&);
extern template ScaledSystem<Eigen::Dynamic> scale<Eigen::Dynamic>(const scene::Scene&);

}  // namespace rubsweep::integrate
