#include "keys/schema.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "rubsweep/core/model/range.hpp"

namespace rubsweep::apps {

using namespace config::keys;

namespace {

using Json = nlohmann::ordered_json;

/// JSON number, written without a decimal point where it is whole.
Json number_json(double value) {
  constexpr double most_digits = 1e15;
  if (std::trunc(value) == value && std::abs(value) <= most_digits) return static_cast<long long>(value);
  return value;
}

Json number_schema(const model::Range& range) {
  Json schema{{"type", "number"}};
  const auto bound = [&](double value, bool open, const char* plain, const char* exclusive, double most) {
    const bool given = std::isfinite(value);
    schema[open && given ? exclusive : plain] = number_json(given ? value : most);
  };
  using model::largest_magnitude;
  bound(range.low, range.low_open, "minimum", "exclusiveMinimum", -largest_magnitude);
  bound(range.high, range.high_open, "maximum", "exclusiveMaximum", largest_magnitude);
  return schema;
}

/// A number of the rotor, which may say the interval in which it lies (config/intervals.hpp).
Json number_or_interval(const model::Range& range) {
  const Json any = number_schema(model::any_finite);
  return {{"anyOf",
           {number_schema(range),
            {{"type", "object"},
             {"additionalProperties", false},
             {"required", {"value", "from", "to"}},
             {"properties", {{"value", number_schema(range)}, {"from", any}, {"to", any}}}}}}};
}

/// Regular expression that matches the numbers from 0 to count - 1; `count` is between 11 and 20.
std::string numbers_below(std::size_t count) { return fmt::format("^([0-9]|1[0-{}])$", count - 11); }

/// Schema of a key that must not be given. In a part written over a base, null may remove the base's key.
Json nothing(bool part) { return part ? Json{{"type", "null"}} : Json(false); }

/// Schema without its empty lists `required` and `allOf`.
Json stripped(Json schema) {
  for (const char* name : {"required", "allOf"}) {
    if (schema.contains(name) && schema[name].empty()) schema.erase(name);
  }
  return schema;
}

Json condition(const Key& key, bool part) {
  const Condition& when = key.when;
  const bool demands = key.required && !part, needs_selector = !when.without_selector && !part;
  Json holds{{"required", needs_selector ? Json::array({when.selector}) : Json::array()},
             {"properties", {{when.selector, {{"enum", when.words}}}}}};
  return {{"if", stripped(std::move(holds))},
          {"then", demands ? Json{{"required", Json::array({key.name})}} : Json(true)},
          {"else", {{"properties", {{key.name, nothing(part)}}}}}};
}

Json choice_schema(const Choice& choice, bool part) {
  std::set<std::string> all;
  for (const Way& way : choice.ways) {
    all.insert(way.required.begin(), way.required.end());
    all.insert(way.optional.begin(), way.optional.end());
  }
  std::vector<Way> ways = choice.ways;
  if (choice.may_be_none) ways.emplace_back();
  Json forms = Json::array();
  for (const Way& way : ways) {
    Json others = Json::object();
    for (const std::string& name : all) {
      if (std::ranges::count(way.required, name) + std::ranges::count(way.optional, name) == 0)
        others[name] = nothing(part);
    }
    forms.push_back(
        stripped({{"required", part ? Json::array() : Json(way.required)}, {"properties", others}}));
  }
  return {{"anyOf", forms}};
}

/// Path of a definition. Several forms of a map at the same place get different paths, by their kind or
/// number.
std::string path_of_form(const Form& form, const std::string& path, int map) {
  if (form.kind != Kind::map) return path;
  const bool named = !form.keys.empty() && form.keys[0].name == "kind";
  if (named) return path + "." + form.keys[0].form.words[0];
  return map == 1 ? path : fmt::format("{}.form{}", path, map);
}

/// Writes every map of a configuration as two definitions: as a whole map, and as a part that is written over
/// a base.
class Writer {
 public:
  Json value(const Form& form, const std::string& path, bool part) {
    Json schema;
    switch (form.kind) {
      case Kind::number:
        return path.starts_with("configuration.rotor.") ? number_or_interval(form.range)
                                                        : number_schema(form.range);
      case Kind::integer:
        schema = {{"type", "integer"}, {"minimum", form.low}, {"maximum", form.high}};
        if (form.even) schema["multipleOf"] = 2;
        return schema;
      case Kind::word: return {{"enum", form.words}};
      case Kind::text:
        return {
            {"type", {"string", "number", "boolean"}}, {"minLength", form.least}, {"maxLength", form.most}};
      case Kind::list:
        schema = {{"type", "array"}, {"minItems", form.least}, {"maxItems", form.most}};
        if (form.different) schema["uniqueItems"] = true;
        schema["items"] = value(form.forms[0], path + ".N", false);
        return schema;
      case Kind::numbered:
        return {{"type", "object"},
                {"properties", {{"base", base()}}},
                {"patternProperties", {{numbers_below(form.most), value(form.forms[0], path + ".N", part)}}},
                {"additionalProperties", false}};
      case Kind::any_of: return any_of(form, path, part);
      case Kind::map: break;
    }
    define(form, path, part);
    return reference(path, part);
  }

