#include "rubsweep/config/machine/rotor_parts.hpp"

#include <array>
#include <optional>

#include "rubsweep/model/disc_geometry.hpp"
#include "rubsweep/model/rolling_bearing.hpp"

namespace rubsweep::config::machine {
namespace {

constexpr std::array<std::string_view, 4> defects{"outer_race", "inner_race", "ball", "cage"};

std::optional<double> read_strikes(const yaml::Value& value) {
  yaml::Section section(value);
  model::RollingBearing bearing;
  const auto defect = section.require_kind("defect", defects);
  read_fields(section, bearing);
  section.refuse_unknown_keys();
  if (section.is_sound() && bearing.ball_diameter_m >= bearing.pitch_diameter_m) {
    section.refuse_together("ball_diameter_m", {"ball_diameter_m", "pitch_diameter_m"},
                            "leaves no room for a shaft", "a number below pitch_diameter_m");
  }
  if (!section.is_sound() || !defect) return std::nullopt;
  return model::strikes_per_revolution(bearing, static_cast<model::BearingDefect>(*defect));
}

}  // namespace

void read_disc_geometry(yaml::Section& section, model::Disc& disc) {
  const auto value = section.find("geometry");
  if (!value) return;
  for (const std::string_view number : {"mass_kg", "polar_inertia_kg_m2", "diametral_inertia_kg_m2"}) {
    if (section.find(number)) section.require_exactly_one({number, "geometry"});
  }
  yaml::Section inner(*value);
  model::DiscGeometry geometry;
  read_fields(inner, geometry);
  inner.refuse_unknown_keys();
  if (inner.is_sound() && geometry.inner_diameter_m >= geometry.outer_diameter_m) {
    inner.refuse_together("inner_diameter_m", {"inner_diameter_m"}, "no disc is left",
                          "a number below outer_diameter_m");
  }
  // Where something is wrong, numbers that nobody misses: the disc is not used.
  const bool sound = inner.is_sound();
  disc.mass_kg = sound ? geometry.mass_kg() : 0;
  disc.polar_inertia_kg_m2 = sound ? geometry.polar_inertia_kg_m2() : 0;
  disc.diametral_inertia_kg_m2 = sound ? geometry.diametral_inertia_kg_m2() : 0;
}

model::BearingFault read_bearing_fault(const yaml::Value& value) {
  yaml::Section section(value);
  model::BearingFault fault;
  if (const auto bearing = section.find("bearing")) {
    if (section.find("multiple")) section.require_exactly_one({"multiple", "bearing"});
    fault.multiple = read_strikes(*bearing).value_or(1);
  }
  read_fields(section, fault);
  section.refuse_unknown_keys();
  return fault;
}

}  // namespace rubsweep::config::machine
