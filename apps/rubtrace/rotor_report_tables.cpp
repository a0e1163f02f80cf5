#include "rotor_report_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <optional>
#include <utility>

#include "rubsweep/core/model/element_name.hpp"
#include "rubsweep/core/structure/tabled_support.hpp"
#include "rubsweep/maps/batch/csv_table.hpp"

namespace rubsweep::apps {
namespace {

using batch::csv_number;

std::string cell(std::optional<double> value) { return value ? csv_number(*value) : std::string(); }

/// Name of an element, or word and number where it has none.
std::string label_of(std::string_view word, std::size_t number, const std::string& name = {}) {
  return name.empty() ? fmt::format("{} {}", word, number) : name;
}

/// Row of the table of parts.
struct Part {
  std::string element, name;
  double position_m = 0;
  std::optional<double> end_m = {}, inner_m = {}, outer_m = {}, inner_end_m = {}, outer_end_m = {};
  std::optional<double> mass_kg = {}, polar_inertia_kg_m2 = {}, angle_deg = {};
};

std::string line_of(const Part& part) {
  const std::array<std::string, 11> cells{part.element,
                                          part.name,
                                          csv_number(part.position_m),
                                          cell(part.end_m),
                                          cell(part.inner_m),
                                          cell(part.outer_m),
                                          cell(part.inner_end_m),
                                          cell(part.outer_end_m),
                                          cell(part.mass_kg),
                                          cell(part.polar_inertia_kg_m2),
                                          cell(part.angle_deg)};
  return batch::csv_row(cells) + "\n";
}

Part layer_of(const model::ShaftLayer& layer, std::string name, double from_m, double to_m) {
  return {"layer",
          std::move(name),
          from_m,
          to_m,
          layer.inner_diameter_m,
          layer.outer_diameter_m,
          layer.inner_diameter_end_m.value_or(layer.inner_diameter_m),
          layer.outer_diameter_end_m.value_or(layer.outer_diameter_m)};
}

void add_shaft(const model::RotorKit& kit, std::vector<Part>& parts) {
  if (kit.matrices) {
    parts.push_back({"shaft", "shaft", 0, model::shaft_length_m(kit)});
    return;
  }
  double from_m = 0;
  for (std::size_t i = 0; i < kit.shaft.size(); ++i) {
    const model::ShaftSegment& segment = kit.shaft[i];
    const double to_m = from_m + segment.length_m;
    parts.push_back(layer_of(segment, fmt::format("shaft {}", i), from_m, to_m));
    for (std::size_t k = 0; k < segment.layers.size(); ++k)
      parts.push_back(layer_of(segment.layers[k], fmt::format("shaft {} layer {}", i, k), from_m, to_m));
    from_m = to_m;
  }
}

}  // namespace

std::string support_label(const model::RotorKit& kit, std::size_t support) {
  return label_of("support", support, model::support_name(kit, support));
}

std::string rotor_parts_csv(const model::Machine& machine, const std::vector<std::string>& stop_names) {
  const model::RotorKit& kit = *model::kit_of(machine);
  std::vector<Part> parts;
  add_shaft(kit, parts);
  for (std::size_t i = 0; i < kit.discs.size(); ++i) {
    Part& part =
        parts.emplace_back(Part{"disc", label_of("disc", i, kit.discs[i].name), kit.discs[i].position_m});
    part.mass_kg = kit.discs[i].mass_kg;
    part.polar_inertia_kg_m2 = kit.discs[i].polar_inertia_kg_m2;
  }
  for (std::size_t i = 0; i < kit.point_masses.size(); ++i) {
    parts.push_back(
        {"point_mass", label_of("point mass", i, kit.point_masses[i].name), kit.point_masses[i].position_m});
    parts.back().mass_kg = kit.point_masses[i].mass_kg;
  }
  for (std::size_t i = 0; i < kit.supports.size(); ++i)
    if (!kit.supports[i].at_housing)
      parts.push_back(
          {design::is_seal(kit, i) ? "seal" : "bearing", support_label(kit, i), kit.supports[i].position_m});
  for (std::size_t i = 0; i < kit.couplings.size(); ++i)
    parts.push_back({"coupling", label_of("coupling", i), kit.couplings[i].position_m});
  for (std::size_t i = 0; i < kit.static_loads.size(); ++i)
    parts.push_back({"load", label_of("load", i), kit.static_loads[i].position_m});
  for (std::size_t i = 0; i < machine.stops.size(); ++i)
    parts.push_back(
        {"stop", label_of("stop", i, model::name_at(stop_names, i)), *machine.stops[i].position_m});
  for (std::size_t i = 0; i < kit.sensors.size(); ++i) {
    parts.push_back({"probe", label_of("probe", i, kit.sensors[i].name), kit.sensors[i].position_m});
    parts.back().angle_deg = kit.sensors[i].angle_deg;
  }
  std::string text =
      "element,name,position_m,end_m,inner_m,outer_m,inner_end_m,outer_end_m,mass_kg,polar_inertia_kg_m2,"
      "angle_deg\n";
  for (const Part& part : parts) text += line_of(part);
  return text;
}

std::string static_line_csv(const design::StaticLine& line) {
  std::string text = "position_m,deflection_x_m,deflection_y_m,shear_x_n,shear_y_n,moment_x_nm,moment_y_nm\n";
  for (std::size_t k = 0; k < line.position_m.size(); ++k) {
    const auto node = static_cast<Eigen::Index>(k);
    const std::string place =
        fmt::format("{},{},{}", csv_number(line.position_m[k]), csv_number(line.deflection_m[0](node)),
                    csv_number(line.deflection_m[1](node)));
    if (!line.sections) {
      text += place + ",,,,\n";
      continue;
    }
    for (const std::size_t side : {2 * k, 2 * k + 1}) {
      const design::Section& at = (*line.sections)[side];
      text += fmt::format("{},{},{},{},{}\n", place, csv_number(at.shear_n[0]), csv_number(at.shear_n[1]),
                          csv_number(at.moment_nm[0]), csv_number(at.moment_nm[1]));
    }
  }
  return text;
}

std::string bearing_loads_csv(const model::RotorKit& kit, const design::StaticLine& line,
                              std::span<const double> unbalance_force_n) {
  std::string text = "bearing,position_m,load_x_n,load_y_n,unbalance_force_n\n";
  for (std::size_t i = 0; i < line.loads.size(); ++i) {
    const design::BearingLoad& load = line.loads[i];
    const std::array<std::string, 5> cells{
        support_label(kit, load.support), csv_number(kit.supports[load.support].position_m),
        csv_number(load.load_n[0]), csv_number(load.load_n[1]), csv_number(unbalance_force_n[i])};
    text += batch::csv_row(cells) + "\n";
  }
  return text;
}

std::string critical_map_csv(const std::vector<design::CriticalSpeedsAt>& map) {
  std::string text = "stiffness_n_per_m,mode,speed_hz\n";
  for (const design::CriticalSpeedsAt& at : map)
    for (std::size_t mode = 0; mode < at.speed_hz.size(); ++mode)
      text += fmt::format("{},{},{}\n", csv_number(at.stiffness_n_per_m), mode + 1,
                          csv_number(at.speed_hz[mode]));
  return text;
}

std::string bearing_stiffness_csv(const model::RotorKit& kit, std::span<const double> speeds_hz) {
  std::string text = "bearing,speed_hz,stiffness_x_n_per_m,stiffness_y_n_per_m\n";
  for (const std::size_t bearing : design::bearings_of(kit)) {
    for (const double speed_hz : speeds_hz) {
      const model::Support at = structure::support_at(kit.supports[bearing], speed_hz, "");
      const std::array<std::string, 4> cells{support_label(kit, bearing), csv_number(speed_hz),
                                             csv_number(at.stiffness_x_n_per_m),
                                             csv_number(at.stiffness_y_n_per_m)};
      text += batch::csv_row(cells) + "\n";
    }
  }
  return text;
}

std::string stability_csv(std::span<const double> couplings_n_per_m,
                          const std::vector<design::Decrement>& decrements) {
  std::string text = "coupling_n_per_m,frequency_hz,decrement\n";
  for (std::size_t i = 0; i < decrements.size(); ++i)
    text += fmt::format("{},{},{}\n", csv_number(couplings_n_per_m[i]),
                        csv_number(decrements[i].frequency_hz), csv_number(decrements[i].decrement));
  return text;
}

linear::FreeRotor with_places_between(linear::FreeRotor rotor) {
  constexpr double places_along_shaft = 60;
  const std::vector<double> nodes = std::move(rotor.position_m);
  const Eigen::Index n = rotor.x.cols();
  rotor.position_m.clear();
  std::vector<Eigen::RowVector4d> shares;  // weights of deflection and slope at both ends
  std::vector<Eigen::Index> before;
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    const bool last = k + 1 == nodes.size();
    const double length_m = last ? 0 : nodes[k + 1] - nodes[k];
    const int parts =
        static_cast<int>(std::ceil(places_along_shaft * length_m / (nodes.back() - nodes.front())));
    for (int part = 0; part < std::max(parts, 1); ++part) {
      const double t = static_cast<double>(part) / std::max(parts, 1), rest = 1 - t;
      rotor.position_m.push_back(nodes[k] + t * length_m);
      before.push_back(static_cast<Eigen::Index>(k));
      shares.emplace_back(rest * rest * (1 + 2 * t), rest * rest * t * length_m, t * t * (3 - 2 * t),
                          -t * t * rest * length_m);
    }
  }
  rotor.x = rotor.y = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(before.size()), n);
  for (std::size_t i = 0; i < before.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    for (Eigen::Index k = 0; k < 4; ++k) {
      if (shares[i](k) == 0) continue;
      rotor.x(row, 4 * before[i] + 2 * k) = shares[i](k);
      rotor.y(row, 4 * before[i] + 2 * k + 1) = shares[i](k);
    }
  }
  return rotor;
}

std::string deflected_shape_csv(const linear::FreeRotor& rotor, const Eigen::VectorXcd& response) {
  const Eigen::VectorXcd x = rotor.x.cast<std::complex<double>>() * response,
                         y = rotor.y.cast<std::complex<double>>() * response;
  std::string text = "position_m,x_real,x_imag,y_real,y_imag\n";
  for (std::size_t k = 0; k < rotor.position_m.size(); ++k) {
    const auto at = static_cast<Eigen::Index>(k);
    text += fmt::format("{},{},{},{},{}\n", csv_number(rotor.position_m[k]), csv_number(x(at).real()),
                        csv_number(x(at).imag()), csv_number(y(at).real()), csv_number(y(at).imag()));
  }
  return text;
}

std::string report_notes_csv(const std::vector<ReportNote>& notes) {
  std::string text = "picture,note,from_hz,to_hz\n";
  for (const ReportNote& one : notes) {
    const std::array<std::string, 4> cells{one.picture, one.note, cell(one.from_hz), cell(one.to_hz)};
    text += batch::csv_row(cells) + "\n";
  }
  return text;
}

}  // namespace rubsweep::apps
