#pragma once

#include <array>
#include <optional>
#include <string>

#include "rubsweep/core/model/key.hpp"
#include "rubsweep/core/model/physical_range.hpp"
#include "rubsweep/core/model/range.hpp"
#include "rubsweep/core/model/require.hpp"
#include "rubsweep/core/model/support_table.hpp"

namespace rubsweep::model {

/// Pedestal: the bearing housing of one support, with a mass of its own and a mount.
struct Pedestal {
  double mass_kg = required;
  double stiffness_x_n_per_m = required;
  double stiffness_y_n_per_m = required;
  double damping_x_ns_per_m = 0;
  double damping_y_ns_per_m = 0;

  static void visit_fields(auto& self, auto&& visit) {
    visit("mass_kg", self.mass_kg, key(physical::moving_mass_kg, "mass of the housing"));
    visit("stiffness_x_n_per_m", self.stiffness_x_n_per_m,
          key(physical::holding_stiffness, "stiffness of its mount in x"));
    visit("stiffness_y_n_per_m", self.stiffness_y_n_per_m,
          key(physical::holding_stiffness, "stiffness of its mount in y"));
    visit("damping_x_ns_per_m", self.damping_x_ns_per_m, key(physical::damping, "damping of its mount in x"));
    visit("damping_y_ns_per_m", self.damping_y_ns_per_m, key(physical::damping, "damping of its mount in y"));
  }
};

/// Bearing defect that strikes the shaft each time it is rolled over (and its pedestal with the opposite
/// impulse). There are `multiple` impulses per revolution. The time from the start of the run to the first
/// one is phase_deg / 360 of the interval between two impulses.
struct BearingFault {
  double impulse_ns = required;
  double multiple = required;
  double angle_deg = 0;  ///< direction of the impulse on the shaft, from +x towards +y; fixed in space
  double phase_deg = 0;

  static constexpr double most_per_revolution = 1000;

  static void visit_fields(auto& self, auto&& visit) {
    visit("impulse_ns", self.impulse_ns, key(physical::impulse_ns, "impulse of each strike on the shaft"));
    visit("multiple", self.multiple,
          key(Range{.low = 0, .high = most_per_revolution, .low_open = true}, "strikes per revolution"));
    visit("angle_deg", self.angle_deg,
          key(any_finite, "direction of the strikes from +x towards +y; it does not turn"));
    visit("phase_deg", self.phase_deg,
          key(Range{.low = 0, .high = 360, .high_open = true},
              "when the first strike comes, as a share of 360 of the time between two"));
  }
};

/// Bearing between the shaft and the ground, a pedestal or a housing. Force on the shaft: f_x = -(stiffness_x
/// x + stiffness_xy y) - the same with damping - mass_x x''; f_y with yx and y. Single coefficients may be
/// negative, as for a seal, provided that all supports together hold the shaft. A support at a housing
/// (at_housing) holds that housing and not the shaft.
struct Support {
  double position_m = required;  ///< not used where the support is at a housing
  std::optional<int> at_housing = std::nullopt;
  std::optional<int> on_housing = std::nullopt;  ///< empty: it stands on the ground or its pedestal
  double stiffness_x_n_per_m = required;
  double stiffness_y_n_per_m = required;
  double stiffness_xy_n_per_m = 0;
  double stiffness_yx_n_per_m = 0;
  double damping_x_ns_per_m = 0;
  double damping_y_ns_per_m = 0;
  double damping_xy_ns_per_m = 0;
  double damping_yx_ns_per_m = 0;
  double mass_x_kg = 0;  ///< fluid mass that moves with the shaft relative to the ground or pedestal
  double mass_y_kg = 0;
  double angular_stiffness_nm_per_rad = 0;  ///< stiffness against tilting of the shaft relative to the ground
  std::optional<Pedestal> pedestal;
  std::optional<BearingFault> fault;
  /// Curves of the coefficients over the speed. The numbers above are then those at one of the table's speeds
  /// (with_table).
  std::optional<SupportTable> table;
  std::string name;  ///< name of the element in its source file; for messages

  static void visit_fields(auto& self, auto&& visit) {
    visit("position_m", self.position_m, key(not_negative, "place along the shaft"));
    visit("stiffness_x_n_per_m", self.stiffness_x_n_per_m, key(physical::cross_stiffness, "stiffness in x"));
    visit("stiffness_y_n_per_m", self.stiffness_y_n_per_m, key(physical::cross_stiffness, "stiffness in y"));
    visit("stiffness_xy_n_per_m", self.stiffness_xy_n_per_m,
          key(physical::cross_stiffness, "force in -x per displacement in y"));
    visit("stiffness_yx_n_per_m", self.stiffness_yx_n_per_m,
          key(physical::cross_stiffness, "force in -y per displacement in x"));
    visit("damping_x_ns_per_m", self.damping_x_ns_per_m, key(physical::cross_damping, "damping in x"));
    visit("damping_y_ns_per_m", self.damping_y_ns_per_m, key(physical::cross_damping, "damping in y"));
    visit("damping_xy_ns_per_m", self.damping_xy_ns_per_m,
          key(physical::cross_damping, "force in -x per velocity in y"));
    visit("damping_yx_ns_per_m", self.damping_yx_ns_per_m,
          key(physical::cross_damping, "force in -y per velocity in x"));
    visit("mass_x_kg", self.mass_x_kg,
          key(physical::added_mass_kg, "mass of fluid that moves with the shaft in x"));
    visit("mass_y_kg", self.mass_y_kg,
          key(physical::added_mass_kg, "mass of fluid that moves with the shaft in y"));
    visit("angular_stiffness_nm_per_rad", self.angular_stiffness_nm_per_rad,
          key(physical::stiffness, "stiffness against tilting of the shaft, to the ground"));
  }
};

/// Sets the coefficients of a support, in the order of support_coefficients.
void set_coefficients(Support& support, const std::array<double, support_coefficients.size()>& values);

/// The support with this table. Its own coefficients become those of the middle speed. They are used wherever
/// a single speed is needed: for the shapes that span the motion at all speeds.
Support with_table(Support support, SupportTable table);

/// Checks a support that is at or on a housing against settings that exclude this. Empty: no problem.
std::optional<PartProblem> housing_problem(const Support& support);

}  // namespace rubsweep::model
