#include "rubsweep/maps/config/keys/form.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace rubsweep::config::keys {
namespace {

std::string allowed_number(const model::Range& range) {
  std::string text;
  if (std::isfinite(range.low)) text = fmt::format("{} {}", range.low_open ? ">" : ">=", range.low);
  if (std::isfinite(range.high))
    text += fmt::format("{}{} {}", text.empty() ? "" : " and ", range.high_open ? "<" : "<=", range.high);
  return text.empty() ? "a number" : text;
}

std::string counted(std::size_t least, std::size_t most) {
  return least == most ? std::to_string(most) : fmt::format("{} to {}", least, most);
}

/// Allowed values, in words, of a form that follows the form `first` in a list of several.
std::string one_of_several(const Form& form, const Form& first) {
  switch (form.kind) {
    case Kind::integer:
      return fmt::format("an {}integer from {} to {}", form.even ? "even " : "", form.low, form.high);
    case Kind::text: return fmt::format("a text of at most {} bytes", form.most);
    case Kind::list:
      if (form.forms[0].kind == Kind::number && first.kind == Kind::number &&
          allowed_number(form.forms[0].range) == allowed_number(first.range))
        return fmt::format("a list of {} such numbers", counted(form.least, form.most));
      return "a " + allowed(form);
    case Kind::map:
    case Kind::numbered: return "a " + allowed(form);
    case Kind::number:
    case Kind::word:
    case Kind::any_of: break;
  }
  return allowed(form);
}

struct Unit {
  std::string_view end, unit;
};
/// Units by the ending of a key. A longer ending stands before an ending that is part of it.
constexpr std::array units{
    Unit{"_kg_per_m3", "kg/m3"},
    Unit{"_nms_per_rad", "N m s/rad"},
    Unit{"_nm_per_rad", "N m/rad"},
    Unit{"_ns_per_m", "N s/m"},
    Unit{"_n_per_m_n", "N/m^n"},
    Unit{"_n_per_m", "N/m"},
    Unit{"_mm_per_s", "mm/s"},
    Unit{"_m_per_s2", "m/s2"},
    Unit{"_rad_per_s", "rad/s"},
    Unit{"_rad_per_m", "rad/m"},
    Unit{"_m_per_s", "m/s"},
    Unit{"_s_per_m", "s/m"},
    Unit{"_per_s", "1/s"},
    Unit{"_kg_m2", "kg m2"},
    Unit{"_g_mm", "g mm"},
    Unit{"_deg", "degrees"},
    Unit{"_rpm", "1/min"},
    Unit{"_rad", "rad"},
    Unit{"_hz", "Hz"},
    Unit{"_kg", "kg"},
    Unit{"_ns", "N s"},
    Unit{"_pa", "Pa"},
    Unit{"_m2", "m2"},
    Unit{"_m4", "m4"},
    Unit{"_n", "N"},
    Unit{"_s", "s"},
    Unit{"_m", "m"},
};

}  // namespace

Form number(const model::Range& range) { return {.kind = Kind::number, .range = range, .keys = {}}; }
Form integer(long low, long high) { return {.kind = Kind::integer, .low = low, .high = high, .keys = {}}; }
Form even_integer(long low, long high) {
  return {.kind = Kind::integer, .low = low, .high = high, .even = true, .keys = {}};
}
Form word(std::vector<std::string> words) {
  return {.kind = Kind::word, .words = std::move(words), .keys = {}};
}
Form one_of(std::span<const std::string_view> words) { return word({words.begin(), words.end()}); }
Form text(std::size_t most) { return {.kind = Kind::text, .most = most, .keys = {}}; }
Form list_of(Form item, std::size_t least, std::size_t most) {
  return {.kind = Kind::list, .least = least, .most = most, .forms = {std::move(item)}, .keys = {}};
}
Form map_of(std::vector<Key> keys, std::vector<Choice> choices) {
  return {.kind = Kind::map, .keys = std::move(keys), .choices = std::move(choices)};
}
Form numbered(Form item, std::size_t count) {
  return {.kind = Kind::numbered, .most = count, .forms = {std::move(item)}, .keys = {}};
}
Form any_of(std::vector<Form> forms) { return {.kind = Kind::any_of, .forms = std::move(forms), .keys = {}}; }

Key must(std::string name, Form form, std::string meaning) {
  return {.name = std::move(name), .form = std::move(form), .meaning = std::move(meaning), .required = true};
}
Key may(std::string name, Form form, std::string meaning, std::string fallback) {
  return {.name = std::move(name),
          .form = std::move(form),
          .meaning = std::move(meaning),
          .fallback = std::move(fallback)};
}
Key beside(Key key, Condition when) {
  key.when = std::move(when);
  return key;
}
Key newer_key(Key key) {
  key.since = "0.2.0";
  return key;
}
std::vector<Key> newer(std::vector<Key> keys) {
  for (Key& key : keys) key = newer_key(std::move(key));
  return keys;
}

Choice either(std::span<const std::string_view> names) {
  Choice choice;
  for (const std::string_view name : names) choice.ways.push_back({{std::string(name)}, {}});
  return choice;
}
Choice choice_of(const std::vector<std::vector<Key>>& ways) {
  Choice choice;
  for (const std::vector<Key>& keys : ways) {
    Way& way = choice.ways.emplace_back();
    for (const Key& key : keys) (key.required ? way.required : way.optional).push_back(key.name);
  }
  return choice;
}

bool is_chosen(const Form& map, std::string_view name) {
  return std::ranges::any_of(map.choices, [&](const Choice& choice) {
    return std::ranges::any_of(choice.ways, [&](const Way& way) {
      return std::ranges::count(way.required, name) + std::ranges::count(way.optional, name) > 0;
    });
  });
}

std::string allowed(const Form& form) {
  std::string text;
  switch (form.kind) {
    case Kind::number: return allowed_number(form.range);
    case Kind::integer:
      return fmt::format("{}integer, {} to {}", form.even ? "even " : "", form.low, form.high);
    case Kind::word: return fmt::format("{}", fmt::join(form.words, " or "));
    case Kind::text: return fmt::format("text, at most {} bytes", form.most);
    case Kind::list:
      return fmt::format("list of {}{}", counted(form.least, form.most),
                         form.forms[0].kind == Kind::map ? " maps" : ", each: " + allowed(form.forms[0]));
    case Kind::map: return "map";
    case Kind::numbered: return fmt::format("map from numbers, 0 to {}", form.most - 1);
    case Kind::any_of:
      for (const Form& one : form.forms) {
        std::string more = one_of_several(one, form.forms[0]);
        if (text != more && !text.ends_with("or " + more)) text += text.empty() ? more : ", or " + more;
      }
      if (text == one_of_several(form.forms[0], form.forms[0])) text = allowed(form.forms[0]);
  }
  return text;
}

std::string_view unit_of(std::string_view key) {
  for (const auto& [end, unit] : units) {
    if (key.ends_with(end)) return unit;
  }
  return "";
}

}  // namespace rubsweep::config::keys
