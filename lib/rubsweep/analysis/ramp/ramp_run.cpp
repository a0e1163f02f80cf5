#include "rubsweep/analysis/ramp/ramp_run.hpp"

#include <complex>
#include <span>

#include "rubsweep/analysis/ramp/ramp_dynamics.hpp"
#include "rubsweep/core/error.hpp"
#include "rubsweep/core/integrate/adaptive/adaptive_run.hpp"
#include "rubsweep/core/numerics/dense/factors.hpp"
#include "rubsweep/core/scene/build_scene.hpp"
#include "rubsweep/core/scene/scene.hpp"

namespace rubsweep::ramp {
namespace {

using integrate::run::Outcome;
using integrate::run::StateScale;
using std::numbers::pi;

/// Sets the start of the ramp: displacements and velocities in SI.
void set_start(const scene::PreparedMachine& machine, const SpeedRamp& ramp, scene::Scene& scene) {
  const scene::Cell cell = scene::build_cell(machine, ramp.from_hz, scene::Eccentricity{ramp.eccentricity_m});
  if (!scene::can_run(cell.start)) {
    throw ConfigError(
        "run-up: the rotor has no motion to start from: static forces press it through a wall, or there is "
        "no "
        "quiet motion at the first speed, allowed: another machine or another first speed");
  }
  scene.displacement_m = cell.scene.displacement_m;
  scene.velocity_m_per_s = cell.scene.velocity_m_per_s;
  if (cell.start != scene::Start::quiet || machine.machine.start) return;
  // The quiet motion of a map begins at the smallest gap, whereas a ramp begins with the mark of the shaft
  // along +x.
  const double w = cell.scene.speed_rad_per_s;
  Eigen::VectorXcd force = ramp.eccentricity_m * w * w * machine.assembly.system.unbalance_kg;
  if (machine.assembly.bow_n.size() > 0) force += machine.assembly.bow_n;
  const scene::QuietMotion quiet =
      scene::quiet_motion(cell.scene.structure, w, force, cell.scene.constant_n, machine.assembly.second_n);
  scene.displacement_m = quiet.displacement(0);
  scene.velocity_m_per_s = w * quiet.velocity(0);
}

/// Scene of the machine at the fastest speed of the ramp, without the forces and terms that rotate with the
/// shaft.
scene::Scene reference_scene(const scene::PreparedMachine& machine, const SpeedRamp& ramp) {
  if (!machine.assembly.impulses.empty())
    throw ConfigError(
        "rotor.supports: a faulty bearing is no part of a run-up with stops, allowed: no fault");
  structure::refuse_beyond_tables(machine.machine, std::min(ramp.from_hz, ramp.to_hz), ramp.fastest_hz());
  structure::refuse_changing_mass(machine.machine, "a run-up");
  scene::Scene scene = scene::build_cell(machine, ramp.fastest_hz(), scene::Eccentricity{0}).scene;
  scene.structure.damping = machine.assembly.system.damping;
  scene.structure.stiffness = machine.assembly.system.stiffness;
  scene.harmonic_n = Eigen::VectorXcd::Zero(scene.structure.coordinates());
  scene.second_harmonic_n.resize(0);
  scene.pulses.clear();
  set_start(machine, ramp, scene);
  return scene;
}

RampForces forces_of(const scene::PreparedMachine& machine, const SpeedRamp& ramp, const StateScale& scale) {
  const structure::Assembly& assembly = machine.assembly;
  const numerics::dense::SymmetricFactors mass(assembly.system.mass);
  const auto solved = [&](const Eigen::VectorXcd& force) {
    const std::complex<double> i(0, 1);
    return Eigen::VectorXcd(mass.solve(Eigen::VectorXd(force.real())).cast<std::complex<double>>() +
                            i * mass.solve(Eigen::VectorXd(force.imag())).cast<std::complex<double>>());
  };
  const double reference = scale.speed_rad_per_s;
  RampForces forces;
  forces.start_speed = 2 * pi * ramp.from_hz / reference;
  forces.acceleration = 2 * pi * ramp.rate_hz_per_s / (reference * reference);
  forces.unbalance = ramp.eccentricity_m / scale.length_m * solved(assembly.system.unbalance_kg);
  if (assembly.bow_n.size() > 0) forces.bow = solved(assembly.bow_n) / scale.unit_acceleration_m_per_s2();
  if (assembly.second_n.size() > 0)
    forces.second = solved(assembly.second_n) / scale.unit_acceleration_m_per_s2();
  if (assembly.gyroscopic.size() > 0) forces.gyroscopic = mass.solve(assembly.gyroscopic);
  if (assembly.circulatory.size() > 0) forces.circulatory = mass.solve(assembly.circulatory) / reference;
  forces.reference_rad_per_s = reference;
  for (const structure::TabledSupport& support : assembly.tables)
    forces.supports.push_back({support, mass.solve(Eigen::MatrixXd(support.map.transpose()))});
  return forces;
}

/// Converts reports of a run, one for each stretch, to SI.
class StretchReader {
 public:
  StretchReader(const scene::Scene& scene, int samples)
      : scale_(integrate::run::state_scale(scene)),
        observed_(scene::observed(scene)),
        period_s_(scene.period_s()),
        samples_(samples) {}

