#include "rubsweep/response/rotating/rotating_equilibrium.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <numbers>

#include "rubsweep/integrate/run/scaled_system.hpp"
#include "rubsweep/numerics/dense/eigenvalues.hpp"
#include "rubsweep/numerics/matrix_flow.hpp"
#include "rubsweep/response/proof/section_map.hpp"
#include "rubsweep/response/rotating/rotating_frame.hpp"
#include "support/annular_scene.hpp"

namespace rubsweep::response::rotating {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

TEST(RotatingEquilibriumFind, FullAnnularRubAndTheMultiplierOfItsSection) {
  const test::FullRub rub;
  const auto scene = rub.scene();
  const RotatingField field(scene, {});
  integrate::run::SolverOptions solver;
  solver.relative_tolerance = 1e-11;
  integrate::exact::modes::ModeCache modes;
  proof::SceneMap map(scene, solver, modes);
  const auto on_circle = integrate::run::scaled_initial_state(scene);
  const VectorXd exact = Eigen::Map<const VectorXd>(on_circle.data(), 4);
  VectorXd before = exact;
  before(0) += 0.01;
  VectorXd now = before;
  ASSERT_TRUE(map({now.data(), 4}));
  const auto circle = find_rotating_equilibrium({[&](const VectorXd& y) { return field.rate(y); },
                                                 [&](const VectorXd& y) { return field.jacobian(y); }},
                                                now);
  ASSERT_TRUE(circle);
  EXPECT_LT((circle->state - exact).cwiseAbs().maxCoeff(), 1e-12);
  auto section = on_circle;
  MatrixXd monodromy = MatrixXd::Identity(4, 4);
  ASSERT_TRUE(map.carry(section, monodromy));
  EXPECT_NEAR(circle->floquet_modulus, numerics::dense::spectral_radius(monodromy), 1e-6);
}

/// y' = A (y - 1) + quadratic: a focus that the sign of `damping` makes stable.
RotatingEquations focus(double damping) {
  const MatrixXd a{{-damping, 1}, {-1, -damping}};
  return {[a](const VectorXd& y) -> VectorXd {
            const VectorXd d = y - VectorXd::Ones(2);
            return a * d + d.squaredNorm() * VectorXd::Unit(2, 0);
          },
          [a](const VectorXd& y) -> MatrixXd {
            const VectorXd d = y - VectorXd::Ones(2);
            return a + 2 * VectorXd::Unit(2, 0) * d.transpose();
          }};
}

TEST(RotatingEquilibriumFind, FindsAStablePointWithItsModulus) {
  const VectorXd start{{1.02, 0.99}};
  const auto circle = find_rotating_equilibrium(focus(0.1), start);
  ASSERT_TRUE(circle);
  EXPECT_LT((circle->state - VectorXd::Ones(2)).norm(), 1e-12);
  EXPECT_NEAR(circle->floquet_modulus, std::exp(-0.2 * std::numbers::pi), 1e-12);
  EXPECT_NEAR(numerics::dense::spectral_radius(circle->transition), circle->floquet_modulus, 1e-12);
}

TEST(RotatingEquilibriumFind, RefusesAnUnstablePoint) {
  const VectorXd start{{1.002, 0.999}};
  EXPECT_FALSE(find_rotating_equilibrium(focus(-0.1), start));
  EXPECT_FALSE(find_rotating_equilibrium(focus(1e-9), start));
}

TEST(RotatingEquilibriumFind, RefusesAPointFarAway) {
  const VectorXd start{{1.3, 1}};
  EXPECT_FALSE(find_rotating_equilibrium(focus(0.1), start));
}

}  // namespace
}  // namespace rubsweep::response::rotating
