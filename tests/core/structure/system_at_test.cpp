#include "rubsweep/core/structure/system_at.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <complex>
#include <numbers>

#include "core/scene/table_machine.hpp"
#include "rubsweep/core/numerics/dense/lu.hpp"
#include "rubsweep/core/structure/kit_assembly.hpp"
#include "rubsweep/core/structure/stability.hpp"

namespace rubsweep::structure {
namespace {

using std::numbers::pi;

/// Unbalance response of the stop's place, x and y.
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

/// The machine without the damping that is said by modes, which are others at every speed.
model::Machine without_modal_damping(model::Machine machine) {
  model::kit_of(machine)->damping_ratio = {0};
  return machine;
}

/// One set of shapes for all speeds must answer as the shapes of each speed do.
TEST(SystemAt, AnswersAsAMachineThatIsBuiltForTheSpeed) {
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
/// where kxy = q = -kyx.
TEST(SystemAt, ShortRotorIsTheClosedFormAtEverySpeed) {
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
    // Whirl r of m r^2 + 2 c r + 2 (k - i q) = 0.
    const std::complex<double> half = curves[4](hz) / mass_kg;
    const std::complex<double> root =
        std::sqrt(half * half - 2.0 * (curves[0](hz) - i * curves[1](hz)) / mass_kg);
    const double growth = std::max((-half + root).real(), (-half - root).real());
    EXPECT_NEAR(growth_per_s(assembly, w), growth, 1e-3 * std::abs(growth)) << hz;
  }
}

}  // namespace
}  // namespace rubsweep::structure
