#include "rubsweep/analysis/linear/linear_run.hpp"

#include <algorithm>
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

#include "rubsweep/core/error.hpp"
#include "rubsweep/core/numerics/dense/factors.hpp"
#include "rubsweep/core/scene/build_scene.hpp"
#include "rubsweep/core/scene/constant_load.hpp"
#include "rubsweep/core/structure/assembly.hpp"

namespace rubsweep::linear {
namespace {

namespace odeint = boost::numeric::odeint;
using std::numbers::pi;
using State = std::vector<double>;

/// Smallest step, as a share of a sample. With smaller steps the run would take too long.
constexpr double shortest_step = 1e-6;
constexpr double relative_tolerance = 1e-10;

/// Factor of all rotating forces: -i if they act a quarter turn later, otherwise 1.
std::complex<double> turned_back(const LinearRun& run) {
  return run.driven == Driven::quarter_behind ? std::complex<double>(0, -1) : 1;
}

/// Whether forces at twice the shaft's frequency act. They do not contribute to the phasor of 1X.
bool feels_second(const scene::PreparedMachine& prepared, const LinearRun& run) {
  return run.driven == Driven::by_all && prepared.assembly.second_n.size() > 0;
}

class Structure {
 public:
  Structure(const scene::PreparedMachine& prepared, const LinearRun& run, const Eigen::VectorXd& constant_n)
      : run_(run), mass_(prepared.assembly.system.mass) {
    const auto& system = prepared.assembly.system;
    stiffness_ = mass_.solve(system.stiffness);
    damping_ = mass_.solve(system.damping);
    gyroscopic_ = prepared.assembly.gyroscopic.size() > 0
                      ? Eigen::MatrixXd(mass_.solve(prepared.assembly.gyroscopic))
                      : Eigen::MatrixXd::Zero(damping_.rows(), damping_.cols());
    circulatory_ = prepared.assembly.circulatory.size() > 0
                       ? Eigen::MatrixXd(mass_.solve(prepared.assembly.circulatory))
                       : Eigen::MatrixXd::Zero(damping_.rows(), damping_.cols());
    unbalance_ = turned_back(run) * run.eccentricity_m * solve(system.unbalance_kg);
    bow_ = prepared.assembly.bow_n.size() > 0
               ? Eigen::VectorXcd(turned_back(run) * solve(prepared.assembly.bow_n))
               : Eigen::VectorXcd(Eigen::VectorXcd::Zero(unbalance_.size()));
    if (feels_second(prepared, run)) second_ = solve(prepared.assembly.second_n);
    constant_ = mass_.solve(constant_n);
  }

  /// Adds a support whose coefficients follow the speed.
  void add(const structure::TabledSupport& support) {
    tables_.push_back({support, mass_.solve(Eigen::MatrixXd(support.map.transpose()))});
  }

  void add(const scene::Pulse& pulse) {
    pulses_.push_back({mass_.solve(pulse.direction) * pulse.force_n, pulse.duration_s, pulse.elapsed_s});
  }

  void operator()(const State& state, State& rate, double t) const {
    const Eigen::Index n = constant_.size();
    const Eigen::Map<const Eigen::VectorXd> q(state.data(), n), v(state.data() + n, n);
    Eigen::Map<Eigen::VectorXd> velocity(rate.data(), n), acceleration(rate.data() + n, n);
    velocity = v;
    const double speed = 2 * pi * shaft_speed_hz(run_, t), gain = 2 * pi * run_.rate_hz_per_s;
    const std::complex<double> turn = std::polar(1.0, shaft_angle_rad(run_, t));
    const std::complex<double> centrifugal = std::complex<double>(speed * speed, -gain) * turn;
    acceleration = constant_ + (unbalance_ * centrifugal + bow_ * turn).real();
    if (second_.size() > 0) acceleration += (second_ * (turn * turn)).real();
    acceleration.noalias() -= stiffness_ * q;
    acceleration.noalias() -= damping_ * v;
    acceleration.noalias() -= speed * (gyroscopic_ * v);
    acceleration.noalias() -= speed * (circulatory_ * q);
    for (const auto& [support, inverse] : tables_) {
      const structure::SupportMatrices lacking = support.lacking(speed);
      const Eigen::Vector2d force =
          lacking.stiffness * (support.map * q) + lacking.damping * (support.map * v);
      acceleration.noalias() -= inverse * force;
    }
    for (const Pulse& pulse : pulses_) {
      const double since_s = t + pulse.elapsed_s;
      if (since_s >= 0 && since_s < pulse.duration_s)
        acceleration += pulse.top_m_per_s2 * std::sin(pi * since_s / pulse.duration_s);
    }
  }

