#include "rubsweep/analysis/linear/campbell.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/scene/kit_machine.hpp"
#include "core/scene/one_side_machine.hpp"
#include "core/scene/table_machine.hpp"
#include "core/structure/steel.hpp"
#include "rubsweep/core/model/machine.hpp"
#include "rubsweep/core/numerics/dense/eigenvalues.hpp"
#include "rubsweep/core/numerics/dense/factors.hpp"
#include "rubsweep/core/structure/beam_element.hpp"
#include "rubsweep/core/structure/tabled_support.hpp"

namespace rubsweep::linear {
namespace {

using std::numbers::pi;

model::Machine with_kit(const model::RotorKit& kit) {
  model::Machine machine = scene::one_side_machine();
  machine.rotor = kit;
  machine.stops.front().position_m = 0;
  return machine;
}

std::vector<double> speeds(double from_hz, double to_hz, int count) {
  std::vector<double> values;
  for (int k = 0; k < count; ++k) values.push_back(from_hz + (to_hz - from_hz) * k / (count - 1));
  return values;
}

/// A thick shaft on simple supports, in which shear, rotary inertia and gyroscopic moments matter.
model::RotorKit simply_supported(int elements) {
  model::RotorKit kit;
  kit.shaft = {structure::steel_segment(1.2, 0.1)};
  kit.supports = {structure::isotropic_support(0, 1e13), structure::isotropic_support(1.2, 1e13)};
  kit.elements = elements;
  return kit;
}

/// Characteristic function of mode n of a rotating Timoshenko shaft on simple supports, with the deflection
/// sin(n pi z / l) and the rotation cos(n pi z / l). It is the determinant of the remaining 2 x 2 system.
double characteristic(const model::ShaftSegment& shaft, int n, double speed, double w) {
  const double k = n * pi / shaft.length_m, area = structure::section_area_m2(shaft),
               moment = structure::section_moment_m4(shaft), density = shaft.density_kg_per_m3;
  const double shear = structure::shear_coefficient(shaft) * shaft.shear_modulus_pa * area;
  const double deflection = shear * k * k - density * area * w * w;
  const double leaning = shaft.youngs_modulus_pa * moment * k * k + shear - density * moment * w * w +
                         2 * density * moment * speed * w;
  return deflection * leaning - shear * shear * k * k;
}

/// Root of `characteristic` closest to a whirl frequency, by bisection within 2 %; w < 0 is backward.
double closed_form(const model::ShaftSegment& shaft, int n, double speed, double near, bool at_critical) {
  const auto value = [&](double w) { return characteristic(shaft, n, at_critical ? std::abs(w) : speed, w); };
  double low = 0.98 * near, high = 1.02 * near;
  EXPECT_LT(value(low) * value(high), 0) << near;
  for (int step = 0; step < 60; ++step) {
    const double middle = (low + high) / 2;
    (value(low) * value(middle) <= 0 ? high : low) = middle;
  }
  return low;
}

TEST(Campbell, UniformShaftOnSimpleSupportsSplitsAsItsClosedForm) {
  const model::RotorKit kit = simply_supported(48);
  const double top_hz = 600;
  const Campbell diagram = campbell(free_rotor(with_kit(kit)), speeds(0, top_hz, 13), 1500);
  const double first_hz = closed_form(kit.shaft.front(), 1, 0, 2 * pi * 140, false) / (2 * pi);
  ASSERT_GE(diagram.modes.size(), 4u);
  EXPECT_NEAR(diagram.modes[0].points.front().frequency_hz, first_hz, 1e-4 * first_hz);
  for (int i = 0; i < 4; ++i) {
    const CampbellMode& mode = diagram.modes[static_cast<std::size_t>(i)];
    EXPECT_EQ(mode.number, i + 1);
    ASSERT_EQ(mode.points.size(), 13u);
    const double sense = i % 2 == 0 ? -1 : 1;  // backward comes before forward
    for (const CampbellPoint& point : mode.points) {
      const double found = 2 * pi * point.frequency_hz;
      const double expected =
          sense * closed_form(kit.shaft.front(), 1 + i / 2, 2 * pi * point.speed_hz, sense * found, false);
      EXPECT_NEAR(found, expected, 2e-4 * expected) << i << " at " << point.speed_hz;
      EXPECT_NEAR(point.forward_share, sense > 0 ? 1 : 0, 1e-6);
      EXPECT_NEAR(point.damping_ratio, 0, 1e-8);
    }
    // The shaft is so thick that the gyroscopic split is visible.
    EXPECT_GT(sense * (mode.points.back().frequency_hz / mode.points.front().frequency_hz - 1), 1e-3);
  }
}

TEST(Campbell, CriticalSpeedsAndShapesOfAUniformShaftAreThoseOfItsClosedForm) {
  const model::RotorKit kit = simply_supported(48);
  const Campbell diagram = campbell(free_rotor(with_kit(kit)), speeds(10, 900, 12), 900);
  ASSERT_EQ(diagram.critical_speeds.size(), 4u);
  double error_of_first = 1;
  for (const CriticalSpeed& critical : diagram.critical_speeds) {
    const double sense = critical.forward_share > 0.5 ? 1 : -1;
    const double found = 2 * pi * critical.speed_hz;
    const double expected =
        sense * closed_form(kit.shaft.front(), (critical.mode + 1) / 2, 0, sense * found, true);
    EXPECT_NEAR(found, expected, 2e-4 * expected) << critical.mode;
    if (critical.mode == 1) error_of_first = std::abs(found / expected - 1);
  }
  EXPECT_LT(error_of_first, 2e-5);
  ASSERT_EQ(diagram.shapes.size(), 4u);
  for (const ModeShape& shape : diagram.shapes) {
    const int n = (shape.mode + 1) / 2;
    double size = 0, sense = 0;
    for (std::size_t i = 0; i < diagram.position_m.size(); ++i) {
      const double sine = std::sin(n * pi * diagram.position_m[i] / 1.2);
      const auto x = shape.x(static_cast<Eigen::Index>(i)), y = shape.y(static_cast<Eigen::Index>(i));
      size = std::max(size, std::abs(x));
      EXPECT_NEAR(std::abs(x), std::abs(sine), 1e-4);
      // In forward whirl y lags x by 90 degrees.
      EXPECT_NEAR(std::abs(y - std::complex<double>(0, shape.forward_share > 0.5 ? -1 : 1) * x), 0, 1e-6);
      sense += x.real() * sine;
    }
    EXPECT_NEAR(size, 1, 1e-12);
    EXPECT_GT(std::abs(sense), 1);
  }
}

TEST(Campbell, CriticalSpeedsSolveTheirOwnEigenproblem) {
  // Undamped with unequal supports: stiffness q = W^2 (mass - i gyroscopic) q gives all critical speeds at
  // once.
  model::RotorKit kit;
  kit.shaft = {structure::steel_segment(1.5, 0.05)};
  kit.discs = {
      {.position_m = 0.5, .mass_kg = 32, .polar_inertia_kg_m2 = 0.32, .diametral_inertia_kg_m2 = 0.18},
      {.position_m = 1, .mass_kg = 51, .polar_inertia_kg_m2 = 0.78, .diametral_inertia_kg_m2 = 0.41}};
  kit.supports = {structure::isotropic_support(0, 1e6), structure::isotropic_support(1.5, 1e6)};
  for (auto& support : kit.supports) support.stiffness_y_n_per_m = 0.8e6;
  const FreeRotor rotor = free_rotor(with_kit(kit));
  const Campbell diagram = campbell(rotor, speeds(1, 150, 50), 400);
  // stiffness^-1 (mass - i gyroscopic) q = q / W^2 by a general eigensolver, because the inertia may be
  // indefinite. With separate real and imaginary parts of q each eigenvalue occurs twice.
  const Eigen::MatrixXd by_mass = numerics::dense::solve_full_pivot(rotor.full.system.stiffness,
                                                                    rotor.full.system.mass),
                        by_turning = numerics::dense::solve_full_pivot(rotor.full.system.stiffness,
                                                                       rotor.full.system.gyroscopic);
  Eigen::MatrixXd problem(2 * by_mass.rows(), 2 * by_mass.rows());
  problem << by_mass, by_turning, -by_turning, by_mass;
  std::vector<double> expected;
  for (const auto& value : numerics::dense::eigenvalues(problem)) {
    const double hz = value.real() > 0 ? 1 / std::sqrt(value.real()) / (2 * pi) : 1e9;
    if (hz > 1 && hz < 150) expected.push_back(hz);
  }
  std::ranges::sort(expected);
  ASSERT_EQ(2 * diagram.critical_speeds.size(), expected.size());
  ASSERT_GE(expected.size(), 8u);
  for (std::size_t k = 0; k < expected.size(); ++k)
    EXPECT_NEAR(diagram.critical_speeds[k / 2].speed_hz, expected[k], 1e-8 * expected[k]);
}

TEST(Campbell, OfAJeffcottRotorIsItsDampedFrequencyAtEverySpeed) {
  const Campbell diagram = campbell(free_rotor(scene::one_side_machine()), speeds(0, 100, 11), 200);
  const double damped_hz = 30 * std::sqrt(1 - 0.02 * 0.02);
  ASSERT_EQ(diagram.modes.size(), 2u);
  for (const CampbellMode& mode : diagram.modes) {
    for (const CampbellPoint& point : mode.points) {
      EXPECT_NEAR(point.frequency_hz, damped_hz, 1e-12 * damped_hz);
      EXPECT_NEAR(point.damping_ratio, 0.02, 1e-12);
      EXPECT_NEAR(point.forward_share, mode.number == 1 ? 0 : 1, 1e-9);
    }
  }
  ASSERT_EQ(diagram.critical_speeds.size(), 2u);
  for (const CriticalSpeed& critical : diagram.critical_speeds)
    EXPECT_NEAR(critical.speed_hz, damped_hz, 1e-9 * damped_hz);
}

/// Damping ratio of the slowest forward whirl at one speed.
double damping_of_forward_whirl(const model::Machine& machine, double speed_hz) {
  for (const CampbellMode& mode : campbell(free_rotor(machine), speeds(0, speed_hz, 5), 100).modes)
    if (mode.points.back().forward_share > 0.5) return mode.points.back().damping_ratio;
  return 1;
}

TEST(Campbell, DampingThatTurnsMakesForwardWhirlUnstableWhereItsClosedFormSays) {
  // At w0 (1 + external / rotating damping) the work of both dampings cancels.
  model::Machine machine = scene::one_side_machine();
  std::get<model::JeffcottRotor>(machine.rotor).rotating_damping_ratio = 0.01;
  EXPECT_NEAR(damping_of_forward_whirl(machine, 30 * (1 + 0.02 / 0.01)), 0, 1e-12);
  EXPECT_LT(damping_of_forward_whirl(machine, 30 * (1 + 0.02 / 0.01) + 1), -1e-4);
  model::Machine kit = scene::light_shaft_machine();
  const double first_hz = campbell(free_rotor(kit), speeds(0, 1, 2), 1).modes[0].points[0].frequency_hz /
                          std::sqrt(1 - 0.02 * 0.02);
  std::get<model::RotorKit>(kit.rotor).rotating_damping_ratio = {0.01};
  EXPECT_NEAR(damping_of_forward_whirl(kit, first_hz * (1 + 0.02 / 0.01)), 0, 1e-8);
}

TEST(Campbell, AGridThatHitsACriticalSpeedFindsItOnce) {
  model::Machine machine = scene::one_side_machine();
  machine.rotor = model::JeffcottRotor{.mass_kg = 1, .natural_frequency_hz = 30, .damping_ratio = 0};
  const Campbell found = campbell(free_rotor(machine), speeds(29, 31, 3), 100);
  EXPECT_EQ(found.critical_speeds.size(), 2u);
}

/// A short stiff rotor of mass 2 m on two supports, each of which carries m.
model::Machine bouncing_machine(const model::SupportTable& table) {
  model::Machine machine = scene::table_machine();
  model::RotorKit& kit = *model::kit_of(machine);
  kit.shaft[0].outer_diameter_m = 0.2;
  kit.shaft[0].density_kg_per_m3 = 1;
  kit.damping_ratio = {0};
  for (model::Support& support : kit.supports) support = model::with_table(support, table);
  return machine;
}
constexpr double bouncing_mass_kg = 0.8 + pi / 4 * 0.2 * 0.2 * 0.4;

/// Table of a film with equal stiffness in x and y and without cross stiffness.
model::SupportTable round_table() {
  model::SupportTable table = scene::film_table();
  table.columns[3] = table.columns[0];
  for (const std::size_t none : {1U, 2U, 4U, 5U, 6U, 7U}) table.columns[none].assign(5, 0);
  return table;
}

/// A short stiff rotor bounces at sqrt(2 k / m), with k from a table: the critical speed equals this
/// frequency.
TEST(Campbell, CriticalSpeedsFollowTheTableOfASupport) {
  const model::SupportTable table = round_table();
  const model::Machine machine = bouncing_machine(table);
  const structure::SupportCurves curves = structure::curves_of(table);
  double low = 20, high = 120;
  for (int step = 0; step < 60; ++step) {
    const double middle = (low + high) / 2;
    (std::sqrt(2 * curves[0](middle) / bouncing_mass_kg) > 2 * pi * middle ? low : high) = middle;
  }
  const Campbell diagram = campbell(free_rotor(machine), speeds(20, 120, 11), 100);
  ASSERT_EQ(diagram.critical_speeds.size(), 2u);  // backward and forward
  for (const CriticalSpeed& critical : diagram.critical_speeds)
    EXPECT_NEAR(critical.speed_hz, low, 2e-4 * low);
}

/// The damping passes the critical value downwards or upwards, so the mode begins or ends there. Its
/// frequency is that of a mass on a spring and a damper.
TEST(Campbell, FollowsModesThatBeginOrEndToOscillate) {
  model::SupportTable falling = round_table();
  const double critical = std::sqrt(2 * 3e4 * bouncing_mass_kg) / 2;
  falling.columns[0].assign(5, 3e4);
  falling.columns[4] = {3 * critical, 2 * critical, 0.9 * critical, 0.5 * critical, 0.3 * critical};
  falling.columns[3] = falling.columns[0];
  falling.columns[7] = falling.columns[4];
  model::SupportTable rising = falling;
  std::ranges::reverse(rising.columns[4]);
  rising.columns[7] = rising.columns[4];
  for (const model::SupportTable& table : {falling, rising}) {
    const structure::SupportCurves curves = structure::curves_of(table);
    const Campbell diagram = campbell(free_rotor(bouncing_machine(table)), speeds(20, 120, 41), 100);
    std::size_t whirls = 0, expected = 0;
    for (const double speed_hz : speeds(20, 120, 41)) {
      const double rate = curves[4](speed_hz) / bouncing_mass_kg;
      const double square = 2 * 3e4 / bouncing_mass_kg - rate * rate;
      expected += square > 0 ? 2 : 0;
      for (const CampbellMode& mode : diagram.modes) {
        for (const CampbellPoint& point : mode.points) {
          // At this speed the rotor also rocks, at another frequency.
          const double bouncing_hz = square > 0 ? std::sqrt(square) / (2 * pi) : -1;
          const bool bounces = std::abs(point.frequency_hz - bouncing_hz) < 1e-3 * bouncing_hz;
          whirls += point.speed_hz == speed_hz && bounces ? 1 : 0;
        }
      }
    }
    EXPECT_EQ(whirls, expected);
    EXPECT_GT(expected, 30u);
  }
}

/// An unstable mode is shown even if its frequency is far above the speeds of the diagram.
TEST(Campbell, ShowsWhatGrows) {
  model::Machine machine = scene::one_side_machine();
  std::get<model::JeffcottRotor>(machine.rotor).damping_ratio = 0;
  FreeRotor rotor = free_rotor(machine);
  rotor.full.system.stiffness(0, 1) = 0.1 * rotor.full.system.stiffness(0, 0);
  rotor.full.system.stiffness(1, 0) = -rotor.full.system.stiffness(0, 1);
  const Campbell diagram = campbell(rotor, speeds(0.1, 0.2, 2), 0.5);
  ASSERT_EQ(diagram.growth.size(), 2u);
  // The eigenvalues satisfy -s^2 = w^2 (1 -+ 0.1 i).
  const double growth = 60 * pi * std::sqrt(std::complex<double>(-1, 0.1)).real();
  EXPECT_NEAR(diagram.growth.front().growth_per_s, growth, 1e-9 * growth);
  double least = 1;
  for (const CampbellMode& mode : diagram.modes) least = std::min(least, mode.points.front().damping_ratio);
  EXPECT_NEAR(least, -growth / (60 * pi * std::abs(std::sqrt(std::complex<double>(-1, 0.1)))), 1e-9);
}

/// Each mode has its own ratio from the list; the last ratio also holds for all further modes.
TEST(Campbell, RatiosOfModesAreThose) {
  model::RotorKit kit = simply_supported(24);
  kit.damping_ratio = {0.01, 0.03};
  for (const CampbellMode& mode : campbell(free_rotor(with_kit(kit)), speeds(0, 0.001, 2), 2000).modes)
    EXPECT_NEAR(mode.points.front().damping_ratio, mode.number <= 2 ? 0.01 : 0.03, 1e-9) << mode.number;
}

/// A Jeffcott rotor of 30 Hz, whose whirl frequency does not depend on the speed.
model::Machine jeffcott(double damping_ratio) {
  model::Machine machine;
  machine.rotor =
      model::JeffcottRotor{.mass_kg = 0.8, .natural_frequency_hz = 30, .damping_ratio = damping_ratio};
  return machine;
}

std::vector<FollowedMode> first_mode(const WhirlProblem& problem, std::span<const double> speeds_hz) {
  std::vector<FollowedMode> curve;
  for (const double speed_hz : speeds_hz) curve.push_back({speed_hz, problem.at(speed_hz).modes.front()});
  return curve;
}

TEST(CampbellCriticalSpeeds, OfAJeffcottRotorIsItsDampedFrequency) {
  const FreeRotor rotor = free_rotor(jeffcott(0.1));
  const std::array speeds_hz{10.0, 25.0, 50.0};
  const WhirlProblem problem(rotor, speeds_hz, 100);
  const auto found = critical_points(problem, first_mode(problem, speeds_hz));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0].speed_hz, 30 * std::sqrt(1 - 0.01), 1e-10);
  EXPECT_NEAR(found[0].mode.damping_ratio(), 0.1, 1e-10);
}

TEST(CampbellCriticalSpeeds, AreNoneWhereTheSpeedStaysBelowTheFrequency) {
  const FreeRotor rotor = free_rotor(jeffcott(0.1));
  const std::array speeds_hz{10.0, 25.0};
  const WhirlProblem problem(rotor, speeds_hz, 100);
  EXPECT_TRUE(critical_points(problem, first_mode(problem, speeds_hz)).empty());
}

}  // namespace

}  // namespace rubsweep::linear
