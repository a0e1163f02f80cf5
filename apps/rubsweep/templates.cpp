#include "rubsweep/templates.hpp"

#include <algorithm>

namespace rubsweep::apps::templates {
namespace {

/// Head of a template that is given to a user. It replaces the line with the path of the schema in the
/// repository.
constexpr std::string_view head =
    "# yaml-language-server: $schema=rubsweep.schema.json\n"
    "# An editor completes and checks by that schema: rubsweep --schema > rubsweep.schema.json\n";

}  // namespace

std::vector<std::string_view> template_names() {
  std::vector<std::string_view> names;
  for (const Text& text : texts) names.push_back(text.name);
  return names;
}

std::optional<std::string> template_text(std::string_view name) {
  const auto found = std::ranges::find(texts, name, &Text::name);
  if (found == texts.end()) return std::nullopt;
  return std::string(head).append(found->yaml.substr(found->yaml.find('\n') + 1));
}

}  // namespace rubsweep::apps::templates
