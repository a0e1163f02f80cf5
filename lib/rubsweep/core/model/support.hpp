#pragma once

#include <array>
#include <optional>
#include <string>

#include "rubsweep/core/model/physical_range.hpp"
#include "rubsweep/core/model/range.hpp"
#include "rubsweep/core/model/require.hpp"
#include "rubsweep/core/model/support_table.hpp"

namespace rubsweep::model {

/// Suspension of a support's housing that has a mass of its own.
struct Pedestal {
  double mass_kg = required;
  double stiffness_x_n_per_m = required;
  double stiffness_y_n_per_m = required;
  double damping_x_ns_per_m = 0;
  double damping_y_ns_per_m = 0;

  static void visit_fields(auto& self, auto&& visit) {
    visit("mass_kg", self.mass_kg, physical::moving_mass_kg);
    visit("stiffness_x_n_per_m", self.stiffness_x_n_per_m, physical::holding_stiffness);
    visit("stiffness_y_n_per_m", self.stiffness_y_n_per_m, physical::holding_stiffness);
    visit("damping_x_ns_per_m", self.damping_x_ns_per_m, physical::damping);
    visit("damping_y_ns_per_m", self.damping_y_ns_per_m, physical::damping);
  }
};

/// Defect of a bearing that strikes the shaft (and its pedestal, the other way) once every time it is rolled
/// over: impulses `multiple` times per revolution, the first one phase_deg / 360 of the time between two
/// after the start of the run.
struct BearingFault {
  double impulse_ns = required;
  double multiple = required;
  double angle_deg = 0;  ///< direction of the impulse on the shaft, from +x towards +y; does not turn
  double phase_deg = 0;

  static constexpr double most_per_revolution = 1000;

  static void visit_fields(auto& self, auto&& visit) {
    visit("impulse_ns", self.impulse_ns, physical::impulse_ns);
    visit("multiple", self.multiple, Range{.low = 0, .high = most_per_revolution, .low_open = true});
    visit("angle_deg", self.angle_deg, any_finite);
    visit("phase_deg", self.phase_deg, Range{.low = 0, .high = 360, .high_open = true});
  }
};

/// Bearing between the shaft and the ground, a pedestal or a housing. Force on the shaft:
/// f_x = -(stiffness_x x + stiffness_xy y) - the same with damping - mass_x x''; f_y with yx and y.
/// Coefficients may be negative, as those of a seal, while all supports together hold the shaft. One at a
/// housing holds that in place of the shaft.
struct Support {
  double position_m = required;  ///< nothing where the support is at a housing
  std::optional<int> at_housing = std::nullopt;
  std::optional<int> on_housing = std::nullopt;  ///< empty: it stands on the ground, or its pedestal
  double stiffness_x_n_per_m = required;
  double stiffness_y_n_per_m = required;
  double stiffness_xy_n_per_m = 0;
  double stiffness_yx_n_per_m = 0;
  double damping_x_ns_per_m = 0;
  double damping_y_ns_per_m = 0;
  double damping_xy_ns_per_m = 0;
  double damping_yx_ns_per_m = 0;
  double mass_x_kg = 0;  ///< fluid that moves with the shaft against the ground or the pedestal
  double mass_y_kg = 0;
  double angular_stiffness_nm_per_rad = 0;  ///< against tilting of the shaft, always to the ground
  std::optional<Pedestal> pedestal;
  std::optional<BearingFault> fault;
  /// Curves that the coefficients above follow over the speed; they are then those of one of its speeds
  /// (with_table).
  std::optional<SupportTable> table;
  std::string name;  ///< name of the element in the file it was read from; for messages

  static void visit_fields(auto& self, auto&& visit) {
    visit("position_m", self.position_m, not_negative);
    visit("stiffness_x_n_per_m", self.stiffness_x_n_per_m, physical::cross_stiffness);
    visit("stiffness_y_n_per_m", self.stiffness_y_n_per_m, physical::cross_stiffness);
    visit("stiffness_xy_n_per_m", self.stiffness_xy_n_per_m, physical::cross_stiffness);
    visit("stiffness_yx_n_per_m", self.stiffness_yx_n_per_m, physical::cross_stiffness);
    visit("damping_x_ns_per_m", self.damping_x_ns_per_m, physical::cross_damping);
    visit("damping_y_ns_per_m", self.damping_y_ns_per_m, physical::cross_damping);
    visit("damping_xy_ns_per_m", self.damping_xy_ns_per_m, physical::cross_damping);
    visit("damping_yx_ns_per_m", self.damping_yx_ns_per_m, physical::cross_damping);
    visit("mass_x_kg", self.mass_x_kg, physical::added_mass_kg);
    visit("mass_y_kg", self.mass_y_kg, physical::added_mass_kg);
    visit("angular_stiffness_nm_per_rad", self.angular_stiffness_nm_per_rad, physical::stiffness);
  }
};

/// Sets the coefficients of a support, in the order of support_coefficients.
void set_coefficients(Support& support, const std::array<double, support_coefficients.size()>& values);

/// The support with this table, its own coefficients those of the middle speed, which stand for it where one
/// speed has to: in the shapes that span the motion at all speeds.
Support with_table(Support support, SupportTable table);

/// Problem of a support that is at or on a housing beside things that exclude it. Empty: none.
std::optional<PartProblem> housing_problem(const Support& support);

}  // namespace rubsweep::model
