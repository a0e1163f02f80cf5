#include "probe_argument.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <limits>
#include <numbers>
#include <string_view>

#include "rubsweep/core/error.hpp"
#include "rubsweep/core/model/element_name.hpp"
#include "shared/command_line.hpp"
#include "shared/program.hpp"

namespace rubsweep::apps {
namespace {

constexpr std::string_view form =
    "PLACE:QUANTITY:ANGLE_DEG[:NOISE] with PLACE shaft, stopN or shaft-stopN and QUANTITY displacement, "
    "velocity or acceleration";

template <class Number>
bool read_number(std::string_view text, Number& number) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc() && end == text.data() + text.size();
}

bool read_place(std::string_view text, ProbeArgument& probe) {
  if (text == "shaft") return true;
  probe.on_shaft = text.starts_with("shaft-");
  if (probe.on_shaft) text.remove_prefix(6);
  if (!text.starts_with("stop")) return false;
  return read_number(text.substr(4), probe.stop.emplace());
}

bool read_quantity(std::string_view text, ProbeArgument& probe) {
  constexpr std::array<std::string_view, 3> words{"displacement", "velocity", "acceleration"};
  const auto found = std::ranges::find(words, text);
  probe.derivative = static_cast<int>(found - words.begin());
  return found != words.end();
}

/// Map from the coordinates to the displacement (x, y) that a probe reads.
Eigen::Matrix<double, 2, Eigen::Dynamic> map_of(const ProbeArgument& probe,
                                                const structure::Assembly& assembly) {
  const auto at = [&](int point) { return assembly.system.points[static_cast<std::size_t>(point)].map; };
  if (!probe.stop) return at(assembly.observed_point);
  const auto refuse = [&](const std::string& wrong, const std::string& allowed) {
    throw ConfigError(fmt::format("--probe {}: {}, allowed: {}", probe.text, wrong, allowed));
  };
  const std::size_t stops = assembly.casing_points.size();
  if (*probe.stop >= stops)
    refuse(fmt::format("the machine has no stop {}", *probe.stop), fmt::format("stop0 to stop{}", stops - 1));
  const std::optional<int> casing = assembly.casing_points[*probe.stop];
  if (!probe.on_shaft && !casing)
    refuse(fmt::format("the wall of stop {} does not move", *probe.stop), "a stop with a casing");
  if (!probe.on_shaft) return at(*casing);
  const auto shaft = at(assembly.rotor_points[*probe.stop]);
  return casing ? Eigen::Matrix<double, 2, Eigen::Dynamic>(shaft - at(*casing)) : shaft;
}

}  // namespace

ProbeArgument probe_of(const std::string& text) {
  ProbeArgument probe{.text = text};
  const std::vector<std::string_view> parts = parts_of(text, ':');
  const bool sound = (parts.size() == 3 || parts.size() == 4) && read_place(parts[0], probe) &&
                     read_quantity(parts[1], probe) && read_number(parts[2], probe.angle_deg) &&
                     (parts.size() == 3 || read_number(parts[3], probe.noise)) &&
                     std::isfinite(probe.angle_deg) && std::isfinite(probe.noise) && probe.noise >= 0;
  if (!sound) throw UsageError(fmt::format("--probe: '{}' is not understood, allowed: {}", text, form));
  return probe;
}

trace::Probes probes_of(const std::vector<ProbeArgument>& arguments, const scene::PreparedMachine& prepared,
                        double sample_s, const std::vector<std::string>& stop_names) {
  trace::Probes probes{.rows = {}, .angle_deg = {}, .sample_s = sample_s};
  probes.rows.resize(static_cast<Eigen::Index>(arguments.size()), prepared.assembly.system.coordinates());
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const ProbeArgument& probe = arguments[i];
    const auto map = map_of(probe, prepared.assembly);
    const double angle = probe.angle_deg * std::numbers::pi / 180;
    probes.rows.row(static_cast<Eigen::Index>(i)) =
        std::cos(angle) * map.row(0) + std::sin(angle) * map.row(1);
    probes.angle_deg.push_back(probe.angle_deg);
    probes.derivative.push_back(probe.derivative);
    probes.noise.push_back(probe.noise);
    probes.name.push_back(probe.stop ? model::name_at(stop_names, *probe.stop) : "");
  }
  return probes;
}

std::vector<double> places_of(const std::vector<ProbeArgument>& arguments) {
  std::vector<double> places;
  for (const ProbeArgument& probe : arguments) {
    const double place = probe.stop ? 2 * static_cast<double>(*probe.stop) + (probe.on_shaft ? 1 : 0) : -1;
    places.push_back(probe.derivative == 0 ? place : std::numeric_limits<double>::quiet_NaN());
  }
  return places;
}

}  // namespace rubsweep::apps
