#include "rubsweep/core/response/rotating/symmetry.hpp"

#include <gtest/gtest.h>

#include <complex>

#include "core/response/annular_cell.hpp"
#include "core/scene/one_side_machine.hpp"
#include "rubsweep/core/integrate/adaptive/start_adaptive.hpp"
#include "rubsweep/core/response/proof/section_map.hpp"

namespace rubsweep::response::testing {
namespace {

TEST(SymmetryRotationallySymmetric, ARotorInCentredRings) {
  EXPECT_TRUE(rotating::rotationally_symmetric(annular_cell(110, 0.4).scene));
  EXPECT_TRUE(rotating::rotationally_symmetric(annular_cell(110, 0).scene));
  auto machine = annular_machine();
  machine.stops.push_back(machine.stops.front());
  machine.stops.back().casing.reset();
  EXPECT_TRUE(
      rotating::rotationally_symmetric(scene::build_cell(machine, 77.7, scene::WhirlRatio{0.3}).scene));
}

TEST(SymmetryRotationallySymmetric, NotWithAnOffsetAFlatWallOrGravity) {
  EXPECT_FALSE(rotating::rotationally_symmetric(annular_cell(110, 0.4, 1e-9).scene));
  EXPECT_FALSE(rotating::rotationally_symmetric(
      scene::build_cell(scene::one_side_machine(), 75, scene::WhirlRatio{0.4}).scene));
  auto machine = annular_machine();
  machine.gravity_m_per_s2 = 1e-6;
  EXPECT_FALSE(
      rotating::rotationally_symmetric(scene::build_cell(machine, 110, scene::WhirlRatio{0.4}).scene));
  machine.gravity_m_per_s2 = 0;
  machine.stops.push_back(scene::one_side_machine().stops.front());
  EXPECT_FALSE(
      rotating::rotationally_symmetric(scene::build_cell(machine, 110, scene::WhirlRatio{0.4}).scene));
}

TEST(SymmetryRotationallySymmetric, NotWithAnAnisotropicStructureOrForcing) {
  const auto without = [](auto&& change) {
    auto scene = annular_cell(110, 0.4).scene;
    change(scene);
    return rotating::rotationally_symmetric(scene);
  };
  EXPECT_FALSE(without([](auto& s) { s.structure.stiffness(1, 1) *= 1 + 1e-12; }));
  EXPECT_FALSE(without([](auto& s) { s.structure.damping(2, 2) *= 2; }));
  EXPECT_FALSE(without([](auto& s) { s.structure.mass(0, 1) = 1e-9; }));
  EXPECT_FALSE(without([](auto& s) { s.structure.points[0].map(0, 0) = 0.5; }));
  EXPECT_FALSE(without([](auto& s) { s.harmonic_n(1) *= 0.99; }));
  EXPECT_FALSE(without([](auto& s) { s.second_harmonic_n = 1e-9 * s.harmonic_n; }));
  EXPECT_FALSE(without([](auto& s) { s.impulses.push_back({Eigen::Vector4d(1, 0, 0, 0), 2, 0}); }));
  EXPECT_FALSE(without([](auto& s) { s.harmonic_n = s.harmonic_n.conjugate().eval(); }));
  // Gyroscopic and cross-coupled terms turn with the frame.
  EXPECT_TRUE(without([](auto& s) {
    s.structure.damping(0, 1) = 0.3;
    s.structure.damping(1, 0) = -0.3;
    s.structure.stiffness(2, 1) = 5;
    s.structure.stiffness(3, 0) = -5;
  }));
}

/// Section of a scene, turned by 30 degrees, and one turn of motion: which comes first must not matter.
double turning_first_and_last_differ_by(const scene::Scene& scene) {
  const auto turned = [](std::vector<double> section) {
    for (std::size_t i = 0; i + 1 < section.size(); i += 2) {
      const auto z = std::complex<double>(section[i], section[i + 1]) * std::polar(1.0, 0.5);
      section[i] = z.real();
      section[i + 1] = z.imag();
    }
    return section;
  };
  auto unforced = scene;
  unforced.harmonic_n.setZero();
  integrate::run::SolverOptions solver;
  solver.relative_tolerance = 1e-10;
  integrate::exact::modes::ModeCache modes;
  proof::SceneMap map(unforced, solver, modes);
  std::vector<double> first{0.9, 0.2, 0, 0, 0.3, -0.4, 0.1, 0};
  auto last = turned(first);
  map(last);
  map(first);
  EXPECT_TRUE(map.touched());
  first = turned(first);
  double largest = 0;
  for (std::size_t i = 0; i < first.size(); ++i) largest = std::max(largest, std::abs(first[i] - last[i]));
  return largest;
}

TEST(SymmetryRotationallySymmetric, IsWhatTheMotionShows) {
  EXPECT_LT(turning_first_and_last_differ_by(annular_cell(110, 0.4).scene), 1e-7);
  EXPECT_GT(turning_first_and_last_differ_by(annular_cell(110, 0.4, 1e-4).scene), 1e-3);
}

}  // namespace
}  // namespace rubsweep::response::testing