  /// Converts the report of stretch `number`, which ends at `end_s`.
  const RampStretch& read(const integrate::run::TurnReport& report, long number, double end_s) {
    const auto n = static_cast<std::size_t>(observed_.cols()), size = 2 * n + 2;
    stretch_.begin_s = static_cast<double>(number) * period_s_;
    stretch_.end_s = end_s;
    stretch_.samples.clear();
    for (int k = 0; k < report.sample_count; ++k) {
      const auto state = std::span(report.samples).subspan(static_cast<std::size_t>(k) * size, 2 * n);
      stretch_.samples.push_back(
          {(static_cast<double>(number) + static_cast<double>(k) / samples_) * period_s_,
           observed_ * scale_.displacement_m(state), observed_ * scale_.velocity_m_per_s(state)});
    }
    stretch_.hits = report.hits;
    stretch_.touching_s = report.contact_fraction * period_s_;
    stretch_.touched = report.touched;
    stretch_.peak_displacement_m = report.peak_displacement_m;
    stretch_.peak_contact_force_n = report.peak_contact_force_n;
    return stretch_;
  }

 private:
  StateScale scale_;
  Eigen::Matrix<double, 2, Eigen::Dynamic> observed_;
  double period_s_;
  int samples_;
  RampStretch stretch_;
};

template <int N>
Outcome run_ramp(const scene::Scene& scene, const RampForces& forces, double turns,
                 integrate::run::SolverOptions solver, int samples,
                 const std::function<void(const RampStretch&)>& on_stretch) {
  solver.stepper = integrate::run::Stepper::dopri5;
  integrate::adaptive::AdaptiveRun<RampDynamics<N>> run(scene, solver, forces);
  const integrate::run::TurnRequest request{.samples_per_revolution = samples, .peaks = true};
  StretchReader reader(scene, samples);
  integrate::run::TurnReport report;
  for (long number = 0; static_cast<double>(number) < turns; ++number) {
    constexpr double nothing = 1e-9;  // share of a turn that counts as rounding at the ramp's end
    const double rest = std::min(1.0, turns - static_cast<double>(number));
    if (rest < nothing) break;
    const Outcome outcome = run.advance(request, report, 2 * pi * rest);
    if (outcome != Outcome::ok) return outcome;
    on_stretch(reader.read(report, number, (static_cast<double>(number) + rest) * scene.period_s()));
  }
  return Outcome::ok;
}

}  // namespace

Outcome run_ramp(const scene::PreparedMachine& machine, const SpeedRamp& ramp,
                 const integrate::run::SolverOptions& solver, int samples,
                 const std::function<void(const RampStretch&)>& on_stretch) {
  const scene::Scene scene = reference_scene(machine, ramp);
  const RampForces forces = forces_of(machine, ramp, integrate::run::state_scale(scene));
  const double turns = ramp.duration_s() / scene.period_s();
  // A fixed size for the most common scene, a rotor and one casing.
  return scene.structure.coordinates() == 4
             ? run_ramp<4>(scene, forces, turns, solver, samples, on_stretch)
             : run_ramp<Eigen::Dynamic>(scene, forces, turns, solver, samples, on_stretch);
}

}  // namespace rubsweep::ramp
