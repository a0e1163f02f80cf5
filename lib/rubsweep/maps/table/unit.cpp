#include "rubsweep/maps/table/unit.hpp"

#include <algorithm>
#include <array>
#include <numbers>
#include <string>

#include "rubsweep/maps/table/cell.hpp"

namespace rubsweep::table {
namespace {

using std::numbers::pi;

struct Named {
  std::string_view name;  ///< as plain_unit writes it; in small letters, unless capital letters matter
  Unit unit;
};

constexpr double inch = metres_per_inch, pound = newtons_per_lbf;

constexpr std::array<Named, 86> units{{
    {"s", {Quantity::time, 1}},
    {"sec", {Quantity::time, 1}},
    {"secs", {Quantity::time, 1}},
    {"second", {Quantity::time, 1}},
    {"seconds", {Quantity::time, 1}},
    {"ms", {Quantity::time, 1e-3}},
    {"us", {Quantity::time, 1e-6}},
    {"min", {Quantity::time, 60}},
    {"h", {Quantity::time, 3600}},
    {"m", {Quantity::length, 1}},
    {"cm", {Quantity::length, 1e-2}},
    {"mm", {Quantity::length, 1e-3}},
    {"um", {Quantity::length, 1e-6}},
    {"nm", {Quantity::length, 1e-9}},
    {"micron", {Quantity::length, 1e-6}},
    {"microns", {Quantity::length, 1e-6}},
    {"in", {Quantity::length, inch}},
    {"inch", {Quantity::length, inch}},
    {"mil", {Quantity::length, 25.4e-6}},
    {"mils", {Quantity::length, 25.4e-6}},
    {"m/s", {Quantity::velocity, 1}},
    {"mm/s", {Quantity::velocity, 1e-3}},
    {"mm/sec", {Quantity::velocity, 1e-3}},
    {"cm/s", {Quantity::velocity, 1e-2}},
    {"um/s", {Quantity::velocity, 1e-6}},
    {"in/s", {Quantity::velocity, inch}},
    {"in/sec", {Quantity::velocity, inch}},
    {"ips", {Quantity::velocity, inch}},
    {"m/s2", {Quantity::acceleration, 1}},
    {"m/s/s", {Quantity::acceleration, 1}},
    {"m/sec2", {Quantity::acceleration, 1}},
    {"mm/s2", {Quantity::acceleration, 1e-3}},
    {"in/s2", {Quantity::acceleration, inch}},
    {"g", {Quantity::acceleration, standard_gravity}},
    {"gs", {Quantity::acceleration, standard_gravity}},
    {"g's", {Quantity::acceleration, standard_gravity}},
    {"rad", {Quantity::angle, 1}},
    {"deg", {Quantity::angle, pi / 180}},
    {"\u00b0", {Quantity::angle, pi / 180}},
    {"hz", {Quantity::turning, 1}},
    {"khz", {Quantity::turning, 1e3}},
    {"rev/s", {Quantity::turning, 1}},
    {"rpm", {Quantity::turning, 1.0 / 60}},
    {"krpm", {Quantity::turning, 1e3 / 60}},
    {"1/min", {Quantity::turning, 1.0 / 60}},
    {"min1", {Quantity::turning, 1.0 / 60}},
    {"rev/min", {Quantity::turning, 1.0 / 60}},
    {"r/min", {Quantity::turning, 1.0 / 60}},
    {"u/min", {Quantity::turning, 1.0 / 60}},
    {"rad/s", {Quantity::turning, 0.5 / pi}},
    {"1/s", {Quantity::rate, 1}},
    {"v", {Quantity::voltage, 1}},
    {"volt", {Quantity::voltage, 1}},
    {"volts", {Quantity::voltage, 1}},
    {"mv", {Quantity::voltage, 1e-3}},
    {"a", {Quantity::current, 1}},
    {"ma", {Quantity::current, 1e-3}},
    {"n", {Quantity::force, 1}},
    {"kN", {Quantity::force, 1e3}},
    {"lbf", {Quantity::force, pound}},
    {"n/m", {Quantity::stiffness, 1}},
    {"n/mm", {Quantity::stiffness, 1e3}},
    {"n/um", {Quantity::stiffness, 1e6}},
    {"kN/m", {Quantity::stiffness, 1e3}},
    {"kN/mm", {Quantity::stiffness, 1e6}},
    {"MN/m", {Quantity::stiffness, 1e6}},
    {"lbf/in", {Quantity::stiffness, lbf_per_in}},
    {"lb/in", {Quantity::stiffness, lbf_per_in}},
    {"ns/m", {Quantity::damping, 1}},
    {"kg/s", {Quantity::damping, 1}},
    {"ns/mm", {Quantity::damping, 1e3}},
    {"kNs/m", {Quantity::damping, 1e3}},
    {"MNs/m", {Quantity::damping, 1e6}},
    {"lbfs/in", {Quantity::damping, lbf_per_in}},
    {"lbs/in", {Quantity::damping, lbf_per_in}},
    {"kg", {Quantity::mass, 1}},
    {"lbfs2/in", {Quantity::mass, lbf_per_in}},
    {"lbs2/in", {Quantity::mass, lbf_per_in}},
    {"lbm", {Quantity::mass, 0.45359237}},
    {"pa", {Quantity::pressure, 1}},
    {"bar", {Quantity::pressure, 1e5}},
    {"psi", {Quantity::pressure, pound / (inch * inch)}},
    {"\u00b0c", {Quantity::temperature, 1}},
    {"k", {Quantity::temperature, 1}},
    {"%", {Quantity::share, 0.01}},
    {"fs", {Quantity::share, 1}},
}};

bool letters_count(std::string_view name) {
  return name.starts_with("MN") || name.starts_with("kN") || name.starts_with("mN") || name == "MV" ||
         name == "Nm";
}

}  // namespace

std::optional<Unit> unit_of(std::string_view words) {
  const std::string plain = plain_unit(words), small = in_small_letters(plain);
  const std::string_view sought = letters_count(plain) ? plain : small;
  const auto found = std::ranges::find(units, sought, &Named::name);
  return found == units.end() ? std::nullopt : std::optional(found->unit);
}

}  // namespace rubsweep::table
