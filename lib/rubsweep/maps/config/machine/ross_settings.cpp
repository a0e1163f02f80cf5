#include "rubsweep/maps/config/machine/ross_settings.hpp"

#include <fmt/format.h>

#include <charconv>
#include <optional>

#include "rubsweep/core/model/physical_range.hpp"
#include "rubsweep/maps/config/yaml/section.hpp"
#include "rubsweep/maps/config/yaml/text.hpp"

namespace rubsweep::config::machine {
namespace {

constexpr int latest_version = 3, first_with_whirl_tables = 3;

/// The first number of "3.0.0"; empty where there is none.
std::optional<int> main_version(std::string_view text) {
  int number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  const bool whole = end == text.data() + text.size() || *end == '.';
  return error == std::errc() && whole && number >= 0 ? std::optional(number) : std::nullopt;
}

int read_version(const yaml::Value& value) {
  const auto version =
      value.node.kind == yaml::Node::Kind::scalar ? main_version(value.node.text) : std::nullopt;
  if (version && *version <= latest_version) return *version;
  refuse(value, fmt::format("'{}' is no version whose files are known", yaml::shown(value.node.text)),
         fmt::format("\"0\" to \"{}\" and what follows after a point", latest_version));
  return 0;
}

void read_damping(yaml::Section& parameters, RossSettings& settings) {
  const auto number = [&](std::string_view name, double& target, const model::Range& range) {
    const auto value = parameters.find(name);
    if (value && value->node.kind != yaml::Node::Kind::null) parameters.field(name, target, range);
  };
  number("alpha", settings.mass_damping_per_s, model::physical::rate_per_s);
  number("beta", settings.stiffness_damping_s, model::physical::duration_s);
  const auto ratios = parameters.find("modal_damping_ratio");
  if (!ratios || ratios->node.kind == yaml::Node::Kind::null) return;
  if (ratios->node.kind == yaml::Node::Kind::list && ratios->node.items.empty()) return;
  refuse(
      *ratios,
      "counts modes of torsion and along the axis among those of bending, and no bearing holds these modes",
      "none, and damping_ratio beside the name of the file");
}

}  // namespace

bool is_ross_setting(std::string_view key) {
  return key == "parameters" || key == "ross_version" || key == "_note";
}

RossSettings read_ross_settings(const yaml::Value& file) {
  RossSettings settings;
  for (std::size_t i = 0; i < file.node.items.size(); ++i) {
    const std::string& name = file.node.keys[i].text;
    const yaml::Value value{file.node.items[i], yaml::child_path(file.path, name), file.diagnostics};
    if (name == "ross_version") settings.whirl_tables = read_version(value) >= first_with_whirl_tables;
    if (name != "parameters") continue;
    yaml::Section parameters(value);
    // Speeds of plots, and the ratio that goes on after those of modes, which are refused.
    for (const std::string_view ignored : {"min_w", "max_w", "rated_w", "tag", "default_damping_ratio"})
      parameters.find(ignored);
    read_damping(parameters, settings);
    parameters.refuse_unknown_keys();
  }
  return settings;
}

}  // namespace rubsweep::config::machine
