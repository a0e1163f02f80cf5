#include "rubsweep/config/dataset/read_candidates.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "rubsweep/config/dataset/spread_field.hpp"
#include "rubsweep/config/yaml/section.hpp"

namespace rubsweep::config::dataset {
namespace {

using diagnose::Candidate;
using diagnose::Cause;
using diagnose::Unknown;

constexpr std::array<Cause, 5> causes{Cause::no_rub, Cause::one_side, Cause::two_sides, Cause::annular,
                                      Cause::annular_offset};
const std::array<std::string_view, 5>& words() {
  static const std::array<std::string_view, 5> all{to_string(causes[0]), to_string(causes[1]),
                                                   to_string(causes[2]), to_string(causes[3]),
                                                   to_string(causes[4])};
  return all;
}

/// Whether stops of this kind have a number.
bool has(Cause cause, const diagnose::UnknownRow& row) {
  if (!row.of_file || cause == Cause::no_rub) return false;
  if (row.unknown == Unknown::second_clearance_ratio) return cause == Cause::two_sides;
  if (row.unknown == Unknown::offset_ratio) return cause == Cause::annular_offset;
  return true;
}

Candidate read_candidate(const yaml::Value& value, Candidate (*usual)(Cause)) {
  if (value.node.kind == yaml::Node::Kind::scalar) {
    const auto index = yaml::read_word(value, words());
    return usual(causes[index.value_or(0)]);
  }
  yaml::Section section(value, "the word of a kind, or a map with kind and ranges");
  const auto index = section.require_kind("kind", words());
  if (!index) return usual(Cause::no_rub);
  Candidate candidate = usual(causes[*index]);
  if (const auto name = section.find("name")) candidate.name = yaml::read_text(*name).value_or("");
  section.field("weight", candidate.weight, model::positive);
  if (candidate.cause != Cause::no_rub)
    read_spread(section, "clearance_m", model::positive, true, candidate.clearance_m);
  for (const diagnose::UnknownRow& row : diagnose::unknown_rows())
    if (has(candidate.cause, row))
      read_spread(section, row.key, row.range, row.logarithmic, spread_of(candidate, row.unknown));
  section.refuse_unknown_keys();
  return candidate;
}

}  // namespace

std::vector<Candidate> read_candidates(const yaml::Value& value, Candidate (*usual)(Cause)) {
  constexpr std::size_t most = 20;
  std::vector<Candidate> candidates;
  const auto items = yaml::read_list(value, most);
  if (!items) return candidates;
  for (const yaml::Value& item : *items) {
    candidates.push_back(read_candidate(item, usual));
    const std::string& name = candidates.back().name;
    if (std::ranges::count(candidates, name, &Candidate::name) > 1)
      yaml::refuse(item, "has the name '" + name + "' as another candidate", "a name of its own");
  }
  return candidates;
}

}  // namespace rubsweep::config::dataset
