#pragma once

#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "rubsweep/core/model/key.hpp"
#include "rubsweep/core/model/physical_range.hpp"
#include "rubsweep/core/model/range.hpp"
#include "rubsweep/core/model/shaft_segment.hpp"
#include "rubsweep/core/model/support.hpp"
#include "rubsweep/core/vocabulary.hpp"

namespace rubsweep::model {

struct ShaftMatrices;

/// Rigid disc on the shaft. Its unbalance is given per metre of the cell's eccentricity e: the distance of
/// the centre of mass from the shaft's axis is eccentricity_ratio * e, and the axis of inertia is tilted by
/// skew_rad_per_m * e. Phases are measured in the direction of rotation from a mark on the shaft, common to
/// all discs and the bow.
struct Disc {
  double position_m = required;
  double mass_kg = required;
  double polar_inertia_kg_m2 = required;
  double diametral_inertia_kg_m2 = required;
  double eccentricity_ratio = 1;
  double eccentricity_phase_deg = 0;
  double skew_rad_per_m = 0;
  double skew_phase_deg = 0;
  std::string name = {};  ///< name or tag in its source file; for messages, tables and figures

  static void visit_fields(auto& self, auto&& visit) {
    visit("position_m", self.position_m, key(not_negative, "place along the shaft"));
    visit("mass_kg", self.mass_kg, key(physical::mass_kg, "mass of the disc"));
    visit("polar_inertia_kg_m2", self.polar_inertia_kg_m2,
          key(physical::inertia_kg_m2, "moment of inertia about the axis"));
    visit("diametral_inertia_kg_m2", self.diametral_inertia_kg_m2,
          key(physical::inertia_kg_m2, "moment of inertia about a diameter"));
    visit("eccentricity_ratio", self.eccentricity_ratio,
          key(physical::per_eccentricity,
              "distance of the centre of mass from the axis, per metre of the cell's eccentricity"));
    visit("eccentricity_phase_deg", self.eccentricity_phase_deg,
          key(any_finite, "angle of that distance from the mark on the shaft, with the rotation"));
    visit(
        "skew_rad_per_m", self.skew_rad_per_m,
        key(physical::per_eccentricity, "lean of the axis of inertia, per metre of the cell's eccentricity"));
    visit("skew_phase_deg", self.skew_phase_deg,
          key(any_finite, "angle of that lean from the mark on the shaft"));
  }
};

/// Mass on the shaft that is small enough to have no rotary inertia.
struct PointMass {
  double position_m = required;
  double mass_kg = required;
  std::optional<double> mass_y_kg = std::nullopt;  ///< mass that moves in y, if different from that in x
  std::string name = {};                           ///< as of a disc

  static void visit_fields(auto& self, auto&& visit) {
    visit("position_m", self.position_m, key(not_negative, "place along the shaft"));
    visit("mass_kg", self.mass_kg, key(physical::mass_kg, "mass"));
    visit("mass_y_kg", self.mass_y_kg,
          key(physical::mass_kg, "mass of the motion in y, where it is another", "mass_kg"));
  }
};

/// Body next to the shaft, such as a bearing housing, that moves in x and y and is held only by supports.
struct Housing {
  double mass_kg = required;
  std::optional<double> mass_y_kg = std::nullopt;
  std::string name = {};  ///< as of a disc

  static void visit_fields(auto& self, auto&& visit) {
    visit("mass_kg", self.mass_kg, key(physical::moving_mass_kg, "mass"));
    visit("mass_y_kg", self.mass_y_kg,
          key(physical::moving_mass_kg, "mass of the motion in y, where it is another", "mass_kg"));
  }
};

/// Elastic joint that cuts the shaft at an inner station into two ends. Bores of its halves may be eccentric:
/// without load, the axis of the rear end is then offset by parallel_offset_m from that of the front end and
/// tilted by angular_offset_rad. Both errors turn with the shaft; their phases are measured from its mark.
/// The rear machine may also be misaligned: the axis of its bearings is offset by parallel_misalignment_m
/// from that of the front machine and tilted by angular_misalignment_rad, in a fixed direction. Displacements
/// on either side are measured from the axis of that side. A coupling with stiffness k (1 + ratio) along a
/// stiff axis that turns with the shaft, and k (1 - ratio) across it, then excites vibration at twice the
/// speed.
struct Coupling {
  /// the force is correct to first order in the asymmetry
  static constexpr Range asymmetry_range{.low = 0, .high = 0.3};