 private:
  struct Pulse {
    Eigen::VectorXd top_m_per_s2;
    double duration_s = 0, elapsed_s = 0;
  };

  struct Tabled {
    structure::TabledSupport support;
    Eigen::Matrix<double, Eigen::Dynamic, 2> inverse;  ///< M^-1 map^T
  };

  Eigen::VectorXcd solve(const Eigen::VectorXcd& force) const {
    const Eigen::VectorXd real = mass_.solve(Eigen::VectorXd(force.real()));
    const Eigen::VectorXd imaginary = mass_.solve(Eigen::VectorXd(force.imag()));
    return real.cast<std::complex<double>>() +
           std::complex<double>(0, 1) * imaginary.cast<std::complex<double>>();
  }

  LinearRun run_;
  numerics::dense::SymmetricFactors mass_;
  Eigen::MatrixXd stiffness_, damping_, gyroscopic_, circulatory_;
  Eigen::VectorXcd unbalance_, bow_;
  Eigen::VectorXcd second_;  ///< forces at twice the shaft's frequency; empty: none
  Eigen::VectorXd constant_;
  std::vector<Pulse> pulses_;
  std::vector<Tabled> tables_;
};

/// Initial state: the quiet motion of the first speed, with the unbalance at angle 0. At standstill it is the
/// static deflection; for a machine that starts at rest, the unloaded position.
State initial_state(const scene::PreparedMachine& prepared, const LinearRun& run,
                    const Eigen::VectorXd& constant_n) {
  const double w = 2 * pi * run.from_hz;
  const structure::LinearSystem system = structure::system_at(prepared.assembly, w);
  if (model::begins_at_rest(prepared.machine.start)) {
    State state(static_cast<std::size_t>(2 * system.coordinates()));
    if (run.driven == Driven::by_all)
      std::ranges::copy(scene::unloaded_position_m(prepared, system), state.begin());
    return state;
  }
  Eigen::VectorXcd force = turned_back(run) * run.eccentricity_m * w * w * system.unbalance_kg;
  if (prepared.assembly.bow_n.size() > 0) force += turned_back(run) * prepared.assembly.bow_n;
  const scene::QuietMotion quiet =
      scene::quiet_motion(system, w, force, constant_n,
                          feels_second(prepared, run) ? prepared.assembly.second_n : Eigen::VectorXcd());
  const Eigen::VectorXd q = quiet.displacement(0), v = w * quiet.velocity(0);
  State state(q.begin(), q.end());
  state.insert(state.end(), v.begin(), v.end());
  return state;
}

/// Impulses at given shaft angles on a ramp. integrate::run has impulses for a constant speed only, because
/// their times must repeat exactly from turn to turn.
class ImpulsesOnARamp {
 public:
  ImpulsesOnARamp(const scene::PreparedMachine& prepared, const LinearRun& run) : run_(run) {
    const numerics::dense::SymmetricFactors mass(prepared.assembly.system.mass);
    if (run.driven != Driven::by_all) return;
    for (const auto& train : prepared.assembly.impulses)
      trains_.push_back({mass.solve(train.impulse_ns), train.multiple, train.phase_periods});
  }

  double next_s() const {
    double next = std::numeric_limits<double>::infinity();
    for (const Train& train : trains_) next = std::min(next, instant_s(train));
    return next;
  }

  /// Adds the impulses that are due up to `t_s` to the velocities; returns whether there were any.
  bool apply(double t_s, State& state) {
    bool any = false;
    for (Train& train : trains_) {
      for (; instant_s(train) <= t_s; ++train.count) {
        const Eigen::Index n = train.jump_m_per_s.size();
        Eigen::Map<Eigen::VectorXd>(state.data() + n, n) += train.jump_m_per_s;
        any = true;
      }
    }
    return any;
  }

 private:
  struct Train {
    Eigen::VectorXd jump_m_per_s;
    double multiple = 0, phase_periods = 0, count = 0;
  };

  /// Time of the next impulse of a train: the shaft has then made from t + rate t^2 / 2 turns. Infinite on a
  /// ramp that stops earlier.
  double instant_s(const Train& train) const {
    const double turns = (train.count + train.phase_periods) / train.multiple;
    const double square = run_.from_hz * run_.from_hz + 2 * run_.rate_hz_per_s * turns;
    const double sum = square < 0 ? 0 : run_.from_hz + std::sqrt(square);
    return sum > 0 ? 2 * turns / sum : std::numeric_limits<double>::infinity();
  }

