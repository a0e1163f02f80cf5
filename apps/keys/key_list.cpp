#include "keys/key_list.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace rubsweep::apps {

using namespace config::keys;

namespace {

/// One row of the list, with the values allowed for the key. They may depend on the kind of the map that
/// holds it.
struct Merged {
  KeyRow row;
  struct Case {
    Form form;
    std::string kind;  ///< kind of the map; empty: the map has no kind
  };
  std::vector<Case> cases;
};

std::string allowed_in(const std::vector<Merged::Case>& cases) {
  const bool words = std::ranges::all_of(cases, [](const auto& one) { return one.form.kind == Kind::word; });
  Form all = cases[0].form;
  if (words && cases.size() > 1) {
    for (const auto& one : cases) {
      for (const std::string& more : one.form.words)
        if (std::ranges::count(all.words, more) == 0) all.words.push_back(more);
    }
    return allowed(all);
  }
  std::vector<std::pair<std::string, std::string>> texts;
  for (const auto& [form, kind] : cases) {
    const std::string text = allowed(form);
    const auto same = std::ranges::find(texts, text, &std::pair<std::string, std::string>::first);
    if (same == texts.end()) texts.emplace_back(text, kind);
  }
  std::string result = texts[0].first;
  for (std::size_t i = 1; i < texts.size(); ++i) {
    result += texts[i - 1].second.empty() ? ", or "
                                          : fmt::format(" with kind: {}, otherwise ", texts[i - 1].second);
    result += texts[i].first;
  }
  return result;
}

void add_row(std::vector<Merged>& rows, KeyRow row, const Form& form, const std::string& kind) {
  const auto path_of = [](const Merged& one) -> const std::string& { return one.row.path; };
  const auto same = std::ranges::find(rows, row.path, path_of);
  Merged& merged = same == rows.end() ? rows.emplace_back(Merged{std::move(row), {}}) : *same;
  merged.cases.push_back({form, kind});
}

/// Word of the key `kind`, where a map begins with that key; else empty.
std::string kind_of(const Form& map) {
  const bool named = !map.keys.empty() && map.keys[0].name == "kind" && map.keys[0].form.words.size() == 1;
  return named ? map.keys[0].form.words[0] : "";
}

std::string fallback_of(const Form& map, const Key& key) {
  if (!key.required) return key.fallback;
  return is_chosen(map, key.name) ? "one of several" : "required";
}

void add_keys(std::vector<Merged>& rows, const Form& form, const std::string& path) {
  switch (form.kind) {
    case Kind::any_of:
      for (const Form& one : form.forms) add_keys(rows, one, path);
      break;
    case Kind::list:
    case Kind::numbered: add_keys(rows, form.forms[0], path + ".N"); break;
    case Kind::map:
      for (const Key& key : form.keys) {
        const std::string at = path.empty() ? key.name : path + "." + key.name;
        add_row(rows,
                {at, std::string(unit_of(key.name)), "", fallback_of(form, key), key.meaning, key.since},
                key.form, kind_of(form));
        add_keys(rows, key.form, at);
      }
      break;
    case Kind::number:
    case Kind::integer:
    case Kind::word:
    case Kind::text: break;
  }
}

/// Path with N in place of every number.
std::string general(std::string_view path) {
  std::string result;
  while (!path.empty()) {
    const std::string_view part = path.substr(0, path.find('.'));
    const bool number =
        !part.empty() && std::ranges::all_of(part, [](unsigned char c) { return std::isdigit(c) != 0; });
    result.append(result.empty() ? "" : ".").append(number ? "N" : part);
    path.remove_prefix(std::min(part.size() + 1, path.size()));
  }
  return result;
}

}  // namespace

std::vector<KeyRow> key_list(const Form& root) {
  std::vector<Merged> all;
  add_keys(all, root, "");
  std::vector<KeyRow> rows;
  for (Merged& one : all) {
    one.row.allowed = allowed_in(one.cases);
    rows.push_back(std::move(one.row));
  }
  return rows;
}

std::vector<KeyRow> below(const std::vector<KeyRow>& rows, std::string_view path) {
  const std::string from = general(path);
  std::vector<KeyRow> found;
  std::ranges::copy_if(rows, std::back_inserter(found), [&](const KeyRow& row) {
    return from.empty() || row.path == from || row.path.starts_with(from + ".");
  });
  return found;
}

std::string text_of(const std::vector<KeyRow>& rows) {
  std::string text;
  for (const KeyRow& row : rows) {
    const bool none = row.fallback == "required" || row.fallback == "one of several";
    const std::string fallback =
        row.fallback.empty() ? "" : fmt::format("; {}{}", none ? "" : "default ", row.fallback);
    text += fmt::format("{}\n    {}\n    {}{}{}{}\n", row.path, row.meaning, row.allowed,
                        row.unit.empty() ? "" : "; in " + row.unit, fallback,
                        row.since == "0.1.0" ? "" : "; since " + row.since);
  }
  return text;
}

}  // namespace rubsweep::apps
