#include "rubsweep/analysis/branch/families/family_records.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <string>
#include <vector>

#include "rubsweep/analysis/branch/continuation/branch_point.hpp"
#include "rubsweep/core/vocabulary.hpp"

namespace rubsweep::branch::families {
namespace {

constexpr std::string_view settled_word = "settled", passage_word = "way", arrived_word = "arrives",
                           stays_word = "stays";

/// Words of a line, separated by single blanks.
class Words {
 public:
  explicit Words(std::string_view text) : rest_(text) {}

  bool empty() const { return rest_.empty(); }

  std::string_view next() {
    const std::string_view word = rest_.substr(0, rest_.find(' '));
    rest_.remove_prefix(std::min(rest_.size(), word.size() + 1));
    return word;
  }

  template <class Number>
  bool read(Number& number) {
    const std::string_view word = next();
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
    return error == std::errc() && end == word.data() + word.size() && !word.empty();
  }

 private:
  std::string_view rest_;
};

std::string text_of(const CellOrbit& orbit) {
  std::string text = fmt::format(" {} {} {}", to_string(orbit.closing), orbit.order, orbit.hits);
  for (const double number : orbit.state) text += fmt::format(" {}", number);
  return text;
}

std::optional<CellOrbit> read_orbit(Words& words) {
  CellOrbit orbit;
  const std::string_view closing = words.next();
  if (closing == to_string(orbits::Closing::in_the_turning_frame)) {
    orbit.closing = orbits::Closing::in_the_turning_frame;
  } else if (closing != to_string(orbits::Closing::with_the_shaft)) {
    return std::nullopt;
  }
  if (!words.read(orbit.order) || !words.read(orbit.hits) || orbit.order < 1) return std::nullopt;
  std::vector<double> numbers;
  while (!words.empty()) {
    if (!words.read(numbers.emplace_back())) return std::nullopt;
  }
  if (numbers.empty()) return std::nullopt;
  orbit.state = Eigen::Map<const Eigen::VectorXd>(numbers.data(), static_cast<Eigen::Index>(numbers.size()));
  return orbit;
}

/// Looks up the program's own constant that equals a word; empty where there is none.
std::string_view known_kind(std::string_view word) {
  const auto among = [word](const auto& texts) {
    const auto found = std::ranges::find(texts, word);
    return found == texts.end() ? std::string_view{} : *found;
  };
  const std::string_view event = among(words_of<continuation::EventKind>().texts);
  return event.empty() ? among(words_of<continuation::Ending>().texts) : event;
}

std::optional<Passage> read_passage(Words& words) {
  Passage passage;
  const std::string_view kind = words.next();
  if (!words.read(passage.parameter)) return std::nullopt;
  if (kind == arrived_word) {
    passage.arrived = read_orbit(words);
    return passage.arrived ? std::optional(passage) : std::nullopt;
  }
  passage.kind = known_kind(kind);
  return passage.kind.empty() ? std::nullopt : std::optional(passage);
}

}  // namespace

bool FamilyRecords::read(std::size_t cell, std::string_view line) {
  Words words(line);
  const std::string_view word = words.next();
  if (word == settled_word) {
    std::optional<CellOrbit> orbit;
    if (!words.empty() && !(orbit = read_orbit(words))) return false;
    settled_.try_emplace(cell, std::move(orbit));
    return true;
  }
  std::size_t from = 0, to = 0;
  if (word == stays_word) {
    int stays = 0;
    if (!words.read(to) || !words.read(stays) || !words.empty()) return false;
    stays_.try_emplace({cell, to}, stays != 0);
    return true;
  }
  if (word != passage_word || !words.read(from) || !words.read(to)) return false;
  auto passage = read_passage(words);
  if (!passage) return false;
  passages_.try_emplace({cell, from, to}, std::move(*passage));
  return true;
}

const std::optional<CellOrbit>* FamilyRecords::settled(std::size_t cell) const {
  const auto found = settled_.find(cell);
  return found == settled_.end() ? nullptr : &found->second;
}

void FamilyRecords::keep_settled(std::size_t cell, const std::optional<CellOrbit>& orbit) {
  settled_.insert_or_assign(cell, orbit);
  keep(cell, std::string(settled_word) + (orbit ? text_of(*orbit) : std::string()));
}

const Passage* FamilyRecords::passage(std::size_t seed, std::size_t from, std::size_t to) const {
  const auto found = passages_.find({seed, from, to});
  return found == passages_.end() ? nullptr : &found->second;
}

void FamilyRecords::keep_passage(std::size_t seed, std::size_t from, std::size_t to, const Passage& passage) {
  passages_.insert_or_assign({seed, from, to}, passage);
  keep(seed,
       fmt::format("{} {} {} {} {}{}", passage_word, from, to, passage.arrived ? arrived_word : passage.kind,
                   passage.parameter, passage.arrived ? text_of(*passage.arrived) : std::string()));
}

std::optional<bool> FamilyRecords::stays(std::size_t seed, std::size_t cell) const {
  const auto found = stays_.find({seed, cell});
  return found == stays_.end() ? std::nullopt : std::optional(found->second);
}

void FamilyRecords::keep_stays(std::size_t seed, std::size_t cell, bool stays) {
  stays_.insert_or_assign({seed, cell}, stays);
  keep(seed, fmt::format("{} {} {}", stays_word, cell, stays ? 1 : 0));
}

void FamilyRecords::keep(std::size_t cell, std::string_view line) const {
  if (keep_) keep_(cell, line);
}

}  // namespace rubsweep::branch::families