  double position_m = required;
  double lateral_stiffness_n_per_m = required;
  double angular_stiffness_nm_per_rad = required;
  double parallel_offset_m = 0;
  double parallel_phase_deg = 0;
  double angular_offset_rad = 0;
  double angular_phase_deg = 0;
  double parallel_misalignment_m = 0;
  double parallel_misalignment_angle_deg = 0;  ///< angle from +x towards +y
  double angular_misalignment_rad = 0;
  double angular_misalignment_angle_deg = 0;
  double lateral_asymmetry_ratio = 0;
  double angular_asymmetry_ratio = 0;
  double stiff_axis_phase_deg = 0;  ///< angle from the mark on the shaft

  static void visit_fields(auto& self, auto&& visit) {
    visit("position_m", self.position_m, key(positive, "place inside the shaft"));
    visit("lateral_stiffness_n_per_m", self.lateral_stiffness_n_per_m,
          key(physical::holding_stiffness, "stiffness against displacement of its ends"));
    visit("angular_stiffness_nm_per_rad", self.angular_stiffness_nm_per_rad,
          key(physical::holding_stiffness, "stiffness against tilting of its ends"));
    visit("parallel_offset_m", self.parallel_offset_m,
          key(physical::amplitude_m, "distance of the axes of halves that are bored off their centres"));
    visit("parallel_phase_deg", self.parallel_phase_deg,
          key(any_finite, "angle of that distance from the mark on the shaft"));
    visit("angular_offset_rad", self.angular_offset_rad,
          key(physical::tilt_rad, "lean of the axis of the end behind it"));
    visit("angular_phase_deg", self.angular_phase_deg,
          key(any_finite, "angle of that lean from the mark on the shaft"));
    visit("parallel_misalignment_m", self.parallel_misalignment_m,
          key(physical::amplitude_m,
              "distance at which the machine behind it stands beside the one before it"));
    visit("parallel_misalignment_angle_deg", self.parallel_misalignment_angle_deg,
          key(any_finite, "direction of that distance, from +x towards +y"));
    visit("angular_misalignment_rad", self.angular_misalignment_rad,
          key(physical::tilt_rad, "lean of the axis of the machine behind it"));
    visit("angular_misalignment_angle_deg", self.angular_misalignment_angle_deg,
          key(any_finite, "direction of that lean, from +x towards +y"));
    visit("lateral_asymmetry_ratio", self.lateral_asymmetry_ratio,
          key(asymmetry_range,
              "share by which the lateral stiffness is larger along its stiff axis, and smaller across it"));
    visit("angular_asymmetry_ratio", self.angular_asymmetry_ratio,
          key(asymmetry_range, "the same of the angular stiffness"));
    visit("stiff_axis_phase_deg", self.stiff_axis_phase_deg,
          key(any_finite, "angle of the stiff axis from the mark on the shaft"));
  }
};

/// Constant force on the shaft.
struct StaticLoad {
  double position_m = required;
  double force_x_n = 0;
  double force_y_n = 0;

  static void visit_fields(auto& self, auto&& visit) {
    visit("position_m", self.position_m, key(not_negative, "place along the shaft"));
    visit("force_x_n", self.force_x_n, key(physical::force_n, "force in x"));
    visit("force_y_n", self.force_y_n, key(physical::force_n, "force in y"));
  }
};

/// Residual bow: deviation of the unloaded shaft's axis from a straight line; it turns with the shaft. A
/// sweep scales the unbalance of a cell, but not the bow.
struct BowPoints {  ///< the line of least bending energy through these points
  std::vector<double> position_m;
  std::vector<double> deflection_m;
};
struct BowMode {  ///< the shape of a mode of the shaft on its supports; mode 1 is the lowest
  int mode = 1;
  double amplitude_m = required;  ///< largest deflection
};
struct Bow {
  std::variant<BowPoints, BowMode> shape;
  double phase_deg = 0;
};

/// One degree of freedom of torsion: the whole rotor against a drive that turns at a constant speed.
struct Torsion {
  double drive_stiffness_nm_per_rad = required;
  double drive_damping_nms_per_rad = 0;

  static void visit_fields(auto& self, auto&& visit) {
    visit("drive_stiffness_nm_per_rad", self.drive_stiffness_nm_per_rad,
          key(physical::holding_stiffness, "stiffness between rotor and drive"));
    visit("drive_damping_nms_per_rad", self.drive_damping_nms_per_rad,
          key(physical::damping, "damping between rotor and drive"));
  }
};

/// Proximity probe: displacement of the shaft at `position_m` along the direction `angle_deg`.
struct Sensor {
  double position_m = required;
  double angle_deg = 0;
  std::string name = {};  ///< as of a disc

