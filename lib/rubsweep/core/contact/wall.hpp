#pragma once

#include <Eigen/Core>
#include <cmath>
#include <variant>

#include "rubsweep/core/contact/contact_mode.hpp"
#include "rubsweep/core/model/stop.hpp"
#include "rubsweep/core/overloaded.hpp"

namespace rubsweep::contact {

/// Displacement d and velocity v of the rotor relative to the casing at one contact, scaled, in the contact's
/// two fixed directions: normal and tangent of a flat wall, x and y in an annular stop.
struct RelativeMotion {
  double d1 = 0, d2 = 0;
  double v1 = 0, v2 = 0;
};

/// Contact frame relative to the wall, with the normal n = (cosine, sine) in the fixed directions and the
/// tangent t = (-sine, cosine).
struct ContactFrame {
  double cosine = 1, sine = 0;
  /// 1 / |d|: how fast the normal turns with a tangential displacement; 0 for a flat wall.
  double curvature = 0;
  double penetration = 0;
  double closing_speed = 0;
  double sliding_speed = 0;  ///< d' . t, along the tangent
};

inline ContactFrame flat_frame(const RelativeMotion& m, double clearance) {
  return {1, 0, 0, m.d1 - clearance, m.v1, m.v2};
}

/// At the very centre of an annular stop, where no normal exists, the first fixed direction is used; nothing
/// touches there.
inline ContactFrame annular_frame(const RelativeMotion& m, double clearance) {
  const double distance = std::sqrt(m.d1 * m.d1 + m.d2 * m.d2);
  if (distance == 0) return {1, 0, 0, -clearance, m.v1, m.v2};
  const double cosine = m.d1 / distance, sine = m.d2 / distance;
  return {cosine,
          sine,
          1 / distance,
          distance - clearance,
          cosine * m.v1 + sine * m.v2,
          cosine * m.v2 - sine * m.v1};
}

/// A flat wall, whose normal does not turn: a unit vector from the rest position towards the wall.
struct FlatWall {
  Eigen::Vector2d normal{0, 1};
};

/// A round hole around the rotor. `offset` leads from its centre to the rotor's rest position, in the unit of
/// the displacements.
struct AnnularWall {
  Eigen::Vector2d offset{0, 0};
};

/// The shape of a stop. d = rotor point - casing point + offset. The penetration is d . n - clearance, with
/// the normal n = FlatWall::normal, or d / |d| in an annular stop. The tangent is t = (-n_y, n_x).
using Wall = std::variant<FlatWall, AnnularWall>;

/// Unit vector at an angle from +x towards +y. Exact at multiples of 90 degrees, where rounding would couple
/// x into y.
Eigen::Vector2d direction(double angle_deg);

/// Wall of a geometry in a configuration, in metres.
Wall wall_of(const model::StopGeometry& geometry);

/// The wall with its lengths divided by `unit`.
Wall in_units(const Wall& wall, double unit);

bool same(const Wall& a, const Wall& b);

/// Whether the penetration is linear in the displacements, so that the exact solver has closed forms for it.
constexpr bool linear(const Wall& wall) { return std::holds_alternative<FlatWall>(wall); }

/// Whether the normal turns about the centre of a round hole, for which the Taylor solver expands |d|.
constexpr bool annular(const Wall& wall) {
  return std::visit(
      overloaded{[](const FlatWall&) { return false; }, [](const AnnularWall&) { return true; }}, wall);
}

/// Whether the wall is the same in all directions from the rotor's rest position.
bool centred(const Wall& wall);

/// Vector from the centre of an annular stop to the rotor's rest position; zero for a flat wall.
Eigen::Vector2d offset(const Wall& wall);

/// First of the two fixed directions in which vectors at the contact are given: the normal of a flat wall, or
/// x. The second direction is a quarter turn ahead of it.
Eigen::Vector2d first_direction(const Wall& wall);

/// Unit vector from the rotor towards the wall where the relative displacement is d = `distance`. At the
/// centre of an annular stop, where it is undefined and nothing touches, +y.
Eigen::Vector2d normal_at(const Wall& wall, const Eigen::Vector2d& distance);

/// Geometry of a wall for drawing it, seen from the rotor's rest position.
struct Outline {
  bool around = false;           ///< true: a circle around the rotor; false: a line
  Eigen::Vector2d normal{0, 1};  ///< normal of a line: from the rest position towards it
  Eigen::Vector2d centre{0, 0};  ///< centre of a circle
};
Outline outline(const Wall& wall);

/// Map from the displacements q to rotor point minus casing point.
using RelativeMap = Eigen::Matrix<double, 2, Eigen::Dynamic>;

/// Rows on q that give the components of the rotor's motion towards the wall, which bound its excursion.
Eigen::MatrixXd rows_against(const Wall& wall, const RelativeMap& relative);

/// Penetration under the motion q = mean + Re(amplitude e^{i phase}): at the mean position, and its largest
/// rise above this value. In an annular stop the excursion counts as if it pointed outwards at the mean
/// position. If the whirl is a circle, it does so at some time.
struct Excursion {
  double mean = 0;       ///< < 0: a gap
  double amplitude = 0;  ///< >= 0
};
Excursion excursion(const Wall& wall, double clearance, const RelativeMap& relative,
                    const Eigen::VectorXd& mean, const Eigen::VectorXcd& amplitude);

/// Smallest share s > 0 of the displacement `way` at which a rotor that leaves its rest position meets the
/// wall; infinity where it never meets the wall.
double share_of_way_to(const Wall& wall, double clearance, const Eigen::Vector2d& way);

/// Contact frame of a relative motion, by the shape of the wall.
inline ContactFrame frame(const Wall& wall, const RelativeMotion& motion, double clearance) {
  return std::visit(overloaded{[&](const FlatWall&) { return flat_frame(motion, clearance); },
                               [&](const AnnularWall&) { return annular_frame(motion, clearance); }},
                    wall);
}

/// Penetration and its two rates, with the second derivatives `a1` and `a2` of d in the fixed directions.
inline Kinematics kinematics(const Wall& wall, const RelativeMotion& m, double a1, double a2,
                             double clearance) {
  return std::visit(
      overloaded{[&](const FlatWall&) -> Kinematics {
                   return {m.d1 - clearance, m.v1, a1};
                 },
                 [&](const AnnularWall&) -> Kinematics {
                   const ContactFrame f = annular_frame(m, clearance);
                   return {f.penetration, f.closing_speed,
                           f.cosine * a1 + f.sine * a2 + f.sliding_speed * f.sliding_speed * f.curvature};
                 }},
      wall);
}

/// Penetration and its two rates for an open contact. In an annular stop (|d|^2 - C^2) / (2 C) replaces the
/// penetration: it crosses zero together with |d| - C and is smooth at the centre.
inline Kinematics open_kinematics(const Wall& wall, const RelativeMotion& m, double a1, double a2,
                                  double clearance) {
  return std::visit(overloaded{[&](const FlatWall&) -> Kinematics {
                                 return {m.d1 - clearance, m.v1, a1};
                               },
                               [&](const AnnularWall&) -> Kinematics {
                                 return {
                                     (m.d1 * m.d1 + m.d2 * m.d2 - clearance * clearance) / (2 * clearance),
                                     (m.d1 * m.v1 + m.d2 * m.v2) / clearance,
                                     (m.v1 * m.v1 + m.v2 * m.v2 + m.d1 * a1 + m.d2 * a2) / clearance};
                               }},
                    wall);
}

}  // namespace rubsweep::contact
