#include "rubsweep/core/model/rotor_kit.hpp"

#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <string_view>
#include <type_traits>
#include <utility>

#include "rubsweep/core/error.hpp"
#include "rubsweep/core/model/disc_inertia.hpp"
#include "rubsweep/core/model/require.hpp"
#include "rubsweep/core/model/shaft_end.hpp"
#include "rubsweep/core/model/shaft_matrices.hpp"
#include "rubsweep/core/overloaded.hpp"

namespace rubsweep::model {
namespace {

template <class Part>
void require_fields(const Part& part, const std::string& path) {
  Part::visit_fields(part, [&](const char* name, const auto& value, const Range& range) {
    require(path + name, value, range);
  });
}

/// Whether a part is on the shaft; a support at a housing is not.
template <class Part>
bool is_on_shaft(const Part& part) {
  if constexpr (std::is_same_v<Part, Support>) return !part.at_housing;
  return true;
}

template <class Part>
void require_parts(const std::vector<Part>& parts, const std::string& path, const char* list,
                   double length_m) {
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const std::string name = fmt::format("{}{}.{}.", path, list, i);
    Part::visit_fields(parts[i], [&](const char* key, const auto& value, const Range& range) {
      if (key != std::string_view("position_m")) return require(name + key, value, range);
      if (is_on_shaft(parts[i]))
        require(name + key, value, Range{.low = 0, .high = furthest_place_m(length_m)});
    });
  }
}

void refuse_diameters(const ShaftLayer& layer, const std::string& path) {
  if (const auto problem = diameter_problem(layer))
    throw ConfigError(
        fmt::format("{}{}: {}, allowed: {}", path, problem->key, problem->wrong, problem->allowed));
}

/// Whether a stiffness matrix is positive definite: eliminates its coordinates from the last to the first and
/// checks that every pivot is positive beyond rounding.
bool holds_all(Eigen::MatrixXd stiffness) {
  constexpr double nothing = 1e-12;
  const Eigen::VectorXd whole = stiffness.diagonal();
  for (Eigen::Index i = stiffness.rows() - 1; i >= 0; --i) {
    const double pivot = stiffness(i, i);
    if (!(pivot > 0) || pivot <= nothing * whole(i)) return false;
    const Eigen::VectorXd row = stiffness.row(i);
    stiffness -= row * row.transpose() / pivot;
  }
  return true;
}

void validate(const Support& support, const RotorKit& kit, const std::string& path) {
  const Range numbers{.low = 0, .high = static_cast<double>(kit.housings.size()) - 1};
  for (const auto& [name, housing] :
       {std::pair("at_housing", support.at_housing), std::pair("on_housing", support.on_housing)}) {
    if (!housing) continue;
    if (kit.housings.empty()) throw ConfigError(path + name + ": there are no housings");
    require(path + name, *housing, numbers);
  }
  if (const auto problem = housing_problem(support))
    throw ConfigError(
        fmt::format("{}{}: {}, allowed: {}", path, problem->key, problem->wrong, problem->allowed));
}

void validate(const BowMode& mode, const std::string& path) {
  require(path + "amplitude_m", mode.amplitude_m, physical::amplitude_m);
  require(path + "mode", mode.mode, Range{.low = 1, .high = RotorKit::most_modes});
}

void validate(const BowPoints& points, const std::string& path, double length_m) {
  for (const double position : points.position_m) {
    require(path + "position_m", position, Range{.low = 0, .high = furthest_place_m(length_m)});
  }
  for (const double deflection : points.deflection_m)
    require(path + "deflection_m", deflection, physical::deflection_m);
  std::vector<double> sorted = points.position_m;
  std::sort(sorted.begin(), sorted.end());
  const bool distinct = std::adjacent_find(sorted.begin(), sorted.end(), [&](double a, double b) {
                          return b - a <= 1e-6 * length_m;
                        }) == sorted.end();
  if (sorted.size() < 2 || !distinct) {
    throw ConfigError(path + "position_m: a bow needs two or more points at different places of the shaft");
  }
  if (sorted.size() != points.deflection_m.size()) {
    throw ConfigError(path + "deflection_m: allowed: as many numbers as position_m has");
  }
}

/// Refuses parts that cannot be combined with matrices, which contain neither the shaft's own stiffness nor
/// its torsional inertia.
void refuse_beside_matrices(const RotorKit& kit, const std::string& path) {
  const std::pair<const char*, bool> excluded[]{{"shaft", !kit.shaft.empty()},
                                                {"discs", !kit.discs.empty()},
                                                {"point_masses", !kit.point_masses.empty()},
                                                {"housings", !kit.housings.empty()},
                                                {"couplings", !kit.couplings.empty()},
                                                {"bow", kit.bow.has_value()},
                                                {"torsion", kit.torsion.has_value()}};
  for (const auto& [name, given] : excluded) {
    if (given) throw ConfigError(fmt::format("{}{}: is given beside matrices, allowed: nothing", path, name));
  }
}

void validate_shaft(const RotorKit& kit, const std::string& path) {
  if (kit.matrices) {
    refuse_beside_matrices(kit, path);
    return validate(*kit.matrices, path);
  }
  if (kit.shaft.empty()) throw ConfigError(path + "shaft: at least one segment is needed");
  for (std::size_t i = 0; i < kit.shaft.size(); ++i) {
    const ShaftSegment& segment = kit.shaft[i];
    const std::string name = fmt::format("{}shaft.{}.", path, i);
    require_fields(segment, name);
    refuse_diameters(segment, name);
    for (std::size_t k = 0; k < segment.layers.size(); ++k) {
      const std::string layer = fmt::format("{}layers.{}.", name, k);
      require_fields(segment.layers[k], layer);
      refuse_diameters(segment.layers[k], layer);
    }
  }
}

void validate_supports(const RotorKit& kit, const std::string& path) {
  for (std::size_t i = 0; i < kit.supports.size(); ++i) {
    const std::string name = fmt::format("{}supports.{}.", path, i);
    validate(kit.supports[i], kit, name);
    if (kit.supports[i].pedestal) require_fields(*kit.supports[i].pedestal, name + "pedestal.");
    if (kit.supports[i].fault) require_fields(*kit.supports[i].fault, name + "fault.");
    if (kit.supports[i].table) validate(*kit.supports[i].table, name + "table.");
  }
  for (const int plane : {0, 1}) {
    if (kit.matrices || supports_hold(kit, plane))
      continue;  // a positive definite stiffness matrix holds it; its factorisation checks that
    throw ConfigError(
        fmt::format("{}supports: they leave the shaft{} free to move in {}, allowed: supports that hold it",
                    path, kit.housings.empty() ? "" : " or a housing", plane == 0 ? "x" : "y"));
  }
  if (const Range common = table_speeds_hz(kit); has_tables(kit) && !(common.low <= common.high))
    throw ConfigError(path + "supports: their tables have no speed in common, allowed: tables that overlap");
}

void validate_bow(const Bow& bow, const RotorKit& kit, const std::string& path) {
  if (has_tables(kit) && std::holds_alternative<BowMode>(bow.shape))
    throw ConfigError(
        path + "bow.mode: the modes follow the tables of the supports, allowed: position_m and deflection_m");
  require(path + "bow.phase_deg", bow.phase_deg, any_finite);
  std::visit(
      overloaded{[&](const BowMode& mode) { validate(mode, path + "bow."); },
                 [&](const BowPoints& points) { validate(points, path + "bow.", shaft_length_m(kit)); }},
      bow.shape);
}

}  // namespace

