#include "rubsweep/measurement/diagnose/inference/simulated_case.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <memory>
#include <string>

#include "measurement/diagnose/light_kit.hpp"
#include "small_problem.hpp"

namespace rubsweep::diagnose::inference {
namespace {

TEST(SimulatedCase, GrowsWithItsClearance) {
  // With ten times the clearance the same machine has ten times the displacement and ten times the force.
  DiagnosisProblem problem = small_problem(), larger = problem;
  for (Candidate& candidate : larger.candidates) candidate.clearance_m = {5e-4, 1e-2, true};
  response::spectrum::SpectrumWorkspace workspace;
  int compared = 0;
  for (const SimulatedCase& one : small_set().cases) {
    // Chaotic motions, which amplify rounding, are left out.
    if (one.candidate != 1 || one.motion.contact.hits > 40) continue;
    const auto other = simulate_case(larger, 1, one.unit, workspace);
    ASSERT_TRUE(other);
    ++compared;
    const double scale = size_of(other->motion.lines) / size_of(one.motion.lines);
    EXPECT_NEAR(scale, 10, 0.1);
    EXPECT_NEAR(other->motion.contact.peak_contact_force_n / one.motion.contact.peak_contact_force_n, scale,
                0.1);
    if (compared == 5) break;
  }
  EXPECT_EQ(compared, 5);
}

TEST(SimulatedCase, OfAFlatStopMovesOffTheRunningSpeedAlongOneDirection) {
  // Normal force and constant friction keep their directions, and the rotor is the same all around.
  int compared = 0;
  for (const SimulatedCase& one : small_set().cases) {
    const MotionLines& lines = one.motion.lines;
    const auto off_1x = [&](int k) { return std::abs(std::abs(k) - lines.turns) > 2 ? 1.0 : 0.0; };
    if (one.candidate != 1) continue;
    EXPECT_GT(features::straightness(lines, off_1x), 0.99);
    ++compared;
  }
  EXPECT_GT(compared, 10);
}

TEST(SimulatedCase, OfAKitThatIsAJeffcottRotorIsTheSame) {
  DiagnosisProblem problem = small_problem(), of_kit = small_problem();
  of_kit.fixed.kit = std::make_shared<KnownKit>(known_kit({light_kit()}, problem.speed_hz, "kit.yaml"));
  for (DiagnosisProblem* one : {&problem, &of_kit}) {
    one->fixed.rotor_mass_kg = of_kit.fixed.kit->rotor_mass_kg;
    for (Candidate& candidate : one->candidates) {
      const double frequency_hz = of_kit.fixed.kit->natural_frequency_hz;
      spread_of(candidate, Unknown::natural_frequency) = {frequency_hz, frequency_hz};
      spread_of(candidate, Unknown::damping_ratio) = {0.02, 0.02};
      // The stop is at the disc.
      spread_of(candidate, Unknown::position) = {0.2, 0.2};
    }
  }
  response::spectrum::SpectrumWorkspace workspace;
  int compared = 0;
  for (const SimulatedCase& one : small_set().cases) {
    if (one.candidate != 1 || one.motion.contact.hits > 40) continue;
    const auto jeffcott = simulate_case(problem, 1, one.unit, workspace),
               kit = simulate_case(of_kit, 1, one.unit, workspace);
    ASSERT_EQ(jeffcott.has_value(), kit.has_value());
    if (!kit || jeffcott->motion.contact.hits > 40) continue;
    EXPECT_NEAR(kit->motion.contact.peak_contact_force_n / jeffcott->motion.contact.peak_contact_force_n, 1,
                1e-3);
    // The probe is closer to the bearing, where the shaft moves less, but in phase.
    const std::complex<double> ratio = kit->motion.lines.at(12) / jeffcott->motion.lines.at(12);
    EXPECT_LT(ratio.real(), 1);
    EXPECT_NEAR(ratio.imag(), 0, 1e-3);
    EXPECT_NEAR(kit->motion.eccentricity_m / jeffcott->motion.eccentricity_m, 1, 1e-4);
    if (++compared == 4) break;
  }
  EXPECT_EQ(compared, 4);
}

TEST(SimulatedCase, NoneTouchesDeeperThanHalfOfItsSmallestClearance) {
  DiagnosisProblem problem = small_problem();
  const Candidate known = problem.candidates[1];
  response::spectrum::SpectrumWorkspace workspace;
  RandomStream random(8, 0, 0);
  for (const Cause cause : {Cause::one_side, Cause::two_sides, Cause::annular}) {
    Candidate& candidate = problem.candidates[1] = usual_candidate(cause);
    for (const Unknown unknown : {Unknown::natural_frequency, Unknown::damping_ratio})
      spread_of(candidate, unknown) = spread_of(known, unknown);
    candidate.clearance_m = {2e-4, 2e-4};
    int shallow = 0, deep = 0;
    for (int k = 0; k < 40; ++k) {
      Point unit{};
      for (double& place : unit) place = random.uniform();
      const Point values = values_at(candidate, unit);
      const auto any =
          rubbing_motion(drawn_machine(cause, values, 2e-4, problem.fixed), problem.speed_hz,
                         scene::WhirlRatio{value_of(values, Unknown::whirl_ratio)}, problem.turns, workspace);
      if (!any) continue;
      const double second = cause == Cause::two_sides ? value_of(values, Unknown::second_clearance_ratio) : 1;
      // Every exponent has the stiffness at a twentieth of the clearance.
      const double deepest = 0.5 * std::fmin(1, second) / 0.05,
                   force_n = value_of(values, Unknown::stiffness) * 0.05 * 2e-4 *
                             std::pow(deepest, value_of(values, Unknown::exponent));
      const bool within = any->contact.peak_contact_force_n <= force_n;
      ++(within ? shallow : deep);
      EXPECT_EQ(simulate_case(problem, 1, unit, workspace).has_value(), within);
    }
    EXPECT_GT(shallow, 0) << to_string(cause);
    EXPECT_GT(deep, 0) << to_string(cause);
    RecordProperty(std::string(to_string(cause)), std::to_string(deep) + " deep, " + std::to_string(shallow));
  }
}

TEST(SimulatedCase, IsObservedTheSameEveryTime) {
  response::spectrum::SpectrumWorkspace workspace;
  const auto once = observe(small_problem(), small_set().cases[3], 3, workspace),
             again = observe(small_problem(), small_set().cases[3], 3, workspace),
             other = observe(small_problem(), small_set().cases[3], 4, workspace);
  EXPECT_EQ(features::values_of(once.seen.features), features::values_of(again.seen.features));
  EXPECT_NE(features::values_of(once.seen.features), features::values_of(other.seen.features));
}

/// |r^2 / (1 - r^2 + 2 i damping_ratio r)|: whirl of an unbalanced Jeffcott rotor over its eccentricity
/// (textbooks, such as Muszynska, Rotordynamics, 2005), r being speed over natural frequency.
double quiet_whirl(double r, double damping_ratio) {
  return r * r / std::abs(std::complex<double>(1 - r * r, 2 * damping_ratio * r));
}

TEST(SimulatedCase, WhirlsAtAFurtherSpeedWithTheSameUnbalance) {
  DiagnosisProblem problem = small_problem();
  problem.further_speeds_hz = {45, 31};
  response::spectrum::SpectrumWorkspace workspace;
  for (const SimulatedCase& one : small_set().cases) {
    if (one.candidate != 0) continue;
    const auto again = simulate_case(problem, 0, one.unit, workspace);
    ASSERT_TRUE(again);
    EXPECT_EQ(again->motion.lines.amplitude, one.motion.lines.amplitude);
    ASSERT_EQ(again->further.size(), 2U);
    const Point values = values_at(problem.candidates[0], one.unit);
    for (std::size_t k = 0; k < 2; ++k) {
      const double r = problem.further_speeds_hz[k] / value_of(values, Unknown::natural_frequency),
                   expected_m =
                       one.motion.eccentricity_m * quiet_whirl(r, value_of(values, Unknown::damping_ratio));
      EXPECT_NEAR(std::abs(again->further[k].at(problem.turns)) / expected_m, 1, 1e-6);
    }
  }
}

TEST(SimulatedCase, AtTheSameSpeedRubsInTheSameWay) {
  DiagnosisProblem problem = small_problem();
  problem.further_speeds_hz = {problem.speed_hz};
  response::spectrum::SpectrumWorkspace workspace;
  int same = 0, quiet = 0, lost = 0;
  for (const SimulatedCase& one : small_set().cases) {
    if (one.candidate != 1) continue;
    const auto again = simulate_case(problem, 1, one.unit, workspace);
    if (!again) {
      ++lost;
      continue;
    }
    const MotionLines& lines = again->further[0];
    // With the kick it rubs again; without it, it whirls quietly, unless its whirl touches the stop anyway.
    double off_1x = 0;
    for (int k = -lines.last(); k <= lines.last(); ++k)
      if (k != 0 && k != lines.turns) off_1x += std::norm(lines.at(k));
    if (off_1x < 1e-12 * size_of(lines) * size_of(lines))
      ++quiet;
    else if (std::abs(size_of(lines) / size_of(one.motion.lines) - 1) < 1e-2)
      ++same;
  }
  EXPECT_GT(same, 8);
  EXPECT_GT(quiet, 3);
  RecordProperty("same_quiet_lost",
                 std::to_string(same) + " " + std::to_string(quiet) + " " + std::to_string(lost));
}

TEST(SimulatedCase, IsObservedAtAllSpeedsByTheSameInstrument) {
  DiagnosisProblem problem = small_problem();
  problem.further_speeds_hz = {problem.speed_hz};
  problem.measuring.noise_share = {0, 0};
  problem.measuring.other_lines = {0, 0, 0};
  problem.measuring.free_vibration = problem.measuring.gain_error = 0;
  response::spectrum::SpectrumWorkspace workspace;
  for (const int probes : {1, 2}) {
    problem.measuring.probes = probes;
    SimulatedCase one = small_set().cases[30];
    one.further = {one.motion.lines};
    for (auto& line : one.further[0].amplitude) line *= 2;
    const features::Features seen = observe(problem, one, 30, workspace).seen.features;
    ASSERT_EQ(seen.size() % 2, 0U);
    const std::size_t half = seen.size() / 2 - 1;
    EXPECT_EQ(seen[half].name, "size at 66 Hz");
    EXPECT_NEAR(seen[half].value, std::log10(2), 1e-9);
    EXPECT_EQ(seen[half + 1].name, "size off the resonance at 66 Hz");
    EXPECT_NEAR(seen[half + 1].value, std::log10(2), 1e-9);
    for (std::size_t k = 0; k < half; ++k) {
      EXPECT_EQ(seen[half + 2 + k].name, seen[k].name + " at 66 Hz");
      EXPECT_NEAR(seen[half + 2 + k].value, seen[k].value, 1e-6) << seen[k].name;
    }
  }
}

}  // namespace
}  // namespace rubsweep::diagnose::inference
