#include "rubsweep/core/structure/assembly.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <optional>
#include <vector>

#include "core/scene/table_machine.hpp"
#include "maps/batch/message_of.hpp"
#include "rubsweep/core/error.hpp"
#include "rubsweep/core/numerics/dense/factors.hpp"
#include "rubsweep/core/structure/kit_assembly.hpp"
#include "rubsweep/core/structure/stability.hpp"

namespace rubsweep::structure {
namespace {

Assembly jeffcott(double mass_kg, double natural_frequency_hz, double casing_mass_kg = 0.05) {
  return assemble_jeffcott({mass_kg, natural_frequency_hz, 0.02}, {model::Casing{casing_mass_kg, 5e5, 0.1}});
}

TEST(AssemblyRefuseUnusable, TakesWhatCanBeComputed) {
  EXPECT_NO_THROW(refuse_unusable(jeffcott(0.8, 30)));
  // Separate bodies may have very different masses.
  EXPECT_NO_THROW(refuse_unusable(jeffcott(1e9, 30, 1e-9)));
}

TEST(AssemblyRefuseUnusable, NumbersThatOverflow) {
  const auto message = [](const Assembly& assembly) {
    return message_of<ConfigError>([&] { refuse_unusable(assembly); });
  };
  EXPECT_NE(message(jeffcott(1e300, 1e100)).find("no finite number, allowed: less extreme ones"),
            std::string::npos);
  Assembly assembly = jeffcott(0.8, 30);
  assembly.bow_n = Eigen::VectorXcd::Constant(4, std::numeric_limits<double>::quiet_NaN());
  EXPECT_NE(message(assembly).find("no finite number"), std::string::npos);
  assembly = jeffcott(0.8, 30);
  assembly.system.mass(0, 0) = 0;
  EXPECT_NE(message(assembly).find("motion without mass, allowed:"), std::string::npos);
}

using std::numbers::pi;

/// Unbalance response at the stop's position, x and y.
Eigen::Vector2cd response_of(const Assembly& assembly, double speed_rad_per_s) {
  const LinearSystem system = system_at(assembly, speed_rad_per_s);
  const std::complex<double> i(0, 1);
  const Eigen::MatrixXcd dynamic = (system.stiffness - speed_rad_per_s * speed_rad_per_s * system.mass) +
                                   i * speed_rad_per_s * system.damping;
  const auto& map = system.points[static_cast<std::size_t>(assembly.rotor_points[0])].map;
  return map.cast<std::complex<double>>() *
         numerics::dense::solve(dynamic,
                                Eigen::VectorXcd(speed_rad_per_s * speed_rad_per_s * system.unbalance_kg));
}

/// The machine without its modal damping, which refers to other modes at every speed.
model::Machine without_modal_damping(model::Machine machine) {
  model::kit_of(machine)->damping_ratio = {0};
  return machine;
}

/// A fixed set of mode shapes must give the same response as the shapes of each speed.
TEST(AssemblySystemAt, AnswersAsAMachineThatIsBuiltForTheSpeed) {
  const Assembly all_speeds = assemble_rotor_kit(without_modal_damping(scene::table_machine(4))).assembly;
  for (std::size_t row = 0; row < scene::table_speeds_hz.size(); ++row) {
    const double w = 2 * pi * scene::table_speeds_hz[row];
    const model::Machine typed = without_modal_damping(scene::typed_machine(row, 6));
    const Eigen::Vector2cd found = response_of(all_speeds, w),
                           expected = response_of(assemble_rotor_kit(typed).assembly, w);
    EXPECT_LT((found - expected).norm(), 2e-4 * expected.norm()) << row;
  }
}

/// A short stiff rotor on two equal films: m z'' + 2 c z' + 2 (k - i q) z = m e w^2 e^{iwt}, z = x + i y,
/// with the cross stiffnesses kxy = q = -kyx.
TEST(AssemblySystemAt, ShortRotorIsTheClosedFormAtEverySpeed) {
  model::Machine machine = scene::table_machine(2);
  model::RotorKit& kit = *model::kit_of(machine);
  kit.shaft[0].outer_diameter_m = 0.2;
  kit.shaft[0].length_m = 0.4;
  kit.shaft[0].density_kg_per_m3 = 1;
  kit.damping_ratio = {0};
  model::SupportTable table = scene::film_table();
  table.columns[3] = table.columns[0];
  table.columns[7] = table.columns[4];
  for (std::size_t k = 0; k < 5; ++k) {
    table.columns[2][k] = -table.columns[1][k];
    table.columns[5][k] = table.columns[6][k] = 0;
  }
  for (model::Support& support : kit.supports) support = model::with_table(support, table);
  const Assembly assembly = assemble_rotor_kit(machine).assembly;
  const double mass_kg = 0.8 + pi / 4 * 0.2 * 0.2 * 0.4;
  const SupportCurves curves = curves_of(table);
  for (const double hz : {20.0, 27.3, 40.0, 66.6, 101.0, 120.0}) {
    const double w = 2 * pi * hz;
    const std::complex<double> i(0, 1);
    const std::complex<double> expected =
        0.8 * w * w /
        (2.0 * (curves[0](hz) - i * curves[1](hz)) + i * w * 2.0 * curves[4](hz) - w * w * mass_kg);
    const Eigen::Vector2cd found = response_of(assembly, w);
    EXPECT_LT(std::abs(found(0) - expected), 1e-4 * std::abs(expected)) << hz;
    EXPECT_LT(std::abs(found(1) + i * expected), 1e-4 * std::abs(expected)) << hz;
    // Eigenvalue r from m r^2 + 2 c r + 2 (k - i q) = 0.
    const std::complex<double> half = curves[4](hz) / mass_kg;
    const std::complex<double> root =
        std::sqrt(half * half - 2.0 * (curves[0](hz) - i * curves[1](hz)) / mass_kg);
    const double growth = std::max((-half + root).real(), (-half - root).real());
    EXPECT_NEAR(growth_per_s(assembly, w), growth, 1e-3 * std::abs(growth)) << hz;
  }
}

using Casings = std::vector<std::optional<model::Casing>>;

const model::JeffcottRotor rotor{.mass_kg = 0.8, .natural_frequency_hz = 30, .damping_ratio = 0.02};
const model::Casing first{.mass_kg = 0.05, .stiffness_n_per_m = 5e5, .damping_ratio = 0.1};
const model::Casing second{.mass_kg = 0.03, .stiffness_n_per_m = 1.18e6, .damping_ratio = 0};

/// Expects a diagonal matrix with these entries.
void expect_diagonal(const Eigen::MatrixXd& matrix, const std::vector<double>& diagonal) {
  const auto n = static_cast<Eigen::Index>(diagonal.size());
  ASSERT_EQ(matrix.rows(), n);
  ASSERT_EQ(matrix.cols(), n);
  for (Eigen::Index row = 0; row < n; ++row) {
    for (Eigen::Index column = 0; column < n; ++column) {
      if (row == column) {
        EXPECT_DOUBLE_EQ(matrix(row, column), diagonal[static_cast<std::size_t>(row)]);
      } else {
        EXPECT_EQ(matrix(row, column), 0) << row << ", " << column;
      }
    }
  }
}

/// Expects the point to move with coordinates `x` and `x + 1` only.
void expect_point_at(const Point& point, Eigen::Index x, Eigen::Index n) {
  ASSERT_EQ(point.map.cols(), n);
  for (Eigen::Index column = 0; column < n; ++column) {
    EXPECT_EQ(point.map(0, column), column == x ? 1 : 0);
    EXPECT_EQ(point.map(1, column), column == x + 1 ? 1 : 0);
  }
}

TEST(AssemblyJeffcott, EveryEntryOfTheMatrices) {
  const LinearSystem system = assemble_jeffcott(rotor, {first, std::nullopt, second}).system;
  EXPECT_EQ(system.coordinates(), 6);
  expect_diagonal(system.mass, {0.8, 0.8, 0.05, 0.05, 0.03, 0.03});
  // m (2 pi f)^2 and 2 zeta m 2 pi f for the rotor, 2 zeta sqrt(k m) for the casings; digits by hand.
  expect_diagonal(system.stiffness, {28424.460675137347, 28424.460675137347, 5e5, 5e5, 1.18e6, 1.18e6});
  expect_diagonal(system.damping,
                  {6.031857894892402, 6.031857894892402, 31.622776601683796, 31.622776601683796, 0, 0});
}

TEST(AssemblyJeffcott, PointsFollowTheStopsAndRigidCasingsHaveNone) {
  const Assembly assembly = assemble_jeffcott(rotor, {first, std::nullopt, second});
  const LinearSystem& system = assembly.system;
  const auto& casing_points = assembly.casing_points;
  ASSERT_EQ(casing_points.size(), 3u);
  EXPECT_FALSE(casing_points[1]);
  ASSERT_EQ(system.points.size(), 3u);
  EXPECT_EQ(assembly.rotor_points, std::vector<int>(3, 0));
  EXPECT_EQ(assembly.contact_mass_kg, std::vector<double>(3, 0.8));
  expect_point_at(system.points[0], 0, 6);
  expect_point_at(system.points[static_cast<std::size_t>(casing_points[0].value())], 2, 6);
  expect_point_at(system.points[static_cast<std::size_t>(casing_points[2].value())], 4, 6);
}

TEST(AssemblyJeffcott, RigidCasingsHaveNoState) {
  for (const Casings& casings : {Casings{}, Casings{std::nullopt}, Casings{std::nullopt, std::nullopt}}) {
    const Assembly assembly = assemble_jeffcott(rotor, casings);
    EXPECT_EQ(assembly.system.coordinates(), 2);
    EXPECT_EQ(assembly.system.points.size(), 1u);
    EXPECT_EQ(assembly.casing_points, std::vector<std::optional<int>>(casings.size()));
  }
}

TEST(AssemblyJeffcott, FreeRotorDecaysAtItsFrequencyAndDampingRatio) {
  // Root of m s^2 + c s + k: -zeta w0 +- i w0 sqrt(1 - zeta^2).
  const LinearSystem system = assemble_jeffcott(rotor, {}).system;
  const double m = system.mass(0, 0), c = system.damping(0, 0), k = system.stiffness(0, 0);
  const std::complex<double> root = (-c + std::sqrt(std::complex<double>(c * c - 4 * m * k))) / (2 * m);
  EXPECT_NEAR(std::abs(root) / (2 * std::numbers::pi), 30, 1e-12);
  EXPECT_NEAR(-root.real() / std::abs(root), 0.02, 1e-15);
}

TEST(AssemblyJeffcott, UnbalanceTurnsFromXTowardsYWithForceMassTimesEccentricityTimesSpeedSquared) {
  const LinearSystem system = assemble_jeffcott(rotor, {first}).system;
  const double e = 3e-4, w = 471;
  for (const double phase : {0.0, 0.3, 1.9, 4.4}) {
    const Eigen::VectorXd force = e * w * w * (system.unbalance_kg * std::polar(1.0, phase)).real();
    const double centrifugal = rotor.mass_kg * e * w * w;
    EXPECT_NEAR(force(0), centrifugal * std::cos(phase), 1e-12 * centrifugal);
    EXPECT_NEAR(force(1), centrifugal * std::sin(phase), 1e-12 * centrifugal);
    EXPECT_EQ(force.tail(2), Eigen::Vector2d::Zero());
  }
}

TEST(AssemblyJeffcott, WeightActsOnRotorAndMovingCasingsAlongMinusY) {
  const LinearSystem system = assemble_jeffcott(rotor, {first, std::nullopt, second}).system;
  Eigen::VectorXd weight(6);
  weight << 0, -0.8, 0, -0.05, 0, -0.03;
  EXPECT_EQ(system.weight_kg, weight);
}

}  // namespace

}  // namespace rubsweep::structure