bool supports_hold(const RotorKit& kit, int plane) {
  // Stiffness matrix of translation and tilt about the shaft's free end, and of each housing.
  const auto n = static_cast<Eigen::Index>(2 + kit.housings.size());
  Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(n, n);
  for (const Support& support : kit.supports) {
    double k = plane == 0 ? support.stiffness_x_n_per_m : support.stiffness_y_n_per_m;
    if (support.pedestal && k != 0) {
      const double ground =
          plane == 0 ? support.pedestal->stiffness_x_n_per_m : support.pedestal->stiffness_y_n_per_m;
      k = k * ground / (k + ground);
    }
    Eigen::VectorXd stretched = Eigen::VectorXd::Zero(n);
    if (support.at_housing) {
      stretched(2 + *support.at_housing) = 1;
    } else {
      stretched.head<2>() << 1, support.position_m;
    }
    if (support.on_housing) stretched(2 + *support.on_housing) -= 1;
    stiffness += k * stretched * stretched.transpose();
    stiffness(1, 1) += support.angular_stiffness_nm_per_rad;
  }
  return holds_all(stiffness);
}

double shaft_length_m(const RotorKit& kit) {
  if (kit.matrices) return shaft_length_m(*kit.matrices);
  double length = 0;
  for (const auto& segment : kit.shaft) length += segment.length_m;
  return length;
}

