#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

#include "core/scene/misaligned_machine.hpp"
#include "rubsweep/core/scene/build_scene.hpp"
#include "rubsweep/core/structure/assembly.hpp"

namespace rubsweep::scene {
namespace {

using Complex = std::complex<double>;
using std::numbers::pi;

Complex turned(double degrees) { return std::polar(1.0, degrees * pi / 180); }

/// Force of twice the speed on the shaft end behind the coupling, as a phasor that rotates at 2 w. The
/// coupling is strained by the part of the misalignment that the soft bearing behind it resists.
Complex force_n(const MisalignedRotor& rotor) {
  const Complex strained = rotor.misalignment_m * turned(rotor.misalignment_deg) * rotor.behind_n_per_m /
                           (rotor.coupling_n_per_m + rotor.behind_n_per_m);
  return -rotor.asymmetry_ratio * rotor.coupling_n_per_m * turned(2 * rotor.stiff_axis_deg) *
         std::conj(strained);
}

/// Phasor of the disc's displacement at 2 w in x; y lags by 90 degrees. Half of the force reaches the middle
/// of the shaft.
Complex disc_m(const MisalignedRotor& rotor, double speed_rad_per_s) {
  const double r = 2 * speed_rad_per_s / rotor.natural_rad_per_s();
  return force_n(rotor) / (2 * (rotor.coupling_n_per_m + rotor.behind_n_per_m)) /
         Complex(1 - r * r, 2 * rotor.damping_ratio * r);
}

Eigen::Vector2cd second_of(const QuietMotion& motion, const PreparedMachine& prepared) {
  const auto& point =
      prepared.assembly.system.points[static_cast<std::size_t>(prepared.assembly.observed_point)];
  return point.map.cast<Complex>() * motion.second_amplitude;
}

TEST(MisalignedCoupling, ItsLineAtTwiceTheSpeedIsThatOfAJeffcottRotor) {
  const MisalignedRotor rotor;
  const PreparedMachine prepared = prepare_machine(rotor.machine());
  const Eigen::Index n = prepared.assembly.system.coordinates();
  for (const double share :
       {0.2, 0.45, 0.5, 0.55, 0.8}) {  // ratios to the critical speed; resonance at one half
    const double w = share * rotor.natural_rad_per_s();
    const QuietMotion motion =
        quiet_motion(structure::system_at(prepared.assembly, w), w, Eigen::VectorXcd::Zero(n),
                     Eigen::VectorXd::Zero(n), prepared.assembly.second_n);
    const Eigen::Vector2cd found = second_of(motion, prepared);
    const Complex expected = disc_m(rotor, w);
    EXPECT_LT(std::abs(found.x() - expected), 2e-3 * std::abs(expected)) << share;
    EXPECT_LT(std::abs(found.y() - Complex(0, -1) * expected), 2e-3 * std::abs(expected)) << share;
  }
}

TEST(MisalignedCoupling, ThePositionAtRestIsThatOfSpringsInSeries) {
  const MisalignedRotor rotor;
  const PreparedMachine prepared = prepare_machine(rotor.machine());
  const Cell cell = build_cell(prepared, 20, Eccentricity{1e-5});
  const Eigen::Vector2d middle =
      prepared.assembly.system.points[static_cast<std::size_t>(prepared.assembly.observed_point)].map *
      cell.quiet.mean;
  const Complex end = -rotor.misalignment_m * turned(rotor.misalignment_deg) * rotor.coupling_n_per_m /
                      (rotor.coupling_n_per_m + rotor.behind_n_per_m);
  EXPECT_LT(std::abs(Complex(middle.x(), middle.y()) - end / 2.0), 1e-3 * std::abs(end));
}

/// A shaft that can follow the misalignment causes no strain; a shaft bent by its weight vibrates even
/// without misalignment.
TEST(MisalignedCoupling, TheStrainOfTheCouplingDecides) {
  MisalignedRotor free;
  free.behind_n_per_m = 1e-3;
  const double strained = prepare_machine(MisalignedRotor{}.machine()).assembly.second_n.norm();
  EXPECT_LT(prepare_machine(free.machine()).assembly.second_n.norm(), 1e-6 * strained);

  MisalignedRotor heavy;
  heavy.misalignment_m = 0;
  heavy.behind_n_per_m = 1e-3;
  model::Machine machine = heavy.machine();
  EXPECT_EQ(prepare_machine(machine).assembly.second_n.norm(), 0);
  machine.gravity_m_per_s2 = 9.81;
  const PreparedMachine prepared = prepare_machine(machine);
  const double w = heavy.natural_rad_per_s() / 2;  // half of the critical speed: weight-excited resonance
  const Eigen::Index n = prepared.assembly.system.coordinates();
  const QuietMotion motion =
      quiet_motion(structure::system_at(prepared.assembly, w), w, Eigen::VectorXcd::Zero(n),
                   Eigen::VectorXd::Zero(n), prepared.assembly.second_n);
  const double expected =
      heavy.asymmetry_ratio * heavy.mass_kg * 9.81 / (4 * heavy.coupling_n_per_m) / (2 * heavy.damping_ratio);
  EXPECT_NEAR(std::abs(second_of(motion, prepared).x()), expected, 5e-3 * expected);
}

TEST(MisalignedCoupling, EqualStiffnessAllAroundForcesNothingTwicePerTurn) {
  MisalignedRotor equal;
  equal.asymmetry_ratio = 0;
  const PreparedMachine prepared = prepare_machine(equal.machine());
  EXPECT_EQ(prepared.assembly.second_n.size(), 0);
  EXPECT_EQ(build_cell(prepared, 20, WhirlRatio{0.3}).scene.second_harmonic_n.size(), 0);
}

/// The run starts at the smallest gap of a motion that is not an ellipse, and the whirl ratio is the given
/// one.
TEST(MisalignedCoupling, TheWhirlRatioIsThatOfBothOrders) {
  const MisalignedRotor rotor;
  const PreparedMachine prepared = prepare_machine(rotor.machine());
  for (const double share : {0.3, 0.5, 0.7}) {
    const double speed_hz = share * rotor.natural_rad_per_s() / (2 * pi);
    const Cell cell = build_cell(prepared, speed_hz, WhirlRatio{0.4});
    ASSERT_EQ(cell.start, Start::quiet);
    const Contact& contact = cell.scene.contacts.front();
    const auto relative = relative_map(cell.scene.structure, contact);
    const auto height = [&](double phase) {
      return std::get<contact::FlatWall>(contact.wall).normal.dot(relative * cell.quiet.displacement(phase));
    };
    const double mean = std::get<contact::FlatWall>(contact.wall).normal.dot(relative * cell.quiet.mean);
    EXPECT_NEAR((height(0) - mean) / (contact.clearance_m - mean), 0.4, 1e-12) << share;
    for (int k = 1; k < 1000; ++k) EXPECT_LT(height(2 * pi * k / 1000), height(0)) << share << ' ' << k;
    EXPECT_NEAR(build_cell(prepared, speed_hz, Eccentricity{cell.eccentricity_m}).whirl_ratio, 0.4, 1e-12);
    // The second order is not negligible compared with the first.
    EXPECT_GT(cell.quiet.second_amplitude.norm(), 1e-3 * cell.quiet.amplitude.norm());
  }
}

/// The phase between both orders is fixed by the mark on the shaft.
TEST(MisalignedCoupling, TheKicksPhaseTurnsBothOrdersTogether) {
  model::Machine machine = MisalignedRotor{}.machine();
  const Cell early = build_cell(machine, 15, WhirlRatio{0.4});
  machine.kick->phase_deg = 50;
  const Cell late = build_cell(machine, 15, WhirlRatio{0.4});
  const double angle = 50 * pi / 180;
  EXPECT_LT((early.quiet.displacement(angle + 0.3) - late.quiet.displacement(0.3)).norm(),
            1e-13 * early.quiet.amplitude.norm());
  const PreparedMachine prepared = prepare_machine(machine);
  const Complex first = prepared.assembly.system.unbalance_kg.dot(early.scene.harmonic_n) /
                        std::abs(prepared.assembly.system.unbalance_kg.dot(early.scene.harmonic_n));
  EXPECT_LT((first * first * prepared.assembly.second_n - early.scene.second_harmonic_n).norm(),
            1e-12 * prepared.assembly.second_n.norm());
}

/// The complete rotor with a coupling of rotating stiffness, without approximation: m z'' + c z' = -P. The
/// shaft end behind the coupling is in equilibrium under P / 2 and the springs. Returns phasors by order in
/// the steady state.
class TurningStiffness {
 public:
  explicit TurningStiffness(const MisalignedRotor& rotor, double speed_rad_per_s)
      : rotor_(rotor), speed_(speed_rad_per_s) {}

