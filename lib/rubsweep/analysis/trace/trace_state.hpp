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

/// Friction forces of contacts with dry friction, at one instant of a run. A contact that slips has the force
/// mu S. The friction of a contact that sticks cannot be computed from its own motion. It is the force within
/// mu S that keeps the slip zero against all forces on the structure at this instant.
class DryForces {
 public:
  explicit DryForces(const scene::Scene& scene);

  /// Whether some contact has dry friction. If not, forces_n need not be called.
  bool any() const { return any_; }

  /// Friction in N along the tangent on the casing, one number per contact; 0 where the contact is open or
  /// its friction is not dry. `scaled`: a state as in integrate::run::TurnReport. `turns`: turns of the shaft
  /// since t = 0.
  std::vector<double> forces_n(const scene::Scene& scene, std::span<const double> scaled, double turns) const;

 private:
  integrate::run::ScaledSystem<Eigen::Dynamic> system_;
  bool any_ = false;
};

/// Energy of a vibration at one instant, and the power of everything that changes it. Between two instants
/// without an impulse, the sum kinetic + elastic + contact grows by the integral of the four powers. The
/// rotation of the shaft is not included, so the friction power is the power of the drive minus the heat at
/// the sliding surfaces.
struct Energy {
  double kinetic_j = 0;  ///< v M v / 2
  /// q K q / 2 of rotor, supports and casings; the weight is one of the forces
  double elastic_j = 0;
  double contact_j = 0;          ///< energy in the springs of the contacts
  double forcing_w = 0;          ///< power of unbalance, bow, weight and kick
  double damping_w = 0;          ///< power of the structure's damping, and of asymmetric stiffness
  double contact_damping_w = 0;  ///< power of the contacts' dampers, <= 0
  double friction_w = 0;         ///< power of friction on the coordinates: - friction times sliding speed
};

/// Energy of a structure without its contacts, with displacements `q_m` and velocities `rate_m_per_s`, after
/// `turns` turns of the shaft since t = 0. NaN for a scene with torsion, whose forces depend on the angle of
/// the rotor.
Energy structure_energy(const scene::Scene& scene, const Eigen::VectorXd& q_m,
                        const Eigen::VectorXd& rate_m_per_s, double turns);

/// Energy in the spring of a contact: the integral over the penetration of the spring force of
/// contact::elastogap, or of contact::smoothed_elastogap if `smoothing_m` > 0.
double spring_energy_j(double stiffness_n_per_m, double penetration_m, double smoothing_m);

/// State of one stop at one instant. Forces are those on the casing.
struct StopState {
  Eigen::Vector2d casing_m{0, 0};  ///< displacement of the casing; 0 where it is rigid
  Eigen::Vector2d casing_m_per_s{0, 0};
  double gap_m = 0;             ///< distance between rotor and wall; < 0: penetration
  double normal_force_n = 0;    ///< along the normal from the rotor to the wall, >= 0
  double friction_force_n = 0;  ///< along the tangent (-n_y, n_x); includes the holding force while sticking
};

/// Traced quantities of one state of a run.
struct TraceState {
  Eigen::Vector2d displacement_m{0, 0};  ///< displacement of the observed point, the rotor
  Eigen::Vector2d velocity_m_per_s{0, 0};
  std::vector<StopState> stops;
  Eigen::VectorXd coordinates_m, rates_m_per_s;  ///< q and q' of the whole structure
  Energy energy;
  double twist_rad = 0;  ///< angle by which the rotor is ahead of its drive; 0 without torsion
  double torque_nm = 0;  ///< torque of the rotor on its drive
};

/// Converts states of a run of `scene`, scaled as in integrate::run::TurnReport (q then q', 2n numbers), to
/// SI. Contact forces are those of the law that a run with these options integrates. The scene must outlive
/// the reader.
class StateReader {
 public:
  StateReader(const scene::Scene& scene, const integrate::run::SolverOptions& options);

  /// Count of numbers in a state, 2n.
  std::size_t size() const { return 2 * static_cast<std::size_t>(scene_.structure.coordinates()); }
  std::size_t stops() const { return scene_.contacts.size(); }

  /// Reads a state with forces and energies. `turns`: turns of the shaft since t = 0, from which rotating
  /// forces and the kick follow. Throws SolverError where `scaled` has another size.
  TraceState read(std::span<const double> scaled, double turns) const;
  /// Reads only positions and velocities, which is faster than forces and energies.
  TraceState read_motion(std::span<const double> scaled) const;
  /// Takes note of a change of contact mode before the next state is read: the damping of a curved law may
  /// depend on the speed at which contact began.
  void pass(const integrate::run::ModeSwitch& change);

 private:
  /// Motion of the rotor at one stop, seen from the wall.
  struct StopMotion {
    double penetration_m = 0, closing_speed_m_per_s = 0, sliding_speed_m_per_s = 0;
  };

  StopMotion stop_motion(std::size_t index, const TraceState& state) const;
  /// Adds the forces of a stop and their powers. `dry_n`: friction force, used where friction is dry.
  void add_forces(std::size_t index, double dry_n, TraceState& state) const;
  contact::NormalForce normal_force(std::size_t index, const StopMotion& motion) const;
  double friction_n(const scene::Contact& contact, double slip_m_per_s, double spring_n, double dry_n) const;

  const scene::Scene& scene_;
  double smoothing_m_;  ///< width of the smoothed law; 0: law with corners
  DryForces dry_forces_;
  std::vector<double> impact_damping_;                              ///< damping of each stop, scaled
  std::vector<Eigen::Matrix<double, 2, Eigen::Dynamic>> relative_;  ///< map of each stop: rotor minus casing
};

}  // namespace rubsweep::trace
