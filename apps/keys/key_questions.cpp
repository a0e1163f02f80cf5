#include "keys/key_questions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "keys/key_list.hpp"
#include "keys/schema.hpp"
#include "rubsweep/maps/config/yaml/text.hpp"
#include "shared/program.hpp"

namespace rubsweep::apps {
namespace {

std::string keys_below(const std::vector<KeyRow>& rows, const std::string& path) {
  const std::vector<KeyRow> found = below(rows, path);
  if (!found.empty()) return text_of(found);
  std::vector<std::string_view> names;
  for (const KeyRow& row : rows) {
    names.push_back(row.path);
    names.push_back(std::string_view(row.path).substr(row.path.rfind('.') + 1));
  }
  const auto meant = config::yaml::nearest(path, names);
  throw UsageError(fmt::format("--keys: there is no key '{}'{}", path,
                               meant ? fmt::format(" (did you mean '{}'?)", *meant) : ""));
}

}  // namespace

void add_key_questions(po::options_description& options) {
  options.add_options()(
      "keys",
      "instead: say what each key of a configuration means, its unit, range and default; of all, "
      "or of those below PATH in place of CONFIG.yaml")(
      "schema", "instead: print the JSON Schema of a configuration, for an editor that completes and checks");
}

std::optional<std::string> key_answer(const po::variables_map& given, config::keys::Form (*configuration)(),
                                      std::string_view title) {
  if (given.count("help") != 0 || given.count("version") != 0) return std::nullopt;
  if (asks_for("schema", given)) return schema_of(configuration(), title);
  if (!asks_for("keys", given, "config")) return std::nullopt;
  return keys_below(key_list(configuration()),
                    given.count("config") != 0 ? given["config"].as<std::string>() : "");
}

}  // namespace rubsweep::apps