  /// Definitions as JSON text, one a line.
  std::string definitions() const {
    std::string text;
    for (const auto& [name, schema] : definitions_)
      text += fmt::format("{}{}:{}", text.empty() ? "" : ",\n", Json(name).dump(), schema.dump());
    return text;
  }

 private:
  static constexpr const char* part_end = ".over_base";

  static Json base() {
    return {{"type", "string"},
            {"minLength", 1},
            {"description", "file that this map is written over, relative to the one it stands in"}};
  }

  static Json reference(const std::string& path, bool part) {
    return {{"$ref", "#/definitions/" + path + (part ? part_end : "")}};
  }

  Json any_of(const Form& form, const std::string& path, bool part) {
    Json forms = Json::array();
    int maps = 0;
    for (const Form& one : form.forms) {
      maps += one.kind == Kind::map;
      forms.push_back(value(one, path_of_form(one, path, maps), part));
    }
    return {{"anyOf", forms}};
  }

  void define(const Form& form, const std::string& path, bool part) {
    const std::string name = path + (part ? part_end : "");
    if (!taken_.insert(name).second) return;
    if (!part) define(form, path, true);
    Json schema = body(form, path, part);
    if (!part) {
      schema = {{"type", "object"},
                {"if", {{"required", Json::array({"base"})}}},
                {"then", reference(path, true)},
                {"else", std::move(schema)}};
    }
    definitions_[name] = std::move(schema);
  }

  Json body(const Form& form, const std::string& path, bool part) {
    Json properties{{"base", base()}}, required = Json::array(), rules = Json::array();
    for (const Key& key : form.keys) {
      if (key.name == "base") continue;
      properties[key.name] = property(key, path, part);
      const bool unconditional = key.when.words.empty() && !is_chosen(form, key.name);
      if (key.required && unconditional && !part) required.push_back(key.name);
      if (!key.when.words.empty()) rules.push_back(condition(key, part));
    }
    for (const Choice& choice : form.choices) rules.push_back(choice_schema(choice, part));
    return stripped({{"type", "object"},
                     {"additionalProperties", false},
                     {"required", std::move(required)},
                     {"allOf", std::move(rules)},
                     {"properties", std::move(properties)}});
  }

  Json property(const Key& key, const std::string& path, bool part) {
    const std::string_view unit = unit_of(key.name);
    std::string said =
        key.meaning + (unit.empty() ? "" : fmt::format(" [{}]", unit)) + ". Allowed: " + allowed(key.form);
    if (!key.fallback.empty()) said += ". Default: " + key.fallback;
    Json inner = value(key.form, path.empty() ? key.name : path + "." + key.name, part);
    if (part) inner = {{"anyOf", Json::array({std::move(inner), Json{{"type", "null"}}})}};
    // Draft 7 ignores keys next to a reference, so that the reference is written inside an `allOf`.
    return {{"description", said}, {"allOf", Json::array({std::move(inner)})}};
  }

  std::map<std::string, Json> definitions_;
  std::set<std::string> taken_;
};

}  // namespace

std::string schema_of(const Form& root, std::string_view title) {
  Writer writer;
  const Json whole = Json::array({writer.value(root, "configuration", false)});
  return fmt::format(
      "{{\"$schema\":\"http://json-schema.org/draft-07/schema#\",\n\"title\":{},\n\"allOf\":{},\n"
      "\"definitions\":{{\n{}\n}}}}\n",
      Json(title).dump(), whole.dump(), writer.definitions());
}

}  // namespace rubsweep::apps
