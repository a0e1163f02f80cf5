#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "rubsweep/maps/config/keys/table.hpp"
#include "rubsweep/maps/config/machine/stop.hpp"
#include "rubsweep/maps/config/study/study.hpp"

namespace rubsweep::config::study {
namespace {

constexpr std::string_view at_rest = "rest";
constexpr std::string_view start_forms =
    "rest, or a map of x_m, y_m, vx_m_per_s, vy_m_per_s, casings, each optional";
constexpr std::string_view forms = "a map from the number of a stop to x_m, y_m, vx_m_per_s, vy_m_per_s";

std::vector<std::optional<model::BodyState>> read_casings(const yaml::Value& value,
                                                          const std::vector<model::Stop>& stops) {
  std::vector<std::string> names;  // owns the names, as the section keeps views of them
  for (std::size_t i = 0; i < stops.size(); ++i) names.push_back(std::to_string(i));
  std::vector<std::optional<model::BodyState>> casings(stops.size());
  yaml::Section section(value, forms);
  for (std::size_t i = 0; i < stops.size(); ++i) {
    const auto casing = section.find(names[i]);
    if (!casing) continue;
    if (!stops[i].casing) refuse(*casing, "is of a rigid casing, which has no state", "a casing that moves");
    read_map(*casing, casings[i].emplace());
  }
  return casings;
}

bool is_empty(const model::BodyState& body) {
  bool empty = true;
  model::BodyState::visit_fields(
      body, [&](const char*, const std::optional<double>& number, const auto&) { empty = empty && !number; });
  return empty;
}

}  // namespace

model::Start read_start(const yaml::Value& value, const std::vector<model::Stop>& stops) {
  model::Start start;
  if (value.node.kind == yaml::Node::Kind::scalar) {
    constexpr std::array words{at_rest};
    start.at_rest = read_word(value, words, start_forms).has_value();
    return start;
  }
  yaml::Section section(value, start_forms);
  read_fields(section, start.rotor);
  if (const auto casings = section.find("casings")) start.casings = read_casings(*casings, stops);
  return start;
}

keys::Form start_form() {
  using namespace keys;
  return any_of(
      {one_of({&at_rest, 1}),
       map_of(joined(
           {keys_of<model::BodyState>(),
            {newer_key(may("casings", numbered(map_of(keys_of<model::BodyState>()), machine::max_stops),
                           "states of moving casings, by the number of their stop", "(none)"))}}))});
}

void print_start(yaml::Printer& printer, const model::Start& start) {
  if (start.at_rest) return printer.word("start", at_rest);
  const auto given = [](const std::optional<model::BodyState>& body) { return body && !is_empty(*body); };
  const bool casings = std::ranges::any_of(start.casings, given);
  if (is_empty(start.rotor) && !casings) {
    printer.word("start", "{}");  // an empty block would read back as no value
    return;
  }
  printer.open("start");
  print_fields(printer, start.rotor);
  if (casings) printer.open("casings");
  for (std::size_t i = 0; i < start.casings.size(); ++i) {
    if (given(start.casings[i])) print_map(printer, std::to_string(i), *start.casings[i]);
  }
  if (casings) printer.close();
  printer.close();
}

}  // namespace rubsweep::config::study
