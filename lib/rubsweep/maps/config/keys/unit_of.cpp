#include "rubsweep/maps/config/keys/unit_of.hpp"

#include <array>

namespace rubsweep::config::keys {
namespace {

struct Unit {
  std::string_view end, unit;
};
/// An end that is that of a longer one comes behind it.
constexpr std::array units{
    Unit{"_kg_per_m3", "kg/m3"},
    Unit{"_nms_per_rad", "N m s/rad"},
    Unit{"_nm_per_rad", "N m/rad"},
    Unit{"_ns_per_m", "N s/m"},
    Unit{"_n_per_m_n", "N/m^n"},
    Unit{"_n_per_m", "N/m"},
    Unit{"_mm_per_s", "mm/s"},
    Unit{"_m_per_s2", "m/s2"},
    Unit{"_rad_per_s", "rad/s"},
    Unit{"_rad_per_m", "rad/m"},
    Unit{"_m_per_s", "m/s"},
    Unit{"_s_per_m", "s/m"},
    Unit{"_per_s", "1/s"},
    Unit{"_kg_m2", "kg m2"},
    Unit{"_g_mm", "g mm"},
    Unit{"_deg", "degrees"},
    Unit{"_rpm", "1/min"},
    Unit{"_rad", "rad"},
    Unit{"_hz", "Hz"},
    Unit{"_kg", "kg"},
    Unit{"_ns", "N s"},
    Unit{"_pa", "Pa"},
    Unit{"_m2", "m2"},
    Unit{"_m4", "m4"},
    Unit{"_n", "N"},
    Unit{"_s", "s"},
    Unit{"_m", "m"},
};

}  // namespace

std::string_view unit_of(std::string_view key) {
  for (const auto& [end, unit] : units) {
    if (key.ends_with(end)) return unit;
  }
  return "";
}

}  // namespace rubsweep::config::keys
