#include "rubsweep/maps/config/machine/ross_elements.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>

#include "rubsweep/core/model/disc_inertia.hpp"
#include "rubsweep/core/model/speed_text.hpp"
#include "rubsweep/maps/config/yaml/section.hpp"

namespace rubsweep::config::machine {
namespace {

constexpr yaml::IntegerRange node_numbers{0, 100'000};
constexpr Words<bool, 2> flags{{"false", "true"}, {false, true}};
constexpr Words<model::ShearCoefficient, 2> shear_methods{
    {"cowper", "hutchinson"}, {model::ShearCoefficient::cowper, model::ShearCoefficient::hutchinson}};

/// Value of a key; empty also where it is null, which means "not given" in files of ROSS.
std::optional<yaml::Value> given(yaml::Section& section, std::string_view name) {
  const auto value = section.find(name);
  return value && value->node.kind != yaml::Node::Kind::null ? value : std::nullopt;
}

int read_node(yaml::Section& section) {
  const auto value = section.require("n", yaml::describe(node_numbers));
  const auto number = value ? yaml::read_integer(*value, node_numbers) : std::nullopt;
  return number ? static_cast<int>(*number) : 0;
}

/// Marks as known some keys that are needed only to draw the rotor.
void ignore(yaml::Section& section, std::initializer_list<std::string_view> names) {
  for (const std::string_view name : names) section.find(name);
}

void field(yaml::Section& section, std::string_view name, double& target, const model::Range& range) {
  if (given(section, name) || std::isnan(target)) section.field(name, target, range);
}

void refuse_unless_zero(yaml::Section& section, std::string_view name, std::string_view wrong) {
  double value = 0;
  field(section, name, value, model::any_finite);
  if (value != 0) section.refuse(name, wrong, "0");
}

void read_material(const yaml::Value& value, model::ShaftLayer& layer) {
  if (value.node.kind == yaml::Node::Kind::scalar) {
    refuse(value, "names a material whose numbers are not in the file", "a map with rho, E and G_s");
    return;
  }
  yaml::Section material(value);
  ignore(material, {"name", "color", "specific_heat", "thermal_conductivity"});
  field(material, "rho", layer.density_kg_per_m3, model::physical::density_kg_per_m3);
  double young = std::nan(""), shear = std::nan(""), poisson = std::nan("");
  const auto optional = [&](std::string_view name, double& number, const model::Range& range) {
    if (!given(material, name)) return;
    number = 0;
    field(material, name, number, range);
  };
  optional("E", young, model::physical::modulus_pa);
  optional("G_s", shear, model::physical::modulus_pa);
  optional("Poisson", poisson, {.low = -1, .high = 0.5, .low_open = true});
  material.refuse_unknown_keys();
  if (std::isnan(young)) young = 2 * shear * (1 + poisson);
  if (std::isnan(shear)) shear = young / (2 * (1 + poisson));
  if (std::isnan(young) || std::isnan(shear)) {
    refuse(value, "does not say how stiff it is", "two of E, G_s and Poisson");
  } else if (!std::isnan(poisson) && std::abs(young - 2 * shear * (1 + poisson)) > 1e-6 * young) {
    material.refuse("Poisson", "contradicts E and G_s", "E / (2 G_s) - 1, or two of the three");
  }
  layer.youngs_modulus_pa = young;
  layer.shear_modulus_pa = shear;
}

/// Diameter at the other end of an element; empty where it equals `begin`.
std::optional<double> read_end(yaml::Section& section, std::string_view name, double begin,
                               const model::Range& range) {
  if (!given(section, name)) return std::nullopt;
  double end = begin;
  field(section, name, end, range);
  return end == begin ? std::nullopt : std::optional(end);
}

/// Values of a coefficient at each speed, or a single value for all speeds; empty where it is not given.
std::vector<double> read_numbers_or_one(yaml::Section& section, std::string_view name,
                                        const model::Range& range) {
  const auto value = given(section, name);
  if (!value) return {};
  if (value->node.kind != yaml::Node::Kind::list) {
    const auto number = read_number(*value, range);
    return number ? std::vector{*number} : std::vector<double>{};
  }
  return read_number_list(*value, range, model::SupportTable::most_points);
}

/// Speed in Hz. Tables are made at whole revolutions per minute, but saved in rad/s with about ten digits. A
/// speed that is a whole number of rpm to nine digits is rounded to this number, so that a sweep can begin
/// and end at the ends of the table.
double speed_hz_of(double rad_per_s) {
  constexpr double nine_digits = 1e-9;
  const double hz = rad_per_s / (2 * std::numbers::pi), rpm = model::rpm_per_hz * hz, whole = std::round(rpm);
  return std::abs(rpm - whole) <= nine_digits * whole ? whole / model::rpm_per_hz : hz;
}

/// Speeds of a table in Hz; empty where the element has none.
std::vector<double> read_speeds_hz(yaml::Section& section) {
  constexpr std::array<std::string_view, 3> names{"frequency", "speed", "w"};
  std::vector<double> speeds;
  std::string_view found;
  for (const std::string_view name : names) {
    if (!given(section, name)) continue;
    if (!found.empty())
      section.refuse_together(name, {found, name}, "says the speeds a second time", "one of them");
    found = name;
    speeds = read_numbers_or_one(section, name, model::not_negative);
    for (double& speed : speeds) speed = speed_hz_of(speed);
  }
  for (std::size_t i = 1; i < speeds.size(); ++i) {
    if (speeds[i] > speeds[i - 1]) continue;
    section.refuse(found, "its speeds do not ascend", "each speed once, the slowest first");
    return {};
  }
  return speeds;
}

/// Columns of a table, in the order of model::support_coefficients.
using Columns = decltype(model::SupportTable::columns);

Columns read_columns(yaml::Section& section) {
  Columns columns;
  for (std::size_t c = 0; c < columns.size(); ++c)
    columns[c] = read_numbers_or_one(section, model::support_coefficients[c], model::range_of_column(c));
  // A coefficient of y that is left out equals that of x, and cross terms that are left out are 0.
  for (const auto& [x, y] : {std::pair(0, 3), {4, 7}, {8, 9}}) {
    if (columns[static_cast<std::size_t>(y)].empty())
      columns[static_cast<std::size_t>(y)] = columns[static_cast<std::size_t>(x)];
  }
  for (auto& column : columns) {
    if (column.empty()) column = {0};
  }
  for (const std::string_view cross : {"mxy", "myx"}) {
    for (const double number : read_numbers_or_one(section, cross, model::any_finite)) {
      if (number == 0) continue;
      section.refuse(cross, "a mass that couples x and y cannot be represented", "0");
      break;
    }
  }
  return columns;
}

/// Makes all columns equally long: a single number is repeated for all speeds.
void spread(yaml::Section& section, Columns& columns, std::size_t count) {
  for (std::size_t c = 0; c < columns.size(); ++c) {
    if (columns[c].size() == 1) columns[c].resize(count, columns[c].front());
    if (columns[c].size() == count) continue;
    const std::string_view name = model::support_coefficients[c];
    section.refuse(name, fmt::format("has {} numbers", columns[c].size()),
                   fmt::format("{}, one for each speed, or one for all", count));
    columns[c].assign(count, 0);
  }
}

/// Refuses a table over the whirl frequency, and returns whether it did. A motion that is not synchronous
/// would need the coefficients at its own frequency instead of the shaft speed.
bool refuse_whirl_table(yaml::Section& section) {
  const auto frequency = given(section, "frequency");
  if (!frequency || frequency->node.items.size() < 2) return false;
  refuse(*frequency, "is the whirl frequency since version 3 of ROSS, which coefficients cannot follow here",
         "a table over speed, that of the shaft");
  return true;
}

void read_coefficients(yaml::Section& section, model::Support& support) {
  section.require("kxx", "numbers in N/m");
  Columns columns = read_columns(section);
  const std::vector<double> speeds = read_speeds_hz(section);
  std::size_t longest = 1;
  for (const auto& column : columns) longest = std::max(longest, column.size());
  if (longest > 1 && speeds.empty() && section.is_sound())
    section.refuse("kxx", "has several numbers, and there are no speeds", "frequency in rad/s");
  if (!section.is_sound()) return;
  if (speeds.size() > 1) {
    spread(section, columns, speeds.size());
    if (section.is_sound()) support = model::with_table(support, {speeds, std::move(columns)});
    return;
  }
  spread(section, columns, 1);
  std::array<double, model::support_coefficients.size()> numbers{};
  for (std::size_t c = 0; c < numbers.size(); ++c) numbers[c] = columns[c].front();
  model::set_coefficients(support, numbers);
}

}  // namespace

AtNode<model::ShaftSegment> read_ross_shaft(const RossElement& element) {
  yaml::Section section(element.value);
  AtNode<model::ShaftSegment> shaft{{}, read_node(section), &element};
  model::ShaftSegment& segment = shaft.part;
  ignore(section, {"tag", "color"});
  field(section, "L", segment.length_m, model::physical::length_m);
  field(section, "odl", segment.outer_diameter_m, model::physical::diameter_m);
  field(section, "idl", segment.inner_diameter_m, model::physical::hole_m);
  segment.outer_diameter_end_m =
      read_end(section, "odr", segment.outer_diameter_m, model::physical::diameter_m);
  segment.inner_diameter_end_m = read_end(section, "idr", segment.inner_diameter_m, model::physical::hole_m);
  field(section, "alpha", segment.mass_damping_per_s, model::physical::rate_per_s);
  field(section, "beta", segment.stiffness_damping_s, model::physical::duration_s);
  bool shear = true;
  section.field("shear_effects", shear, flags);
  section.field("rotary_inertia", segment.rotary_inertia, flags);
  section.field("gyroscopic", segment.gyroscopic, flags);
  section.field("shear_method_calc", segment.shear_coefficient, shear_methods);
  if (!shear) segment.shear_coefficient = model::ShearCoefficient::none;
  refuse_unless_zero(section, "axial_force", "a load along the shaft cannot be represented");
  refuse_unless_zero(section, "torque", "a torque that softens the shaft cannot be represented");
  if (const auto material = section.require("material", "a map with rho, E and G_s"))
    read_material(*material, segment);
  section.refuse_unknown_keys();
  if (section.is_sound()) {
    if (const auto problem = model::diameter_problem(segment))
      refuse(element.value, "its diameters leave no wall", "inner diameters below the outer ones");
  }
  return shaft;
}

AtNode<model::Disc> read_ross_disc(const RossElement& element) {
  yaml::Section section(element.value);
  AtNode<model::Disc> disc{{}, read_node(section), &element};
  ignore(section, {"tag", "color", "scale_factor"});
  field(section, "m", disc.part.mass_kg, model::physical::mass_kg);
  field(section, "Ip", disc.part.polar_inertia_kg_m2, model::physical::inertia_kg_m2);
  field(section, "Id", disc.part.diametral_inertia_kg_m2, model::physical::inertia_kg_m2);
  section.refuse_unknown_keys();
  if (section.is_sound() && disc.part.polar_inertia_kg_m2 > model::largest_polar_inertia_kg_m2(disc.part))
    section.refuse("Ip", "is more than twice Id, which no body has", "at most 2 Id");
  return disc;
}

AtNode<RossMass> read_ross_mass(const RossElement& element) {
  yaml::Section section(element.value);
  AtNode<RossMass> mass{{}, read_node(section), &element};
  ignore(section, {"tag", "color", "scale_factor", "mz"});
  const bool apart = given(section, "mx").has_value() || given(section, "my").has_value();
  double both = 0, x = std::nan(""), y = std::nan("");
  if (!apart) both = std::nan("");
  field(section, "m", both, model::physical::mass_kg);
  if (!apart) x = y = both;
  if (apart) {
    field(section, "mx", x, model::physical::mass_kg);
    field(section, "my", y, model::physical::mass_kg);
  }
  section.refuse_unknown_keys();
  if (section.is_sound()) mass.part = {x, y};
  return mass;
}

AtNode<RossSupport> read_ross_support(const RossElement& element, bool whirl_tables) {
  yaml::Section section(element.value);
  AtNode<RossSupport> support{{}, read_node(section), &element};
  // Other classes also save the data that their coefficients were computed from.
  const bool plain = element.type == "BearingElement" || element.type == "SealElement";
  const bool refused = whirl_tables && refuse_whirl_table(section);
  if (!plain || refused) section.allow_unknown_keys();
  // Motion along the axis and about it does not couple with bending.
  ignore(section, {"tag", "color", "scale_factor", "kzz", "czz", "mzz", "seal_leakage"});
  if (refused) return support;
  read_coefficients(section, support.part.support);
  if (const auto link = given(section, "n_link")) {
    if (const auto node = yaml::read_integer(*link, node_numbers))
      support.part.linked_node = static_cast<int>(*node);
  }
  return support;
}

}  // namespace rubsweep::config::machine
