#include "rubsweep/maps/config/yaml/diagnostics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>
#include <utility>

#include "rubsweep/core/error.hpp"
#include "rubsweep/maps/config/yaml/text.hpp"

namespace rubsweep::config::yaml {

std::strong_ordering SourcePosition::operator<=>(const SourcePosition& other) const {
  return std::tie(override_index, other.file, line, column) <=>
         std::tie(other.override_index, file, other.line, other.column);
}

Diagnostics::Diagnostics(std::string file, std::vector<std::string> overrides)
    : files_{std::move(file)}, overrides_(std::move(overrides)) {}

int Diagnostics::add_file(std::string name) {
  files_.push_back(std::move(name));
  return static_cast<int>(files_.size()) - 1;
}

const std::string& Diagnostics::file_of(const SourcePosition& place) const {
  return files_.at(place.override_index < 0 ? static_cast<std::size_t>(place.file) : 0);
}

std::string Diagnostics::describe(const SourcePosition& place) const {
  if (place.override_index < 0) {
    return fmt::format("{}:{}:{}", files_.at(static_cast<std::size_t>(place.file)), place.line, place.column);
  }
  return "--set " + shown(overrides_.at(static_cast<std::size_t>(place.override_index)), 200);
}

void Diagnostics::add(const SourcePosition& place, std::string_view path, std::string_view wrong,
                      std::string_view allowed) {
  std::string text = describe(place) + ": ";
  if (!path.empty()) text += fmt::format("{}: ", path);
  text += wrong;
  if (!allowed.empty()) text += fmt::format(", allowed: {}", allowed);
  problems_.push_back({place, std::move(text)});
}

void Diagnostics::throw_if_any() const {
  if (problems_.empty()) return;
  std::vector<Problem> sorted = problems_;
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const Problem& a, const Problem& b) { return a.place < b.place; });
  std::string message = sorted.front().text;
  for (std::size_t i = 1; i < sorted.size(); ++i) message += "\n" + sorted[i].text;
  throw ConfigError(message);
}

}  // namespace rubsweep::config::yaml