  static void visit_fields(auto& self, auto&& visit) {
    visit("position_m", self.position_m, key(not_negative, "place along the shaft"));
    visit("angle_deg", self.angle_deg, key(any_finite, "direction it looks in, from +x towards +y"));
  }
};

/// Shaft line made of stations: Timoshenko beam segments with discs, supports and couplings. Alternatively,
/// matrices of another program replace shaft, discs, point masses, housings, couplings and the supports that
/// they include. Matrices exclude a bow and torsion; stops, sensors, loads and supports must be at their
/// nodes.
struct RotorKit {
  /// Whether the elements come from a file of another program: their names are then keys of that file.
  bool from_file = false;
  std::shared_ptr<const ShaftMatrices> matrices;
  std::vector<ShaftSegment> shaft;
  std::vector<Disc> discs;
  std::vector<Support> supports;
  std::vector<PointMass> point_masses;
  std::vector<Housing> housings;
  std::vector<Coupling> couplings;
  std::vector<StaticLoad> static_loads;
  std::optional<Bow> bow;
  std::optional<Torsion> torsion;
  std::vector<Sensor> sensors;
  /// structural damping ratio of mode 1, 2, ...; the last ratio holds for all further modes
  std::vector<double> damping_ratio{0};
  /// Ratios of the damping that turns with the shaft, in the same form; not allowed with pedestals, which do
  /// not turn.
  std::vector<double> rotating_damping_ratio{0};
  double mass_damping_per_s = 0;  ///< damping of shaft, discs and point masses, as a multiple of their mass
  /// True: clearances and displacements are measured from the position of the shaft under weight and static
  /// loads. False: from its axis without load.
  bool clearances_from_sag = false;
  std::optional<int> modes;      ///< bending modes kept in each plane; empty: as many as needed
  double modes_up_to_hz = 2000;  ///< frequency up to which the reduced rotor must match the full one
  int elements = 24;             ///< least number of beam elements along the whole shaft

  static constexpr Range damping_ratio_range{.low = 0, .high = 1};
  static constexpr int most_modes = 40;
  static constexpr int most_elements = 400;
  static constexpr int most_parts = 400;  ///< largest length of each list

  /// Keys that are single values, not lists of parts.
  static void visit_fields(auto& self, auto&& visit) {
    constexpr Words<bool, 2> origins{{"axis", "sag"}, {false, true}};
    constexpr NumberOrList ratios{damping_ratio_range, most_parts};
    visit("damping_ratio", self.damping_ratio,
          key(ratios, "structural damping, of mode 1, 2, ...; the last value goes on", "0"));
    visit("rotating_damping_ratio", self.rotating_damping_ratio,
          newer_key(ratios, "the same of the damping that turns with the shaft; not beside pedestals", "0"));
    visit("mass_damping_per_s", self.mass_damping_per_s,
          newer_key(physical::rate_per_s,
                    "damping of shaft, discs and point masses: so many times their mass"));
    visit("clearances_from", self.clearances_from_sag,
          newer_key(
              origins,
              "where clearances and displacements count from: the axis, or where weight and loads leave it"));
    visit("modes", self.modes,
          key(IntegerOr{{1, most_modes}, "auto"}, "bending modes kept in each plane", "auto"));
    visit("modes_up_to_hz", self.modes_up_to_hz,
          key(physical::frequency_hz,
              "frequency up to which modes: auto compares the reduced rotor with the full one"));
    visit("elements", self.elements,
          key(IntegerRange{1, most_elements}, "least number of beam elements along the whole shaft"));
  }
};

/// True when the supports leave no free motion in the plane of x (0) or y (1) to the housings, and to the
/// shaft taken as rigid.
bool supports_hold(const RotorKit& kit, int plane);

/// Sum of the lengths of the segments, or the position of the last node of the matrices, in metres.
double shaft_length_m(const RotorKit& kit);

bool has_rotating_damping(const RotorKit& kit);  ///< Whether some damping rotates with the shaft.

/// Whether some coupling has an offset or a tilt that turns with the shaft.
bool has_misalignment(const RotorKit& kit);

bool has_standing_misalignment(const RotorKit& kit);  ///< Whether some coupling joins misaligned machines.

bool is_asymmetric(const Coupling& coupling);  ///< Whether a coupling's stiffness depends on the direction.

bool has_tables(const RotorKit& kit);  ///< Whether some support has coefficients from a table.

/// Range of speeds that the tables of all supports have in common; low > high where there is none.
Range table_speeds_hz(const RotorKit& kit);

bool has_pedestals(const RotorKit& kit);  ///< Whether some support has a pedestal with a mass.

/// Allowed positions of a coupling: inside the shaft, with a piece of shaft on either side.
Range coupling_places(const RotorKit& kit);

/// Throws ConfigError naming the first number that is missing or out of range, or a part that is not on the
/// shaft. `path` opens every message, e.g. "rotor.".
void validate(const RotorKit& kit, const std::string& path);

}  // namespace rubsweep::model
