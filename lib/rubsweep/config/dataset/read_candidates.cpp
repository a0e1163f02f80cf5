#include "rubsweep/config/dataset/read_candidates.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "rubsweep/config/dataset/spread_field.hpp"
#include "rubsweep/config/yaml/section.hpp"
#include "rubsweep/config/yaml/text.hpp"

namespace rubsweep::config::dataset {
namespace {

using diagnose::Candidate;
using diagnose::Cause;
using diagnose::Unknown;

const auto& words() {
  static const auto all = [] {
    std::array<std::string_view, diagnose::all_causes.size()> words;
    std::ranges::transform(diagnose::all_causes, words.begin(), diagnose::to_string);
    return words;
  }();
  return all;
}

/// Whether stops of this kind have a number.
bool has(Cause cause, const diagnose::UnknownRow& row) {
  if (!row.of_file || cause == Cause::no_rub) return false;
  if (row.unknown == Unknown::second_clearance_ratio) return cause == Cause::two_sides;
  if (row.unknown == Unknown::offset_ratio) return cause == Cause::annular_offset;
  return true;
}

/// Reads the name, which is a cell of a table: a program for tables would take one that begins as a formula
/// for one, and compute it.
void read_name(const yaml::Value& value, std::string& name) {
  const auto text = yaml::read_text(value);
  if (!text) return;
  if (std::ranges::any_of(*text, yaml::is_control)) {
    yaml::refuse(value, "is no name", "one line of text");
  } else if (text->find_first_of("=+-@") == 0) {
    yaml::refuse(value, "is no name", "one line of text that does not begin with = + - @");
  } else {
    name = *text;
  }
}

std::optional<Candidate> read_candidate(const yaml::Value& value, bool of_any_rotor) {
  if (value.node.kind == yaml::Node::Kind::scalar) {
    const auto index = yaml::read_word(value, words());
    if (!index) return std::nullopt;
    return diagnose::usual_candidate(diagnose::all_causes[*index]);
  }
  yaml::Section section(value, "the word of a kind, or a map with kind and ranges");
  const auto index = section.require_kind("kind", words());
  if (!index) return std::nullopt;
  Candidate candidate = diagnose::usual_candidate(diagnose::all_causes[*index]);
  if (const auto name = section.find("name")) read_name(*name, candidate.name);
  if (candidate.cause != Cause::no_rub)
    read_spread(section, "clearance_m", model::positive, true, candidate.clearance_m);
  for (const diagnose::UnknownRow& row : diagnose::unknown_rows())
    if (has(candidate.cause, row))
      read_spread(section, row.key, row.range, row.logarithmic, spread_of(candidate, row.unknown));
  if (of_any_rotor && candidate.cause != Cause::no_rub && section.find("position_m"))
    read_spread(section, "position_m", model::not_negative, false, candidate.position_m.emplace());
  section.refuse_unknown_keys();
  return candidate;
}

}  // namespace

std::vector<Candidate> read_candidates(const yaml::Value& value, bool of_any_rotor) {
  constexpr std::size_t most = 20;
  std::vector<Candidate> candidates;
  const auto items = yaml::read_list(value, most);
  if (!items) return candidates;
  for (const yaml::Value& item : *items) {
    auto candidate = read_candidate(item, of_any_rotor);
    if (!candidate) continue;
    if (std::ranges::count(candidates, candidate->name, &Candidate::name) > 0)
      yaml::refuse(item, "has the name '" + candidate->name + "' as another candidate", "a name of its own");
    candidates.push_back(*std::move(candidate));
  }
  return candidates;
}

}  // namespace rubsweep::config::dataset
