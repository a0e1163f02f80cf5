#include "rubsweep/maps/config/keys/schema.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "rubsweep/core/model/magnitude.hpp"
#include "rubsweep/maps/config/keys/unit_of.hpp"
#include "rubsweep/maps/config/yaml/json_string.hpp"

namespace rubsweep::config::keys {
namespace {

using yaml::json_list;
using yaml::json_string;

std::string joined(const std::vector<std::string>& parts, const char* between = ",") {
  std::string result;
  for (const std::string& part : parts) result.append(result.empty() ? "" : between).append(part);
  return result;
}

std::string number_schema(const model::Range& range) {
  const auto bound = [](double value, bool open, const char* plain, const char* exclusive, double most) {
    return fmt::format("\"{}\":{}", open && std::isfinite(value) ? exclusive : plain,
                       std::isfinite(value) ? value : most);
  };
  using model::largest_magnitude;
  return "{\"type\":\"number\"," +
         bound(range.low, range.low_open, "minimum", "exclusiveMinimum", -largest_magnitude) + "," +
         bound(range.high, range.high_open, "maximum", "exclusiveMaximum", largest_magnitude) + "}";
}

/// Writes the maps of a configuration as definitions, each as a whole and as a part of what is written over a
/// base.
class Writer {
 public:
  std::string value(const Form& form, const std::string& path, bool part) {
    switch (form.kind) {
      case Kind::number:
        return number_schema(form.range);
      case Kind::integer:
        return fmt::format("{{\"type\":\"integer\",\"minimum\":{},\"maximum\":{}{}}}", form.low, form.high,
                           form.even ? ",\"multipleOf\":2" : "");
      case Kind::word:
        return "{\"enum\":" + json_list(form.words) + "}";
      case Kind::text:
        return fmt::format(R"({{"type":["string","number","boolean"],"minLength":{},"maxLength":{}}})",
                           form.least, form.most);
      case Kind::list:
        return fmt::format(R"({{"type":"array","minItems":{},"maxItems":{}{},"items":{}}})", form.least,
                           form.most, form.different ? ",\"uniqueItems\":true" : "",
                           value(form.forms[0], path + ".N", false));
      case Kind::numbered:
        return fmt::format(
            R"({{"type":"object","properties":{{"base":{}}},"patternProperties":{{"{}":{}}},"additionalProperties":false}})",
            base, numbers_below(form.most), value(form.forms[0], path + ".N", part));
      case Kind::any_of:
        return any_of(form, path, part);
      case Kind::map:
        break;
    }
    define(form, path, part);
    return fmt::format(R"({{"$ref":"#/definitions/{}{}"}})", path, part ? part_end : "");
  }

  std::string definitions() const {
    std::vector<std::string> parts;
    for (const auto& [name, text] : definitions_) parts.push_back(json_string(name) + ":" + text);
    return joined(parts, ",\n");
  }

 private:
  static constexpr const char* part_end = ".over_base";
  static constexpr const char* base =
      R"({"type":"string","minLength":1,"description":"file that this map is written over, relative to the one it stands in"})";

  /// Numbers from 0 to count - 1 (10 to 99), as a pattern.
  static std::string numbers_below(std::size_t count) {
    const std::size_t last = count - 1;
    return fmt::format("^([0-9]|1[0-{}])$", last - 10);
  }

  std::string any_of(const Form& form, const std::string& path, bool part) {
    std::vector<std::string> forms;
    int maps = 0;
    for (const Form& one : form.forms) {
      maps += one.kind == Kind::map;
      forms.push_back(value(one, path_of_form(one, path, maps), part));
    }
    return "{\"anyOf\":[" + joined(forms) + "]}";
  }

  /// Maps that stand at the same place are different definitions.
  static std::string path_of_form(const Form& form, const std::string& path, int map) {
    if (form.kind != Kind::map) return path;
    const bool named = !form.keys.empty() && form.keys[0].name == "kind";
    if (named) return path + "." + form.keys[0].form.words[0];
    return map == 1 ? path : fmt::format("{}.form{}", path, map);
  }

  void define(const Form& form, const std::string& path, bool part) {
    const std::string name = path + (part ? part_end : "");
    if (!taken_.insert(name).second) return;
    if (part) {
      definitions_[name] = body(form, path, true);
      return;
    }
    define(form, path, true);
    definitions_[name] = fmt::format(
        R"({{"type":"object","if":{{"required":["base"]}},"then":{{"$ref":"#/definitions/{}{}"}},"else":{}}})",
        path, part_end, body(form, path, false));
  }

  std::string body(const Form& form, const std::string& path, bool part) {
    std::vector<std::string> properties{"\"base\":" + std::string(base)}, required, rules;
    for (const Key& key : form.keys) {
      if (key.name == "base") continue;
      properties.push_back(json_string(key.name) + ":" + property(key, path, part));
      const bool unconditional = key.when.words.empty() && !is_chosen(form, key.name);
      if (key.required && unconditional && !part) required.push_back(key.name);
      if (!key.when.words.empty()) rules.push_back(condition(key, part));
    }
    for (const Choice& choice : form.choices) rules.push_back(choice_schema(choice, part));
    return fmt::format(R"({{"type":"object","additionalProperties":false{}{},"properties":{{{}}}}})",
                       required.empty() ? "" : ",\"required\":" + json_list(required),
                       rules.empty() ? "" : ",\"allOf\":[" + joined(rules) + "]",
                       joined(properties, ",\n  "));
  }

  std::string property(const Key& key, const std::string& path, bool part) {
    const std::string_view unit = unit_of(key.name);
    std::string said =
        key.meaning + (unit.empty() ? "" : fmt::format(" [{}]", unit)) + ". Allowed: " + allowed(key.form);
    if (!key.fallback.empty()) said += ". Default: " + key.fallback;
    std::string inner = value(key.form, path.empty() ? key.name : path + "." + key.name, part);
    if (part) inner = "{\"anyOf\":[" + inner + ",{\"type\":\"null\"}]}";
    // Beside a reference draft 7 knows nothing.
    return fmt::format("{{\"description\":{},\"allOf\":[{}]}}", json_string(said), inner);
  }

  static std::string condition(const Key& key, bool part) {
    const Condition& when = key.when;
    const bool needs_selector = !when.without_selector && !part;
    return fmt::format(
        R"({{"if":{{{}"properties":{{{}:{{"enum":{}}}}}}},"then":{},"else":{{"properties":{{{}:{}}}}}}})",
        needs_selector ? "\"required\":" + json_list({when.selector}) + "," : "", json_string(when.selector),
        json_list(when.words),
        key.required && !part ? "{\"required\":" + json_list({key.name}) + "}" : "true",
        json_string(key.name), nothing(part));
  }

  /// A key that must not be there; over a base it may take that back.
  static std::string nothing(bool part) { return part ? "{\"type\":\"null\"}" : "false"; }

  static std::string choice_schema(const Choice& choice, bool part) {
    std::set<std::string> all;
    for (const Way& way : choice.ways) {
      all.insert(way.required.begin(), way.required.end());
      all.insert(way.optional.begin(), way.optional.end());
    }
    std::vector<Way> ways = choice.ways;
    if (choice.may_be_none) ways.emplace_back();
    std::vector<std::string> forms;
    for (const Way& way : ways) {
      std::vector<std::string> others;
      for (const std::string& name : all) {
        if (std::ranges::count(way.required, name) + std::ranges::count(way.optional, name) == 0)
          others.push_back(json_string(name) + ":" + nothing(part));
      }
      const bool demands = !part && !way.required.empty();
      forms.push_back(fmt::format("{{{}\"properties\":{{{}}}}}",
                                  demands ? "\"required\":" + json_list(way.required) + "," : "",
                                  joined(others)));
    }
    return "{\"anyOf\":[" + joined(forms) + "]}";
  }

  std::map<std::string, std::string> definitions_;
  std::set<std::string> taken_;
};

}  // namespace

std::string schema_of(const Form& root, std::string_view title) {
  Writer writer;
  const std::string whole = writer.value(root, "configuration", false);
  return fmt::format(
      "{{\"$schema\":\"http://json-schema.org/draft-07/"
      "schema#\",\n\"title\":{},\n\"allOf\":[{}],\n\"definitions\":{{\n{}\n}}}}\n",
      json_string(title), whole, writer.definitions());
}

}  // namespace rubsweep::config::keys
