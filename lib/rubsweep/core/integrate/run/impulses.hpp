#pragma once

#include <Eigen/Core>
#include <limits>
#include <vector>

#include "rubsweep/core/integrate/run/state_scale.hpp"
#include "rubsweep/core/scene/scene.hpp"

namespace rubsweep::integrate::run {

/// Adds an impulse to the velocities of a state (u, u', then any further members) in the units of `scale`.
template <class State>
void add_impulse(const Eigen::VectorXd& jump_m_per_s, const StateScale& scale, State& state) {
  const auto n = static_cast<std::size_t>(jump_m_per_s.size());
  for (std::size_t j = 0; j < n; ++j)
    state[n + j] += jump_m_per_s(static_cast<Eigen::Index>(j)) / scale.unit_velocity_m_per_s();
}

/// The impulses of a scene, turn by turn. Where a whole number of impulses fits into a turn, their instants
/// repeat exactly, to the last bit.
class Impulses {
 public:
  explicit Impulses(const scene::Scene& scene);

  bool none() const { return trains_.empty(); }

  /// Lists the instants of a revolution. An impulse at phase 0 belongs to the revolution that begins.
  void begin_turn(long revolution);

  /// Phase of the next impulse, in [0, 2 pi); infinity when this revolution has no more.
  double next_phase_rad() const {
    return next_ < instants_.size() ? instants_[next_].phase_rad : std::numeric_limits<double>::infinity();
  }

  /// Velocity jump of the next impulse, an increment of q' in m/s; advances to the impulse after it.
  const Eigen::VectorXd& take() { return trains_[instants_[next_++].train].jump_m_per_s; }

 private:
  struct Train {
    Eigen::VectorXd jump_m_per_s;  ///< jump by an impulse: mass^-1 impulse
    double multiple = 0, phase_periods = 0;
  };
  /// Position of a train at the start of a revolution, in periods, and its next impulse in that revolution.
  struct TrainPosition {
    double whole = 0, rest = 0, next = 0;
  };
  struct Instant {
    double phase_rad = 0;
    std::size_t train = 0;
  };

  static TrainPosition position(const Train& train, long revolution);

  std::vector<Train> trains_;
  long elapsed_revolutions_ = 0;
  std::vector<Instant> instants_;  ///< instants of this revolution, ascending; never grows after the first
  std::size_t next_ = 0;
};

/// True when every revolution gets its impulses at the same phases.
bool same_every_turn(const scene::Scene& scene);

/// Whether the damping of a contact depends on the speed at which it began to touch. The section of a motion
/// in contact does not contain this speed.
bool remembers_impacts(const scene::Scene& scene);

}  // namespace rubsweep::integrate::run
