#include <algorithm>
#include <array>
#include <cmath>

#include "rubsweep/core/model/disc_geometry.hpp"
#include "rubsweep/core/model/physical_range.hpp"
#include "rubsweep/core/model/rolling_bearing.hpp"
#include "rubsweep/core/model/rotor_kit.hpp"
#include "rubsweep/core/model/support_table.hpp"
#include "rubsweep/maps/config/keys/fields.hpp"
#include "rubsweep/maps/config/keys/machine_form.hpp"

namespace rubsweep::config::keys {
namespace {

constexpr std::size_t most_parts = model::RotorKit::most_parts, most_layers = 16;

Form on_off() { return word({"off", "on"}); }

std::vector<Key> section_words() {
  return newer({may("shear_coefficient", word({"cowper", "hutchinson", "none"}),
                    "formula of the shear coefficient, or a beam without shear", "cowper"),
                may("rotary_inertia", on_off(), "inertia of the section against tilting", "on"),
                may("gyroscopic", on_off(), "gyroscopic moment of the section", "on")});
}

const std::vector<Meaning> layer_meanings{
    {"outer_diameter_m", "outer diameter"},
    {"inner_diameter_m", "diameter of the bore"},
    {"outer_diameter_end_m", "outer diameter at the end, to which it changes linearly", "(no taper)"},
    {"inner_diameter_end_m", "bore at the end, to which it changes linearly", "(no taper)"},
    {"stiffness_outer_diameter_m",
     "outer diameter that bends and shears, where it is another than that with mass", "outer_diameter_m"},
    {"stiffness_inner_diameter_m", "bore of the section that bends and shears", "inner_diameter_m"},
    {"youngs_modulus_pa", "Young's modulus"},
    {"shear_modulus_pa", "shear modulus"},
    {"density_kg_per_m3", "density"},
    {"mass_damping_per_s", "damping against motion in space: this times the mass matrix"},
    {"stiffness_damping_s", "damping against bending: this times the stiffness matrix; it does not turn"}};

Key shaft() {
  std::vector<Meaning> meanings{{"length_m", "length of the segment"}};
  meanings.insert(meanings.end(), layer_meanings.begin(), layer_meanings.end());
  Form layer = map_of(joined({fields_of<model::ShaftLayer>(layer_meanings), section_words()}));
  Form segment = map_of(
      joined({fields_of<model::ShaftSegment>(meanings), section_words(),
              newer({may("layers", list_of(std::move(layer), 1, most_layers),
                         "further sections of the same length that share both ends, such as a sleeve")})}));
  return must("shaft", list_of(std::move(segment), 1, most_parts),
              "segments of the shaft, one behind the other");
}

Key discs() {
  Form geometry = map_of(fields_of<model::DiscGeometry>({{"outer_diameter_m", "outer diameter of the disc"},
                                                         {"inner_diameter_m", "diameter of its bore"},
                                                         {"width_m", "width of the disc"},
                                                         {"density_kg_per_m3", "density of the disc"}}));
  std::vector<Key> keys = fields_of<model::Disc>(
      {{"position_m", "place along the shaft"},
       {"mass_kg", "mass of the disc"},
       {"polar_inertia_kg_m2", "moment of inertia about the axis"},
       {"diametral_inertia_kg_m2", "moment of inertia about a diameter"},
       {"eccentricity_ratio",
        "distance of the centre of mass from the axis, per metre of the cell's eccentricity"},
       {"eccentricity_phase_deg", "angle of that distance from the mark on the shaft, with the rotation"},
       {"skew_rad_per_m", "lean of the axis of inertia, per metre of the cell's eccentricity"},
       {"skew_phase_deg", "angle of that lean from the mark on the shaft"}});
  keys.push_back(
      must("geometry", std::move(geometry), "cylinder with a bore, in place of mass and inertias"));
  Choice ways{{{{"mass_kg", "polar_inertia_kg_m2", "diametral_inertia_kg_m2"}, {}}, {{"geometry"}, {}}}};
  return may("discs", list_of(map_of(std::move(keys), {std::move(ways)}), 1, most_parts),
             "rigid discs on the shaft");
}

Form pedestal() {
  return map_of(fields_of<model::Pedestal>({{"mass_kg", "mass of the housing"},
                                            {"stiffness_x_n_per_m", "stiffness of its mount in x"},
                                            {"stiffness_y_n_per_m", "stiffness of its mount in y"},
                                            {"damping_x_ns_per_m", "damping of its mount in x"},
                                            {"damping_y_ns_per_m", "damping of its mount in y"}}));
}

Form fault() {
  std::vector<Key> bearing{
      must("defect", word({"outer_race", "inner_race", "ball", "cage"}), "part that is damaged")};
  for (Key& key :
       fields_of<model::RollingBearing>({{"pitch_diameter_m", "diameter of the circle of the balls' centres"},
                                         {"ball_diameter_m", "diameter of a ball"},
                                         {"balls", "number of balls"},
                                         {"contact_angle_deg", "contact angle"}}))
    bearing.push_back(std::move(key));
  std::vector<Key> keys = fields_of<model::BearingFault>(
      {{"impulse_ns", "impulse of each strike on the shaft"},
       {"multiple", "strikes per revolution"},
       {"angle_deg", "direction of the strikes from +x towards +y; it does not turn"},
       {"phase_deg", "when the first strike comes, as a share of 360 of the time between two"}});
  Key from_bearing =
      must("bearing", map_of(std::move(bearing)), "rolling bearing that the strikes follow from");
  from_bearing.since = "0.1.0+";
  keys.push_back(std::move(from_bearing));
  return map_of(std::move(keys), {{{{{"multiple"}, {}}, {{"bearing"}, {}}}}});
}

/// Names of a column of a table, with the units that each may say.
std::vector<std::string> names_of_column(std::string_view name) {
  using Units = std::vector<std::string_view>;
  const Units units = name[0] == 'k'   ? Units{"n_per_m", "n_per_mm", "n_per_um", "lbf_per_in"}
                      : name[0] == 'c' ? Units{"ns_per_m", "ns_per_mm", "lbf_s_per_in"}
                                       : Units{"kg"};
  std::vector<std::string> names{std::string(name)};
  for (const std::string_view unit : units) names.push_back(names[0] + "_" + std::string(unit));
  return names;
}

Form table() {
  const auto numbers = [](const model::Range& range) {
    return list_of(number(range), 1, model::SupportTable::most_points);
  };
  std::vector<Key> columns{
      must("speed_hz", numbers(model::not_negative), "speeds, all rising or all falling"),
      must("speed_rpm", numbers(model::not_negative), "the same in revolutions per minute"),
      must("speed_rad_per_s", numbers(model::not_negative), "the same in radians per second")};
  std::vector<Choice> choices{{{{{"speed_hz"}, {}}, {{"speed_rpm"}, {}}, {{"speed_rad_per_s"}, {}}}}};
  for (const std::string_view column : model::support_coefficients) {
    Choice names{{}, column != "kxx" && column != "kyy"};
    for (const std::string& name : names_of_column(column)) {
      columns.push_back(
          must(name, numbers({}), "coefficient at these speeds, in the unit of its name or in SI"));
      names.ways.push_back({{name}, {}});
    }
    choices.push_back(std::move(names));
  }
  Key unit = may("speed_unit", word({"rpm", "Hz", "rad/s"}), "unit of the speeds of a file that says none",
                 "(that of the file)");
  unit.since = "0.1.0+";
  return any_of({map_of({must("file", text(), "file of these columns, its name relative to this one"),
                         std::move(unit)}),
                 map_of(std::move(columns), std::move(choices))});
}

Choice coefficients_or_table() {
  Way coefficients;
  const model::Support support;
  model::Support::visit_fields(support, [&](std::string_view name, double value, const model::Range&) {
    if (name == "position_m" || name.starts_with("angular")) return;
    (std::isnan(value) ? coefficients.required : coefficients.optional).emplace_back(name);
  });
  return {{{{"table"}, {}}, std::move(coefficients)}};
}

Key supports() {
  std::vector<Key> keys = fields_of<model::Support>(
      {{"position_m", "place along the shaft"},
       {"stiffness_x_n_per_m", "stiffness in x"},
       {"stiffness_y_n_per_m", "stiffness in y"},
       {"stiffness_xy_n_per_m", "force in -x per displacement in y"},
       {"stiffness_yx_n_per_m", "force in -y per displacement in x"},
       {"damping_x_ns_per_m", "damping in x"},
       {"damping_y_ns_per_m", "damping in y"},
       {"damping_xy_ns_per_m", "force in -x per velocity in y"},
       {"damping_yx_ns_per_m", "force in -y per velocity in x"},
       {"mass_x_kg", "mass of fluid that moves with the shaft in x"},
       {"mass_y_kg", "mass of fluid that moves with the shaft in y"},
       {"angular_stiffness_nm_per_rad", "stiffness against tilting of the shaft, to the ground"}});
  const Form housing = integer(0, static_cast<long>(most_parts) - 1);
  for (Key& key :
       newer({must("table", table(), "coefficients over the speed, in place of the numbers"),
              must("at_housing", housing, "number of the housing that it holds in place of the shaft"),
              may("on_housing", housing, "number of the housing on which it stands", "(the ground)")}))
    keys.push_back(std::move(key));
  keys.push_back(may("pedestal", pedestal(), "housing of its own, with a mass", "(none)"));
  keys.push_back(may("fault", fault(), "faulty bearing, which strikes the shaft", "(none)"));
  Choice places{{{{"position_m"}, {}}, {{"at_housing"}, {}}}};
  return must("supports",
              list_of(map_of(std::move(keys), {std::move(places), coefficients_or_table()}), 1, most_parts),
              "bearings of shaft and housings");
}

Key couplings() {
  std::vector<Key> keys = fields_of<model::Coupling>(
      {{"position_m", "place inside the shaft"},
       {"lateral_stiffness_n_per_m", "stiffness against displacement of its ends"},
       {"angular_stiffness_nm_per_rad", "stiffness against tilting of its ends"},
       {"parallel_offset_m", "distance of the axes of halves that are bored off their centres"},
       {"parallel_phase_deg", "angle of that distance from the mark on the shaft"},
       {"angular_offset_rad", "lean of the axis of the end behind it"},
       {"angular_phase_deg", "angle of that lean from the mark on the shaft"},
       {"parallel_misalignment_m", "distance at which the machine behind it stands beside the one before it"},
       {"parallel_misalignment_angle_deg", "direction of that distance, from +x towards +y"},
       {"angular_misalignment_rad", "lean of the axis of the machine behind it"},
       {"angular_misalignment_angle_deg", "direction of that lean, from +x towards +y"},
       {"lateral_asymmetry_ratio",
        "share by which the lateral stiffness is larger along its stiff axis, and smaller across it"},
       {"angular_asymmetry_ratio", "the same of the angular stiffness"},
       {"stiff_axis_phase_deg", "angle of the stiff axis from the mark on the shaft"}});
  return may("couplings", list_of(map_of(std::move(keys)), 1, most_parts), "elastic joints of the shaft");
}

Form bow() {
  const auto numbers = [](const model::Range& range) { return list_of(number(range), 1, most_parts); };
  return map_of(
      {must("mode", integer(1, model::RotorKit::most_modes), "mode whose shape it has, 1 the lowest"),
       must("amplitude_m", number(model::physical::amplitude_m), "largest deflection of that shape"),
       must("position_m", numbers(model::not_negative), "places along the shaft of measured deflections"),
       must("deflection_m", numbers(model::physical::deflection_m),
            "deflections there; the least bent line through them"),
       may("phase_deg", number(model::any_finite), "angle of the bow from the mark on the shaft", "0")},
      {{{{{"mode", "amplitude_m"}, {}}, {{"position_m", "deflection_m"}, {}}}}});
}

std::vector<Key> lists() {
  const auto parts = [](std::vector<Key> keys) { return list_of(map_of(std::move(keys)), 1, most_parts); };
  return joined(
      {newer({may("point_masses",
                  parts(fields_of<model::PointMass>(
                      {{"position_m", "place along the shaft"},
                       {"mass_kg", "mass"},
                       {"mass_y_kg", "mass of the motion in y, where it is another", "mass_kg"}})),
                  "masses without inertia against tilting"),
              may("housings",
                  parts(fields_of<model::Housing>(
                      {{"mass_kg", "mass"},
                       {"mass_y_kg", "mass of the motion in y, where it is another", "mass_kg"}})),
                  "bodies beside the shaft that move in x and y, held by supports"),
              may("static_loads",
                  parts(fields_of<model::StaticLoad>({{"position_m", "place along the shaft"},
                                                      {"force_x_n", "force in x"},
                                                      {"force_y_n", "force in y"}})),
                  "forces that do not change")}),
       {may("sensors",
            parts(fields_of<model::Sensor>({{"position_m", "place along the shaft"},
                                            {"angle_deg", "direction it looks in, from +x towards +y"}})),
            "proximity probes")}});
}

Form damping_ratio() {
  const Form ratio = number(model::RotorKit::damping_ratio_range);
  return any_of({ratio, list_of(ratio, 1, most_parts)});
}

}  // namespace

std::vector<Key> rotor_kit_keys() {
  const model::RotorKit defaults;
  return joined(
      {{shaft(), discs(), supports(), couplings()},
       lists(),
       {may("bow", bow(), "residual bow: it turns with the shaft and is not scaled by the cell", "(none)"),
        may("torsion",
            map_of(fields_of<model::Torsion>(
                {{"drive_stiffness_nm_per_rad", "stiffness between rotor and drive"},
                 {"drive_damping_nms_per_rad", "damping between rotor and drive"}})),
            "twist of the rotor against a drive of constant speed", "(none)"),
        may("damping_ratio", damping_ratio(), "structural damping, of mode 1, 2, ...; the last value goes on",
            "0")},
       newer(
           {may("rotating_damping_ratio", damping_ratio(),
                "the same of the damping that turns with the shaft; not beside pedestals", "0"),
            may("mass_damping_per_s", number(model::physical::rate_per_s),
                "damping of shaft, discs and point masses: so many times their mass", "0"),
            may("clearances_from", word({"axis", "sag"}),
                "where clearances and displacements count from: the axis, or where weight and loads leave it",
                "axis")}),
       {may("modes", any_of({word({"auto"}), integer(1, model::RotorKit::most_modes)}),
            "bending modes kept in each plane", "auto"),
        may("modes_up_to_hz", number(model::physical::frequency_hz),
            "frequency up to which modes: auto compares the reduced rotor with the full one",
            shortest(defaults.modes_up_to_hz)),
        may("elements", integer(1, model::RotorKit::most_elements),
            "least number of beam elements along the whole shaft", std::to_string(defaults.elements))}});
}

std::vector<Key> ross_keys() {
  Form unbalance = map_of(
      {must("disc", text(), "tag of the disc"),
       may("eccentricity_ratio", number(model::physical::per_eccentricity),
           "distance of the centre of mass from the axis, per metre of the cell's eccentricity", "1"),
       may("eccentricity_phase_deg", number(model::any_finite), "angle of that distance", "0"),
       may("skew_rad_per_m", number(model::physical::per_eccentricity), "lean of the axis of inertia", "0"),
       may("skew_phase_deg", number(model::any_finite), "angle of that lean", "0")});
  std::vector<Key> keys =
      newer({must("file", text(), "file of ROSS, TOML or JSON, its name relative to this one"),
             may("unbalance", list_of(std::move(unbalance), 1, most_parts),
                 "discs that stand off the axis; those that are not named are balanced",
                 "(all, with a ratio of 1)")});
  constexpr std::array<std::string_view, 6> of_elements{"shaft",     "discs",        "supports",
                                                        "couplings", "point_masses", "housings"};
  for (Key& key : rotor_kit_keys()) {
    if (std::ranges::count(of_elements, key.name) != 0) continue;
    if (key.name == "elements") key.fallback = "1";
    keys.push_back(std::move(key));
  }
  return keys;
}

}  // namespace rubsweep::config::keys