  LinearRun run_;
  std::vector<Train> trains_;
};

/// A speed at which the machine can be built.
double pulse_speed_hz(const scene::PreparedMachine& prepared) {
  const model::RotorKit* kit = model::kit_of(prepared.machine);
  return kit != nullptr && model::has_tables(*kit) ? model::table_speeds_hz(*kit).high : 1;
}

}  // namespace

double shaft_angle_rad(const LinearRun& run, double t_s) {
  return 2 * pi * (run.from_hz * t_s + run.rate_hz_per_s * t_s * t_s / 2);
}

double shaft_speed_hz(const LinearRun& run, double t_s) { return run.from_hz + run.rate_hz_per_s * t_s; }

SensorRows sensor_rows(const scene::PreparedMachine& prepared) {
  const auto& points = prepared.assembly.system.points;
  SensorRows sensors;
  std::vector<int> which = prepared.assembly.sensor_points;
  if (which.empty()) {
    which.assign(2, prepared.assembly.observed_point);
    sensors.angle_deg = {0, 90};
  } else {
    for (const auto& sensor : model::kit_of(prepared.machine)->sensors)
      sensors.angle_deg.push_back(sensor.angle_deg);
  }
  sensors.rows.resize(static_cast<Eigen::Index>(which.size()), prepared.assembly.system.coordinates());
  for (std::size_t i = 0; i < which.size(); ++i) {
    const auto& map = points[static_cast<std::size_t>(which[i])].map;
    const double angle = sensors.angle_deg[i] * pi / 180;
    sensors.rows.row(static_cast<Eigen::Index>(i)) =
        std::cos(angle) * map.row(0) + std::sin(angle) * map.row(1);
  }
  return sensors;
}

Eigen::MatrixXd run_linear(const scene::PreparedMachine& prepared, const LinearRun& run,
                           const Eigen::MatrixXd& sensor_rows) {
  Eigen::VectorXd constant_n = scene::constant_load_n(prepared);
  if (run.driven != Driven::by_all) constant_n.setZero();
  const double end_hz = shaft_speed_hz(run, std::max(0, run.samples - 1) * run.sample_s);
  structure::refuse_beyond_tables(prepared.machine, std::min(run.from_hz, end_hz),
                                  std::max(run.from_hz, end_hz));
  structure::refuse_changing_mass(prepared.machine, "a run-up");
  Structure structure(prepared, run, constant_n);
  for (const structure::TabledSupport& support : prepared.assembly.tables) structure.add(support);
  if (run.kick && prepared.machine.kick) {
    // The pulses of any cell may be used, since their position and direction do not depend on the speed.
    for (const scene::Pulse& pulse :
         scene::build_cell(prepared, pulse_speed_hz(prepared), scene::Eccentricity{0}).scene.pulses)
      structure.add(pulse);
  }
  State state = initial_state(prepared, run, constant_n);
  const Eigen::Index n = prepared.assembly.system.coordinates();
  const double length = prepared.machine.stops.front().clearance_m;
  auto stepper = odeint::make_controlled<odeint::runge_kutta_dopri5<State>>(relative_tolerance * length,
                                                                            relative_tolerance);
  Eigen::MatrixXd signal(run.samples, sensor_rows.rows());
  ImpulsesOnARamp impulses(prepared, run);
  double t = 0, step = run.sample_s / 100;
  for (int k = 0; k < run.samples; ++k) {
    const double sample_at = k * run.sample_s;
    for (double target = 0; t < sample_at;) {
      // The stepper stores its last derivative, which became wrong when the impulse changed the velocities.
      if (impulses.apply(t, state)) stepper.reset();
      target = std::min(sample_at, impulses.next_s());
      const double rest = target - t;
      double trial = std::min(step, rest);
      const bool whole = trial == rest;
      if (stepper.try_step(std::ref(structure), state, t, trial) == odeint::success) {
        if (whole) t = target;
        if (!whole || trial > step) step = trial;
      } else {
        step = trial;
        if (step < shortest_step * run.sample_s) throw SolverError("linear run: the steps collapse");
      }
    }
    signal.row(k) = (sensor_rows * Eigen::Map<const Eigen::VectorXd>(state.data(), n)).transpose();
  }
  return signal;
}

}  // namespace rubsweep::linear
