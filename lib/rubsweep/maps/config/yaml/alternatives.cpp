#include "rubsweep/maps/config/yaml/alternatives.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <span>
#include <string>

#include "rubsweep/maps/config/yaml/text.hpp"

namespace rubsweep::config::yaml {
namespace {

using Keys = std::span<const std::string_view>;

constexpr std::array<std::string_view, 1> stribeck{"stribeck"}, one_way{"one_way"};
constexpr std::array<std::string_view, 4> holding{"static", "coefficient", "stribeck_speed_m_per_s",
                                                  "exponent"};
constexpr std::array<std::string_view, 5> curve{"static", "kinetic", "peak_speed_m_per_s",
                                                "settle_speed_m_per_s", "viscous_s_per_m"};
constexpr std::array<std::string_view, 1> stiffness{"stiffness_n_per_m"}, hertz{"hertz"};
constexpr std::array<std::string_view, 1> nominal{"restitution"}, by_rotor_mass{"restitution_by_rotor_mass"},
    delivered{"restitution_delivered"}, damping{"damping_ns_per_m"}, law{"law"};
constexpr std::array<std::string_view, 4> dampings{"restitution", "restitution_by_rotor_mass",
                                                   "restitution_delivered", "damping_ns_per_m"};
constexpr std::array<std::string_view, 1> speed_hz{"speed_hz"}, speed_rpm{"speed_rpm"};
constexpr std::array<std::string_view, 1> ratio{"whirl_ratio"}, eccentricity{"eccentricity_m"},
    unbalance{"unbalance_g_mm"};
constexpr std::array<std::string_view, 3> grade{"balance_grade_mm_per_s", "rated_speed_hz",
                                                "rated_speed_rpm"};
constexpr std::array<std::string_view, 1> rated_hz{"rated_speed_hz"}, rated_rpm{"rated_speed_rpm"};
constexpr std::array<std::string_view, 1> modal_stiffness{"modal_stiffness_n_per_m"},
    frequency_hz{"natural_frequency_hz"}, frequency_rad_per_s{"natural_frequency_rad_per_s"};
constexpr std::array<std::string_view, 1> damping_ratio{"damping_ratio"};
constexpr std::array<std::string_view, 1> listed_values{"values"}, one_key{"key"};
constexpr std::array<std::string_view, 2> tied_keys{"keys", "factors"};
constexpr std::array<std::string_view, 1> kick{"kick"}, start{"start"};
constexpr std::array<std::string_view, 5> spaced{"from", "to", "count", "scale", "step"};
constexpr std::array<std::string_view, 2> counted{"count", "scale"};
constexpr std::array<std::string_view, 1> stepped{"step"};

/// Alternative spellings. Each is a set of keys, and at most four exclude each other; empty sets are ignored.
constexpr std::array<std::array<Keys, 4>, 15> alternatives{{
    {stribeck, curve, holding, one_way},
    {stiffness, hertz},
    {stiffness, law},
    {dampings, law},
    {nominal, by_rotor_mass, delivered, damping},
    {speed_hz, speed_rpm},
    {ratio, eccentricity, unbalance, grade},
    {rated_hz, rated_rpm},
    {modal_stiffness, frequency_hz, frequency_rad_per_s},
    {frequency_hz, stiffness},
    {damping_ratio, damping},
    {listed_values, spaced},
    {counted, stepped},
    {one_key, tied_keys},
    {kick, start},
}};

bool holds(Keys keys, std::string_view key) { return std::find(keys.begin(), keys.end(), key) != keys.end(); }

bool exclude_each_other(std::string_view a, std::string_view b) {
  return std::any_of(alternatives.begin(), alternatives.end(), [&](const auto& ways) {
    const auto any = [&](const auto& of) { return std::ranges::any_of(ways, of); };
    return any([&](Keys keys) { return holds(keys, a); }) && any([&](Keys keys) { return holds(keys, b); }) &&
           !any([&](Keys keys) { return holds(keys, a) && holds(keys, b); });
  });
}

}  // namespace

void drop_entry(Node& map, std::size_t index) {
  map.keys.erase(map.keys.begin() + static_cast<std::ptrdiff_t>(index));
  map.items.erase(map.items.begin() + static_cast<std::ptrdiff_t>(index));
}

void drop_alternatives(Node& map, std::string_view written) {
  // `static` belongs to two friction laws. Beside other keys of a Stribeck curve it excludes only the key
  // `stribeck`.
  const bool of_a_curve = written != curve[0] && holds(holding, written) &&
                          std::ranges::any_of(map.keys, [](const Node::Key& key) {
                            return holds(Keys(curve).subspan(1), key.text);
                          });
  for (std::size_t i = map.keys.size(); i-- > 0;) {
    if (exclude_each_other(written, map.keys[i].text) || (of_a_curve && map.keys[i].text == curve[0]))
      drop_entry(map, i);
  }
}

void refuse_repeated_keys(const Node& map, std::string_view path, Diagnostics& diagnostics) {
  std::map<std::string_view, SourcePosition> first;
  for (const Node::Key& key : map.keys) {
    const auto [entry, is_new] = first.emplace(key.text, key.place);
    if (is_new) continue;
    const bool in_file = key.place.override_index < 0;
    const std::string first_line = in_file ? fmt::format(", first at line {}", entry->second.line) : "";
    diagnostics.add(key.place, child_path(path, key.text), "given again" + first_line, "each key once");
  }
}

void drop_repeated_keys(Node& map) {
  for (std::size_t i = map.keys.size(); i-- > 0;) {
    const auto is_equal = [&](const Node::Key& key) { return key.text == map.keys[i].text; };
    const auto end = map.keys.begin() + static_cast<std::ptrdiff_t>(i);
    if (std::any_of(map.keys.begin(), end, is_equal)) drop_entry(map, i);
  }
}

}  // namespace rubsweep::config::yaml
