#include "slice_plane.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>
#include <string_view>

#include "rubsweep/core/contact/wall.hpp"
#include "rubsweep/core/model/element_name.hpp"
#include "shared/program.hpp"

namespace rubsweep::apps {
namespace {

constexpr std::string_view allowed =
    "two of x, y, vx, vy (the rotor) and casing0.x ... casing0.vy (the casing of stop 0), or keys such as "
    "kick.force_n, parted by a comma";
constexpr double usual_clearances = 2;

struct Component {
  std::string_view name, field;
};
constexpr std::array<Component, 4> components{
    {{"x", "x_m"}, {"y", "y_m"}, {"vx", "vx_m_per_s"}, {"vy", "vy_m_per_s"}}};

std::optional<StartNumber> component_of(std::string_view name) {
  const auto found = std::ranges::find(components, name, &Component::name);
  if (found == components.end()) return std::nullopt;
  return StartNumber{"start." + std::string(found->field), std::string(found->field), std::nullopt, true,
                     name.starts_with('v')};
}

/// Reads a component of a casing's state, such as "casing0.x"; empty for any other name.
std::optional<StartNumber> casing_component_of(std::string_view name) {
  constexpr std::string_view casing = "casing";
  const std::size_t dot = name.find('.');
  if (!name.starts_with(casing) || dot == std::string_view::npos) return std::nullopt;
  std::size_t stop = 0;
  const char* end = name.data() + dot;
  const auto [last, error] = std::from_chars(name.data() + casing.size(), end, stop);
  auto number = component_of(name.substr(dot + 1));
  if (error != std::errc() || last != end || !number) return std::nullopt;
  number->column = fmt::format("casing{}_{}", stop, number->column);
  number->key = fmt::format("start.casings.{}.{}", stop, number->key.substr(number->key.find('.') + 1));
  number->casing = stop;
  return number;
}

StartNumber number_of(const std::string& name, const std::string& plane) {
  if (const auto rotor = component_of(name)) return *rotor;
  if (const auto casing = casing_component_of(name)) return *casing;
  if (name.find('.') != std::string::npos) return {name, name, std::nullopt, false, false};
  throw UsageError(fmt::format("--plane {}: there is no '{}', allowed: {}", plane, name, allowed));
}

}  // namespace

std::array<StartNumber, 2> read_plane(const std::string& text) {
  const std::size_t comma = text.find(',');
  if (comma == std::string::npos) throw UsageError(fmt::format("--plane {}: allowed: {}", text, allowed));
  std::array<StartNumber, 2> plane{number_of(text.substr(0, comma), text),
                                   number_of(text.substr(comma + 1), text)};
  if (plane[0].key == plane[1].key)
    throw UsageError(fmt::format("--plane {}: allowed: two different numbers", text));
  return plane;
}

std::array<StartNumber, 2> usual_plane(const model::Stop& first) {
  const contact::Wall wall = contact::wall_of(first.geometry);
  const Eigen::Vector2d normal = contact::normal_at(wall, contact::offset(wall));
  const bool upright = !contact::centred(wall) && std::abs(normal.y()) > std::abs(normal.x());
  return read_plane(upright ? "y,vy" : "x,vx");
}

StartRange usual_range(const StartNumber& number, const config::RunConfig& config, double speed_hz) {
  if (!number.is_state) {
    throw UsageError(
        fmt::format("--plane: {} has no usual range, --from A,B and --to C,D are needed", number.key));
  }
  const double length_m = usual_clearances * config.study.machine.stops.front().clearance_m;
  const double end = number.is_velocity ? 2 * std::numbers::pi * speed_hz * length_m : length_m;
  return {-end, end};
}

void refuse_missing_casing(const StartNumber& number, const config::RunConfig& config) {
  if (!number.casing) return;
  const auto& stops = config.study.machine.stops;
  if (*number.casing >= stops.size()) {
    throw UsageError(fmt::format("--plane: there is no stop {}, allowed: casing0 to casing{}", *number.casing,
                                 stops.size() - 1));
  }
  if (!stops[*number.casing].casing) {
    throw UsageError(
        fmt::format("--plane: the casing of stop {}{} is rigid, allowed: one that moves", *number.casing,
                    model::in_brackets(model::name_at(config.study.stop_names, *number.casing))));
  }
}

}  // namespace rubsweep::apps
