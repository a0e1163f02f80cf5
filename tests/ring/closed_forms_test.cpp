// Compares every closed form with the eigenvalues, relative accuracy 1e-10.
#include "rubsweep/ring/closed_forms.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "ring/random_system.hpp"
#include "rubsweep/maps/batch/axis.hpp"
#include "rubsweep/ring/changes.hpp"

namespace rubsweep::ring {
namespace {

/// The paper's ring with random data; all loads are equal.
struct Random {
  RandomSystems source{7, 1};

  System alike(int loads, bool as_beam, double inclination_deg = 0) {
    System system{.ring = paper_ring(), .loads = {}, .friction_coefficient = source.between(0.05, 0.6)};
    system.ring.nodal_diameters = 2 + static_cast<int>(source.between(0, 4));
    system.ring.thickness_ratio = source.between(0, 0.1);
    const double mass = source.between(10, 300), k = source.between(1e5, 5e6), kt = source.between(1e5, 2e6);
    const Load load = as_beam ? beam(mass, 0.6 * mass, k, kt) : spring_mass(mass, k, kt);
    for (int j = 0; j < loads; ++j) {
      system.loads.push_back(at(source.between(0, 360), load));
      system.loads.back().inclination_deg = inclination_deg;
    }
    return system;
  }
};

void expect_all_found(const std::vector<double>& closed_forms, const std::vector<double>& found) {
  for (const double speed : closed_forms) {
    const double error = [&] {
      double least = 1;
      for (const double other : found) least = std::min(least, std::abs(other / speed - 1));
      return least;
    }();
    EXPECT_LT(error, 1e-10) << speed;
  }
}

double nearest_change(const NormalForm& form, double speed) {
  const auto changes = find_changes(form, std::vector<double>{0.99 * speed, 1.013 * speed});
  double best = 0;
  for (const Change& change : changes) {
    if (std::abs(change.speed_rad_per_s - speed) < std::abs(best - speed)) best = change.speed_rad_per_s;
  }
  return best;
}

TEST(ClosedForms, RadialDivergenceOfAnyNumberOfLoads) {
  Random random;
  int without = 0;
  for (int i = 0; i < 200; ++i) {
    System system = random.alike(1 + i % 5, i % 2 == 0);
    for (Load& load : system.loads) load.motion = i % 3 == 0 ? Motion::both : Motion::radial;
    const auto speeds = radial_divergence_speeds(system);
    auto found = divergence_speeds(normal_form(system));
    expect_all_found(speeds, found);
    if (system.loads[0].motion == Motion::radial) {
      EXPECT_EQ(speeds.size(), found.size());
      without += speeds.empty() ? 1 : 0;
    }
  }
  EXPECT_GT(without, 5);
}

TEST(ClosedForms, OneRadialLoadDivergesBetweenOmegaCAndOmegaC2) {
  System system = spring_masses({33});
  system.loads[0].motion = Motion::radial;
  const double a = amplitude_mass_kg(system.ring);
  const auto speeds = radial_divergence_speeds(system);
  ASSERT_EQ(speeds.size(), 2U);
  EXPECT_NEAR(speeds[0], 17.2, 1e-12);
  EXPECT_NEAR(speeds[1], std::sqrt((a * 17.2 * 17.2 + 1e6) / (a + 100)), 1e-12);
}

TEST(ClosedForms, ThePapersCondition3LeavesNoDivergence) {
  EXPECT_TRUE(radial_divergence_speeds(spring_masses({60, 120, 180})).empty());
  // unequal angles
  EXPECT_EQ(radial_divergence_speeds(spring_masses({60, 120, 240})).size(), 2U);
}

TEST(ClosedForms, RadialStabilityWindow) {
  Random random;
  int windows = 0;
  for (int i = 0; i < 60; ++i) {
    System system = random.alike(1, i % 2 == 0);
    system.loads[0].motion = Motion::radial;
    const auto window = radial_stability_window(system.ring, system.loads[0]);
    const NormalForm form = normal_form(system);
    if (!window) continue;
    ++windows;
    for (const double edge : {window->first, window->second}) {
      EXPECT_NEAR(nearest_change(form, edge) / edge, 1, 1e-10);
    }
    // Stable exactly between both speeds, which are Omega_c to Omega_c2 apart; the paper's Omega_c4 does not
    // matter.
    const auto divergence = radial_divergence_speeds(system);
    for (int k = 0; k < 20; ++k) {
      const double speed = random.source.between(0, 1.5) * window->second;
      const bool between = speed > window->first && speed < window->second;
      const bool diverges = speed > divergence[0] && speed < divergence[1];
      EXPECT_EQ(signature(form, speed).stable(), between && !diverges) << speed;
    }
  }
  EXPECT_GT(windows, 20);
}

TEST(ClosedForms, NoRadialWindowWhenTheLoadIsSlow) {
  EXPECT_FALSE(radial_stability_window(paper_ring(), spring_mass(100, 100 * 17.2 * 17.2 * 0.79, 0)));
  EXPECT_TRUE(radial_stability_window(paper_ring(), spring_mass(100, 100 * 17.2 * 17.2 * 0.81, 0)));
  EXPECT_FALSE(radial_stability_window(paper_ring(), spring_mass(0, 1e6, 0)));
}

TEST(ClosedForms, TangentialLoad) {
  Random random;
  for (int i = 0; i < 60; ++i) {
    System system = random.alike(1, i % 2 == 0);
    system.loads[0].motion = Motion::tangential;
    const NormalForm form = normal_form(system);
    const double divergence = tangential_divergence_speed(system.loads[0]);
    expect_all_found({divergence}, divergence_speeds(form));
    EXPECT_NEAR(nearest_change(form, divergence) / divergence, 1, 1e-10);
    const double aperiodic = aperiodic_speed(system.loads[0], system.friction_coefficient);
    EXPECT_NEAR(nearest_change(form, aperiodic) / aperiodic, 1, 1e-10);
    if (i % 2 == 1) {
      EXPECT_NEAR(aperiodic, divergence / std::hypot(1, system.friction_coefficient), 1e-12 * divergence);
    }
  }
}

TEST(ClosedForms, NeutralSpeedsHoldForAnyFrictionPlaceInclinationAndNumberOfLoads) {
  Random random;
  int count = 0;
  for (int i = 0; i < 60; ++i) {
    const System system = random.alike(1 + i % 3, i % 2 == 0, random.source.between(-90, 90));
    for (const NeutralSpeed& neutral : neutral_speeds(system.ring, system.loads[0])) {
      const Eigen::VectorXcd values = eigenvalues(normal_form(system), neutral.speed_rad_per_s);
      const std::complex<double> root(0, neutral.frequency_rad_per_s);
      EXPECT_LT((values.array() - root).abs().minCoeff(), 1e-10 * size_of(values));
      const double n = system.ring.nodal_diameters, critical = critical_speed(system.ring);
      EXPECT_NEAR(neutral.frequency_rad_per_s,
                  n * std::abs(critical + (neutral.forward ? -1 : 1) * neutral.speed_rad_per_s), 1e-9);
      ++count;
    }
  }
  EXPECT_GT(count, 100);
}

TEST(ClosedForms, NeutralSpeedsOfARadialLoadAreItsWindow) {
  Load load = spring_mass(100, 1e6, 0);
  load.motion = Motion::radial;
  const auto window = radial_stability_window(paper_ring(), load);
  const auto neutral = neutral_speeds(paper_ring(), load);
  ASSERT_EQ(neutral.size(), 2U);
  EXPECT_NEAR(neutral[0].speed_rad_per_s, window->first, 1e-12);
  EXPECT_NEAR(neutral[1].speed_rad_per_s, window->second, 1e-12);
}

TEST(ClosedForms, DivergenceOfOneInclinedLoad) {
  Random random;
  for (int i = 0; i < 100; ++i) {
    const System system = random.alike(1, i % 2 == 0, random.source.between(-90, 90));
    const auto speeds = inclined_divergence_speeds(system.ring, system.loads[0], system.friction_coefficient);
    const auto found = divergence_speeds(normal_form(system));
    EXPECT_EQ(speeds.size(), found.size());
    expect_all_found(speeds, found);
  }
}

TEST(ClosedFormsCriticalSpeeds, AreFoundWhereTheClosedFormsSay) {
  for (const std::vector<double>& angles : {std::vector<double>{60}, {60, 120}, {60, 240}}) {
    const System system = spring_masses(angles);
    const auto speeds = batch::evenly_spaced(0.0, 1500 * rpm, 301);
    const auto critical = critical_speeds(system, find_changes(normal_form(system), speeds));
    EXPECT_GE(critical.size(), 6U);
    for (const CriticalSpeed& speed : critical) {
      if (speed.name == "omega_c" && angles.size() == 2) continue;
      ASSERT_TRUE(speed.numeric_rad_per_s) << speed.name;
      EXPECT_NEAR(*speed.numeric_rad_per_s / speed.closed_form_rad_per_s, 1, 1e-10) << speed.name;
    }
  }
}

}  // namespace
}  // namespace rubsweep::ring
