#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "rubsweep/core/contact/force_law.hpp"
#include "rubsweep/core/integrate/run/options.hpp"
#include "rubsweep/core/integrate/run/scaled_system.hpp"
#include "rubsweep/core/integrate/run/turn.hpp"
#include "rubsweep/core/scene/scene.hpp"

namespace rubsweep::trace {

/// Friction of the contacts whose friction is dry, at one instant of a run. A contact that slips has mu S;
/// the holding friction of one that sticks is no function of its own motion: it is the force that keeps the
/// slip zero against all that acts on the structure at that instant, within mu S.
class DryForces {
 public:
  explicit DryForces(const scene::Scene& scene);

  /// Whether some contact has dry friction. Without one nobody has to ask.
  bool any() const { return any_; }

  /// Newtons along the tangent on the casing, one number per contact, 0 where it is open or its friction is
  /// of another kind. `scaled`: a state as integrate::run::TurnReport holds it; `turns`: of the shaft since t
  /// = 0.
  std::vector<double> forces_n(const scene::Scene& scene, std::span<const double> scaled, double turns) const;

 private:
  integrate::run::ScaledSystem<Eigen::Dynamic> system_;
  bool any_ = false;
};

/// Energy of a vibration at one instant, and the power of all that changes it: between two instants without
/// an impulse, kinetic + elastic + contact grows by the integral of the four powers. It is the energy of the
/// coordinates, which does not count the rotation of the shaft: friction gives the vibration what the drive
/// puts in beyond what the slip turns into heat.
struct Energy {
  double kinetic_j = 0;          ///< v M v / 2
  double elastic_j = 0;          ///< q K q / 2 of rotor, supports and casings; weight is a force
  double contact_j = 0;          ///< in the springs of the contacts
  double forcing_w = 0;          ///< of unbalance, bow, weight and kick
  double damping_w = 0;          ///< of the structure, and of stiffness that is not symmetric
  double contact_damping_w = 0;  ///< of the contacts' dampers, <= 0
  double friction_w = 0;         ///< of friction on the coordinates: - friction times sliding speed
};

/// Energy of a structure without its contacts at displacements `q_m` and velocities, when the shaft has made
/// `turns` turns since t = 0. A scene with torsion has forces that go by the angle of the rotor: NaN.
Energy structure_energy(const scene::Scene& scene, const Eigen::VectorXd& q_m,
                        const Eigen::VectorXd& rate_m_per_s, double turns);

/// Energy in the spring of a contact: the integral over the penetration of the spring force of
/// contact::elastogap or, `smoothing_m` > 0, contact::smoothed_elastogap.
double spring_energy_j(double stiffness_n_per_m, double penetration_m, double smoothing_m);

/// State of one stop at one instant. Forces are those on the casing.
struct StopState {
  Eigen::Vector2d casing_m{0, 0};  ///< displacement of the casing; 0 where it is rigid
  Eigen::Vector2d casing_m_per_s{0, 0};
  double gap_m = 0;             ///< distance still open between rotor and wall; < 0: penetration
  double normal_force_n = 0;    ///< along the normal from the rotor to the wall, >= 0
  double friction_force_n = 0;  ///< along the tangent (-n_y, n_x); also what holds a contact that sticks
};

/// Traced quantities of one state of a run.
struct TraceState {
  Eigen::Vector2d displacement_m{0, 0};  ///< of the observed point, the rotor
  Eigen::Vector2d velocity_m_per_s{0, 0};
  std::vector<StopState> stops;
  Eigen::VectorXd coordinates_m, rates_m_per_s;  ///< of the whole structure: q and q'
  Energy energy;
  double twist_rad = 0;  ///< angle by which the rotor is ahead of its drive; 0 without torsion
  double torque_nm = 0;  ///< of the rotor on its drive
};

/// Reads states of a run of `scene`, scaled as integrate::run::TurnReport holds them (q then q', 2n numbers),
/// back to SI. Contact forces are those of the law that a run with these options integrates. The scene must
/// outlive the reader.
class StateReader {
 public:
  StateReader(const scene::Scene& scene, const integrate::run::SolverOptions& options);

  /// Numbers per state, 2n.
  std::size_t size() const { return 2 * static_cast<std::size_t>(scene_.structure.coordinates()); }
  std::size_t stops() const { return scene_.contacts.size(); }

  /// `turns`: of the shaft since t = 0, for the forces that turn with it and the kick. Throws SolverError
  /// when `scaled` has another size.
  TraceState read(std::span<const double> scaled, double turns) const;
  /// Positions and velocities, without forces and energies, which take longer.
  TraceState read_motion(std::span<const double> scaled) const;
  /// Takes a change of contact mode into account that comes before the next state to be read: a curved law
  /// may be damped by how fast its contact began.
  void pass(const integrate::run::ModeSwitch& change);

 private:
  /// Motion of one stop as it is seen from its wall.
  struct StopMotion {
    double penetration_m = 0, closing_speed_m_per_s = 0, sliding_speed_m_per_s = 0;
  };

  StopMotion stop_motion(std::size_t index, const TraceState& state) const;
  /// Adds the forces of a stop and their powers. `dry_n`: its friction where that is dry.
  void add_forces(std::size_t index, double dry_n, TraceState& state) const;
  contact::NormalForce normal_force(std::size_t index, const StopMotion& motion) const;
  double friction_n(const scene::Contact& contact, double slip_m_per_s, double spring_n, double dry_n) const;

  const scene::Scene& scene_;
  double smoothing_m_;  ///< width of the blended law; 0: the law with its corners
  DryForces dry_forces_;
  std::vector<double> impact_damping_;                              ///< per stop, scaled
  std::vector<Eigen::Matrix<double, 2, Eigen::Dynamic>> relative_;  ///< per stop: rotor minus casing
};

}  // namespace rubsweep::trace