  /// Amplitude of the forward part of the disc's motion at `order`.
  double amplitude_m(int order) const {
    constexpr int steps = 256, settle = 200;
    const double h = 2 * pi / speed_ / steps;
    Complex z = 0, v = 0, sum = 0;
    for (int turn = 0; turn <= settle; ++turn) {
      for (int k = 0; k < steps; ++k) {
        const double t = k * h;
        if (turn == settle) sum += z * std::polar(1.0, -order * speed_ * t) / double(steps);
        const Complex a1 = acceleration(z, v, t), v2 = v + h / 2 * a1,
                      a2 = acceleration(z + h / 2 * v, v2, t + h / 2), v3 = v + h / 2 * a2,
                      a3 = acceleration(z + h / 2 * v2, v3, t + h / 2), v4 = v + h * a3,
                      a4 = acceleration(z + h * v3, v4, t + h);
        z += h / 6 * (v + 2.0 * v2 + 2.0 * v3 + v4);
        v += h / 6 * (a1 + 2.0 * a2 + 2.0 * a3 + a4);
      }
    }
    return std::abs(sum);
  }

 private:
  /// The shaft end e satisfies K e + K' conj(e) = P / 2 - k delta - k ratio e^{2 i angle} conj(delta), with P
  /// = (z - e / 2) / f.
  Complex acceleration(Complex z, Complex v, double t) const {
    const double k = rotor_.coupling_n_per_m;
    const double flexibility = rotor_.bent_m_per_n() + 1 / (4 * rotor_.end_n_per_m);
    const Complex axis =
        std::polar(rotor_.asymmetry_ratio * k, 2 * speed_ * t) * turned(2 * rotor_.stiff_axis_deg);
    const Complex apart = rotor_.misalignment_m * turned(rotor_.misalignment_deg);
    const double own = k + rotor_.behind_n_per_m + 1 / (4 * flexibility);
    const Complex side = z / (2 * flexibility) - k * apart - axis * std::conj(apart);
    // The equation own e + axis conj(e) = side is solved for the shaft end e.
    const Complex end = (own * side - axis * std::conj(side)) / (own * own - std::norm(axis));
    const double damping = 2 * rotor_.damping_ratio * rotor_.natural_rad_per_s();
    return -(z - end / 2.0) / flexibility / rotor_.mass_kg - damping * v;
  }

  MisalignedRotor rotor_;
  double speed_;
};

/// The neglected part of the force is quadratic in the asymmetry.
TEST(MisalignedCoupling, FirstOrderIsEnoughForTheLineAtTwiceTheSpeed) {
  for (const double share : {0.2, 0.5, 0.8}) {
    for (const double ratio : {0.05, 0.1, 0.2}) {
      MisalignedRotor rotor;
      rotor.asymmetry_ratio = ratio;
      const double w = share * rotor.natural_rad_per_s();
      const double whole = TurningStiffness(rotor, w).amplitude_m(2), linear = std::abs(disc_m(rotor, w));
      EXPECT_LT(std::abs(whole - linear), 0.8 * ratio * ratio * whole) << share << ' ' << ratio;
    }
  }
}

}  // namespace
}  // namespace rubsweep::scene
