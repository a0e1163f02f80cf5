#include "rubsweep/maps/config/keys/key_list.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "rubsweep/maps/config/keys/unit_of.hpp"

namespace rubsweep::config::keys {
namespace {

void add_row(std::vector<KeyRow>& rows, KeyRow row) {
  const auto same = std::ranges::find(rows, row.path, &KeyRow::path);
  if (same == rows.end()) {
    rows.push_back(std::move(row));
  } else if (same->allowed != row.allowed) {
    same->allowed += " or " + row.allowed;
  }
}

std::string fallback_of(const Form& map, const Key& key) {
  if (!key.required) return key.fallback;
  return is_chosen(map, key.name) ? "one of several" : "required";
}

void add_keys(std::vector<KeyRow>& rows, const Form& form, const std::string& path) {
  switch (form.kind) {
    case Kind::any_of:
      for (const Form& one : form.forms) add_keys(rows, one, path);
      break;
    case Kind::list:
    case Kind::numbered:
      add_keys(rows, form.forms[0], path + ".N");
      break;
    case Kind::map:
      for (const Key& key : form.keys) {
        const std::string at = path.empty() ? key.name : path + "." + key.name;
        add_row(rows, {at, std::string(unit_of(key.name)), allowed(key.form), fallback_of(form, key),
                       key.meaning, key.since});
        add_keys(rows, key.form, at);
      }
      break;
    default:
      break;
  }
}

/// The path with N in place of every number.
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
  std::vector<KeyRow> rows;
  add_keys(rows, root, "");
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

}  // namespace rubsweep::config::keys
