#include "rubsweep/core/structure/reduction.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

#include "core/structure/steel.hpp"
#include "rubsweep/core/numerics/dense/factors.hpp"

namespace rubsweep::structure {
namespace {

using std::numbers::pi;

/// A small rotor kit: a shaft of 10 mm, one disc, a stop beside it, and a sensor on the far side.
model::RotorKit small_kit() {
  model::RotorKit kit;
  kit.shaft = {steel_segment(0.5, 0.01)};
  kit.discs = {
      {.position_m = 0.25, .mass_kg = 0.8, .polar_inertia_kg_m2 = 5.6e-4, .diametral_inertia_kg_m2 = 3.3e-4}};
  kit.supports = {isotropic_support(0.02, 1e5), isotropic_support(0.48, 1e5)};
  for (auto& support : kit.supports) support.damping_x_ns_per_m = support.damping_y_ns_per_m = 20;
  kit.damping_ratio = {0.02, 0.01};
  kit.elements = 12;
  return kit;
}

const std::vector<double> stops{0.33, 0.36}, sensors{0.15};

PlaneBases identity(const BeamShaft& shaft) {
  const Eigen::MatrixXd one = Eigen::MatrixXd::Identity(shaft.coordinates(), shaft.coordinates());
  return {one, one};
}

/// Displacements (rows) at `responses_m` due to harmonic unit forces (columns) at `forces_m`, in m/N; x and y
/// at each position, x first. Matrix: (stiffness + i w (damping + speed gyroscopic) - w^2 mass)^-1.
Eigen::MatrixXcd receptance(const BeamShaft& shaft, const PlaneBases& bases, const LateralSystem& system,
                            double rad_per_s, double speed_rad_per_s, const std::vector<double>& responses_m,
                            const std::vector<double>& forces_m) {
  const auto rows = [&](const std::vector<double>& places) {
    Eigen::MatrixXd seen(static_cast<Eigen::Index>(2 * places.size()), system.coordinates());
    for (std::size_t i = 0; i < places.size(); ++i) {
      for (std::size_t plane = 0; plane < 2; ++plane) {
        seen.row(static_cast<Eigen::Index>(2 * i + plane)) =
            system.scatter(plane, bases[plane].row(shaft.deflection(places[i])).transpose()).transpose();
      }
    }
    return seen;
  };
  const std::complex<double> i(0, 1);
  Eigen::MatrixXcd dynamic =
      (system.stiffness - rad_per_s * rad_per_s * system.mass).cast<std::complex<double>>();
  dynamic += i * rad_per_s * (system.damping + speed_rad_per_s * system.gyroscopic);
  const Eigen::MatrixXcd forces = rows(forces_m).transpose().cast<std::complex<double>>();
  return rows(responses_m).cast<std::complex<double>>() * numerics::dense::solve(dynamic, forces);
}

TEST(Reduction, StaticComplianceBetweenStopsIsExactWithAnyNumberOfModes) {
  model::RotorKit kit = small_kit();
  kit.supports[1].stiffness_y_n_per_m = 3e4;
  const BeamShaft shaft = assemble_beam_shaft(kit, {stops[0], stops[1], sensors[0]});
  const auto full = receptance(shaft, identity(shaft), project(shaft, identity(shaft)), 0, 0, stops, stops);
  for (const int modes : {1, 2, 5}) {
    kit.modes = modes;
    const Reduction reduction = reduce(shaft, kit, stops, sensors);
    EXPECT_FALSE(reduction.automatic);
    EXPECT_EQ(reduction.mode_number[0].size(), static_cast<std::size_t>(modes));
    EXPECT_EQ(reduction.bases[0].cols(), modes + 2);
    const auto found =
        receptance(shaft, reduction.bases, reduced_system(shaft, kit, reduction), 0, 0, stops, stops);
    EXPECT_LT((found - full).norm(), 1e-9 * full.norm()) << modes;
  }
}

TEST(Reduction, KeptModesKeepTheirFrequenciesAndTheBasisIsDiagonal) {
  model::RotorKit kit = small_kit();
  kit.modes = 3;
  const BeamShaft shaft = assemble_beam_shaft(kit, {stops[0], stops[1], sensors[0]});
  const PlaneModes modes = plane_modes(shaft.mass, shaft.plane_stiffness(0), 3);
  const Reduction reduction = reduce(shaft, kit, stops, sensors);
  for (Eigen::Index j = 0; j < 3; ++j) {
    EXPECT_NEAR(reduction.frequency_hz[0](j), modes.rad_per_s(j) / (2 * pi), 1e-9 * modes.rad_per_s(j));
  }
  EXPECT_GT(reduction.frequency_hz[0](3), reduction.frequency_hz[0](2));  // an attachment mode is stiffer
  const LateralSystem system = project(shaft, reduction.bases);
  for (const Eigen::MatrixXd* matrix : {&system.mass, &system.stiffness}) {
    Eigen::MatrixXd scaled = *matrix;
    const Eigen::VectorXd root = matrix->diagonal().cwiseSqrt().cwiseInverse();
    scaled = root.asDiagonal() * scaled * root.asDiagonal();
    EXPECT_LT((scaled - Eigen::MatrixXd::Identity(10, 10)).norm(), 1e-8);
  }
}

TEST(Reduction, AutomaticNumberOfModesAnswersAsTheFullModel) {
  const model::RotorKit kit = small_kit();
  const BeamShaft shaft = assemble_beam_shaft(kit, {stops[0], stops[1], sensors[0]});
  const Reduction reduction = reduce(shaft, kit, stops, sensors);
  EXPECT_TRUE(reduction.automatic);
  EXPECT_LE(reduction.receptance_error, receptance_tolerance);
  const auto kept = reduction.mode_number[0].size();
  EXPECT_GE(kept, 3U);
  EXPECT_LE(kept, 12U);
  // Compares with the full finite-element model between resonances; modal damping of this small size matters
  // only near peaks.
  model::RotorKit undamped = kit;
  undamped.damping_ratio = {0};
  const LateralSystem full = project(shaft, identity(shaft)),
                      small = reduced_system(shaft, undamped, reduction);
  for (const double hz : {5.0, 61.0, 171.0, 777.0, 1234.0, 1907.0}) {
    for (const double speed : {0.0, 2 * pi * hz}) {
      const auto exact = receptance(shaft, identity(shaft), full, 2 * pi * hz, speed, sensors, stops);
      const auto found = receptance(shaft, reduction.bases, small, 2 * pi * hz, speed, sensors, stops);
      EXPECT_LT((found - exact).norm(), 0.05 * exact.norm()) << hz << " Hz, speed " << speed;
    }
  }
}

TEST(Reduction, OneModeFewerIsNotEnough) {
  model::RotorKit kit = small_kit();
  const BeamShaft shaft = assemble_beam_shaft(kit, {stops[0], stops[1], sensors[0]});
  kit.modes = static_cast<int>(reduce(shaft, kit, stops, sensors).mode_number[0].size()) - 1;
  EXPECT_GT(reduce(shaft, kit, stops, sensors).receptance_error, receptance_tolerance);
}

TEST(Reduction, LeavesOutModesThatNoStopOrSensorSees) {
  // Everything is in the middle of a symmetric rotor: the antisymmetric modes 2, 4, ... are never excited.
  model::RotorKit kit = small_kit();
  kit.modes = 3;
  const std::vector<double> middle{0.25};
  const BeamShaft shaft = assemble_beam_shaft(kit, {});
  const Reduction reduction = reduce(shaft, kit, middle, middle);
  EXPECT_EQ(reduction.mode_number[0], (std::vector<int>{1, 3, 5}));
}

TEST(Reduction, StopsAtOnePlaceShareTheirAttachmentMode) {
  model::RotorKit kit = small_kit();
  kit.modes = 2;
  const BeamShaft shaft = assemble_beam_shaft(kit, {0.33});
  EXPECT_EQ(reduce(shaft, kit, {0.33, 0.33}, {}).bases[1].cols(), 3);
}

TEST(Reduction, ModalMassDoesNotVanishAsModesAreAdded) {
  model::RotorKit kit = small_kit();
  const BeamShaft shaft = assemble_beam_shaft(kit, {stops[0], stops[1], sensors[0]});
  kit.modes = 1;
  const double few = modal_mass_kg(shaft, reduce(shaft, kit, stops, sensors), 0, 0, stops[0]);
  kit.modes = 8;
  const double many = modal_mass_kg(shaft, reduce(shaft, kit, stops, sensors), 0, 0, stops[0]);
  EXPECT_NEAR(few, many, 1e-9 * few);
  EXPECT_GT(few, 0.8);  // about the mass of the disc where it sits, more off the middle
}

TEST(Reduction, StructuralDampingIsThatOfEachMode) {
  model::RotorKit kit = small_kit();
  for (auto& support : kit.supports) support.damping_x_ns_per_m = support.damping_y_ns_per_m = 0;
  kit.modes = 3;
  const BeamShaft shaft = assemble_beam_shaft(kit, {stops[0], stops[1], sensors[0]});
  const Reduction reduction = reduce(shaft, kit, stops, sensors);
  const LateralSystem system = reduced_system(shaft, kit, reduction);
  const double expected[] = {0.02, 0.01, 0.01, 0.01, 0.01};
  for (Eigen::Index j = 0; j < 5; ++j) {
    const Eigen::Index i = system.index(0, j);
    const double ratio = system.damping(i, i) / (2 * std::sqrt(system.stiffness(i, i) * system.mass(i, i)));
    EXPECT_NEAR(ratio, expected[j], 1e-9) << j;
  }
}

}  // namespace

}  // namespace rubsweep::structure
