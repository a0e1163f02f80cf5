#include "rubsweep/maps/config/file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "rubsweep/maps/config/keys/table.hpp"
#include "rubsweep/maps/config/machine/matrix_rotor.hpp"
#include "rubsweep/maps/config/machine/rotor_kit.hpp"
#include "rubsweep/maps/config/yaml/base.hpp"
#include "rubsweep/maps/config/yaml/override.hpp"
#include "rubsweep/maps/config/yaml/text.hpp"

namespace rubsweep::config {
namespace {

std::filesystem::path read_directory(yaml::Section& section) {
  const auto text = section.require("directory", "a path");
  return text ? read_text(*text).value_or("") : std::string();
}

keys::Key directory_key() {
  return keys::must("directory", keys::text(), "directory of the results; --output goes first");
}

constexpr std::size_t longest_line = 200;

struct Caption {
  std::string_view name;
  std::string batch::Captions::*text;
  std::size_t longest;
  bool many_lines;
  std::string_view meaning;
};
constexpr std::array captions_there_are{
    Caption{"title", &batch::Captions::title, longest_line, false,
            "what the results are called where they are shown"},
    Caption{"author", &batch::Captions::author, longest_line, false, "who made them"},
    Caption{"note", &batch::Captions::note, yaml::max_text_bytes, true,
            "anything else, of several lines where needed"}};

/// First character of `text` that a terminal would not show as it is, in escaped form; empty where there is
/// no such character. Line ends are allowed in a text of many lines.
std::string hidden_in(std::string_view text, bool many_lines) {
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = std::max<std::size_t>(yaml::utf8_length(text.substr(i)), 1);
    const std::string_view character = text.substr(i, length);
    if (yaml::is_hidden(character) && !(many_lines && character == "\n")) return yaml::escaped(character);
    i += length;
  }
  return "";
}

}  // namespace

keys::Key base_of_map() {
  return newer_key(keys::may(std::string(yaml::base_key), keys::text(),
                             "file that this map is written over, relative to the one it stands in",
                             "(none)"));
}

void refuse_foreign(const yaml::Node& root, std::initializer_list<std::string_view> theirs,
                    std::initializer_list<std::string_view> ours, std::string_view program,
                    yaml::Diagnostics& diagnostics) {
  const auto among = [](const yaml::Node::Key& key, std::initializer_list<std::string_view> names) {
    return std::ranges::find(names, key.text) != names.end();
  };
  if (std::ranges::any_of(root.keys, [&](const yaml::Node::Key& key) { return among(key, ours); })) return;
  for (const yaml::Node::Key& key : root.keys) {
    if (!among(key, theirs)) continue;
    diagnostics.add(key.place, key.text, fmt::format("belongs to a configuration of {}", program),
                    fmt::format("{} with this file", program));
    diagnostics.throw_if_any();
  }
}

yaml::Node parse_config(std::string_view text, const std::filesystem::path& file, std::string_view form,
                        const std::vector<std::string>& overrides, yaml::Diagnostics& diagnostics,
                        const yaml::Alternatives& alternatives, std::vector<KeyInterval>* intervals) {
  auto root = parse_document(text, -1, "", diagnostics);
  diagnostics.throw_if_any();
  if (root->kind == yaml::Node::Kind::null) {
    diagnostics.add(yaml::SourcePosition{}, "", "the configuration is empty", form);
    diagnostics.throw_if_any();
  }
  if (!resolve_bases(*root, file, alternatives, diagnostics)) diagnostics.throw_if_any();
  apply_overrides(*root, overrides, alternatives, diagnostics);
  refuse_base_of_override(*root, diagnostics);
  std::vector<KeyInterval> taken = take_intervals(*root, diagnostics);
  if (intervals != nullptr) *intervals = std::move(taken);
  machine::resolve_tables(*root, diagnostics);
  machine::resolve_matrices(*root, diagnostics);
  return *std::move(root);
}

keys::Form output_form() { return keys::map_of({directory_key()}); }

keys::Form run_output_form() {
  return keys::map_of(keys::joined({{directory_key()}, keys::keys_of<RunConfig>()}));
}

std::filesystem::path read_output(const yaml::Value& value) {
  yaml::Section section(value);
  return read_directory(section);
}

void print_output(yaml::Printer& printer, const std::filesystem::path& directory) {
  printer.open("output");
  printer.text("directory", directory.string());
  printer.close();
}

void read_run_output(const yaml::Value& value, RunConfig& config) {
  yaml::Section section(value);
  config.output_directory = read_directory(section);
  read_fields(section, config);
}

void print_run_output(yaml::Printer& printer, const RunConfig& config) {
  printer.open("output");
  printer.text("directory", config.output_directory.string());
  print_fields(printer, config);
  printer.close();
}

void read_captions(yaml::Section& root, batch::Captions& captions) {
  for (const Caption& caption : captions_there_are) {
    const auto value = root.find(caption.name);
    if (!value) continue;
    auto text = read_text(*value);
    if (!text) continue;
    const std::string_view allowed =
        caption.many_lines ? "UTF-8 text and line ends" : "UTF-8 text of one line";
    if (const std::string hidden = hidden_in(*text, caption.many_lines); !hidden.empty()) {
      refuse(*value, fmt::format("holds the character {}, which cannot be shown", hidden), allowed);
    } else if (text->size() > caption.longest) {
      refuse(*value, "is too long", fmt::format("at most {} bytes", caption.longest));
    } else {
      captions.*caption.text = *std::move(text);
    }
  }
}

std::vector<keys::Key> caption_keys() {
  std::vector<keys::Key> keys;
  keys.reserve(std::size(captions_there_are));
  for (const Caption& caption : captions_there_are)
    keys.push_back(keys::may(std::string(caption.name), keys::text(caption.longest),
                             std::string(caption.meaning), "(none)"));
  return newer(std::move(keys));
}

void print_captions(yaml::Printer& printer, const batch::Captions& captions) {
  for (const Caption& caption : captions_there_are) {
    const std::string& text = captions.*caption.text;
    if (!text.empty()) printer.text(caption.name, text);
  }
}

}  // namespace rubsweep::config
