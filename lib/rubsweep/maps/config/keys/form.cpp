#include "rubsweep/maps/config/keys/form.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
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

/// Allowed values beside others, of which `first` is named before.
std::string one_of_several(const Form& form, const Form& first) {
  switch (form.kind) {
    case Kind::integer:
      return fmt::format("an {}integer from {} to {}", form.even ? "even " : "", form.low, form.high);
    case Kind::text:
      return fmt::format("a text of at most {} bytes", form.most);
    case Kind::list:
      if (form.forms[0].kind == Kind::number && first.kind == Kind::number &&
          allowed_number(form.forms[0].range) == allowed_number(first.range))
        return fmt::format("a list of {} such numbers", counted(form.least, form.most));
      return "a " + allowed(form);
    case Kind::map:
    case Kind::numbered:
      return "a " + allowed(form);
    default:
      return allowed(form);
  }
}

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
    case Kind::number:
      return allowed_number(form.range);
    case Kind::integer:
      return fmt::format("{}integer, {} to {}", form.even ? "even " : "", form.low, form.high);
    case Kind::word:
      return fmt::format("{}", fmt::join(form.words, " or "));
    case Kind::text:
      return fmt::format("text, at most {} bytes", form.most);
    case Kind::list:
      return fmt::format("list of {}{}", counted(form.least, form.most),
                         form.forms[0].kind == Kind::map ? " maps" : ", each: " + allowed(form.forms[0]));
    case Kind::map:
      return "map";
    case Kind::numbered:
      return fmt::format("map from numbers, 0 to {}", form.most - 1);
    case Kind::any_of:
      for (const Form& one : form.forms) {
        std::string more = one_of_several(one, form.forms[0]);
        if (text != more && !text.ends_with("or " + more)) text += text.empty() ? more : ", or " + more;
      }
      if (text == one_of_several(form.forms[0], form.forms[0])) text = allowed(form.forms[0]);
  }
  return text;
}

}  // namespace rubsweep::config::keys