bool has_rotating_damping(const RotorKit& kit) {
  return std::ranges::any_of(kit.rotating_damping_ratio, [](double ratio) { return ratio > 0; });
}

bool has_misalignment(const RotorKit& kit) {
  return std::ranges::any_of(kit.couplings, [](const Coupling& coupling) {
    return coupling.parallel_offset_m != 0 || coupling.angular_offset_rad != 0;
  });
}

bool has_standing_misalignment(const RotorKit& kit) {
  return std::ranges::any_of(kit.couplings, [](const Coupling& coupling) {
    return coupling.parallel_misalignment_m != 0 || coupling.angular_misalignment_rad != 0;
  });
}

bool is_asymmetric(const Coupling& coupling) {
  return coupling.lateral_asymmetry_ratio != 0 || coupling.angular_asymmetry_ratio != 0;
}

bool has_tables(const RotorKit& kit) {
  return std::ranges::any_of(kit.supports, [](const Support& support) { return support.table.has_value(); });
}

Range table_speeds_hz(const RotorKit& kit) {
  Range common = not_negative;
  for (const Support& support : kit.supports) {
    if (!support.table) continue;
    common.low = std::max(common.low, support.table->speed_hz.front());
    common.high = std::min(common.high, support.table->speed_hz.back());
  }
  return common;
}

bool has_pedestals(const RotorKit& kit) {
  return std::ranges::any_of(kit.supports,
                             [](const Support& support) { return support.pedestal.has_value(); });
}

Range coupling_places(const RotorKit& kit) {
  constexpr double margin = 1e-6;
  const double length = shaft_length_m(kit);
  return {.low = margin * length, .high = (1 - margin) * length};
}

void validate(const RotorKit& kit, const std::string& path) {
  validate_shaft(kit, path);
  const double length = shaft_length_m(kit);
  require_parts(kit.discs, path, "discs", length);
  for (std::size_t i = 0; i < kit.discs.size(); ++i) {
    require(fmt::format("{}discs.{}.polar_inertia_kg_m2", path, i), kit.discs[i].polar_inertia_kg_m2,
            Range{.low = 0, .high = largest_polar_inertia_kg_m2(kit.discs[i])});
  }
  require_parts(kit.supports, path, "supports", length);
  require_parts(kit.point_masses, path, "point_masses", length);
  for (std::size_t i = 0; i < kit.housings.size(); ++i)
    require_fields(kit.housings[i], fmt::format("{}housings.{}.", path, i));
  require_parts(kit.static_loads, path, "static_loads", length);
  require_parts(kit.sensors, path, "sensors", length);
  require_parts(kit.couplings, path, "couplings", length);
  for (std::size_t i = 0; i < kit.couplings.size(); ++i) {
    require(fmt::format("{}couplings.{}.position_m", path, i), kit.couplings[i].position_m,
            coupling_places(kit));
  }
  validate_supports(kit, path);
  if (kit.bow) validate_bow(*kit.bow, kit, path);
  if (kit.torsion) require_fields(*kit.torsion, path + "torsion.");
  if (kit.torsion && std::ranges::any_of(kit.couplings, is_asymmetric)) {
    throw ConfigError(
        path +
        "torsion: is given beside a coupling with an asymmetry ratio, whose force does not know "
        "the angle of torsion, allowed: couplings that are equally stiff all around");
  }
  for (const auto& [name, ratios] : {std::pair("damping_ratio", &kit.damping_ratio),
                                     {"rotating_damping_ratio", &kit.rotating_damping_ratio}}) {
    if (ratios->empty()) throw ConfigError(path + name + ": at least one number is needed");
    for (const double ratio : *ratios) require(path + name, ratio, RotorKit::damping_ratio_range);
  }
  require(path + "mass_damping_per_s", kit.mass_damping_per_s, physical::rate_per_s);
  if (has_rotating_damping(kit) && has_pedestals(kit)) {
    throw ConfigError(path +
                      "rotating_damping_ratio: turns with the shaft, and pedestals do not, allowed: 0 beside "
                      "pedestals");
  }
  if (kit.modes) require(path + "modes", *kit.modes, Range{.low = 1, .high = RotorKit::most_modes});
  require(path + "modes_up_to_hz", kit.modes_up_to_hz, physical::frequency_hz);
  require(path + "elements", kit.elements, Range{.low = 1, .high = RotorKit::most_elements});
}

}  // namespace rubsweep::model
