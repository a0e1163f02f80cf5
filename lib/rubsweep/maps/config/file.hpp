#pragma once

#include <filesystem>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "rubsweep/maps/batch/table_file.hpp"
#include "rubsweep/maps/config/intervals.hpp"
#include "rubsweep/maps/config/keys/form.hpp"
#include "rubsweep/maps/config/run_config.hpp"
#include "rubsweep/maps/config/yaml/alternatives.hpp"
#include "rubsweep/maps/config/yaml/diagnostics.hpp"
#include "rubsweep/maps/config/yaml/document.hpp"
#include "rubsweep/maps/config/yaml/printer.hpp"
#include "rubsweep/maps/config/yaml/section.hpp"
#include "rubsweep/maps/config/yaml/value.hpp"

namespace rubsweep::config {

/// Parses a configuration, merges it with its bases (see base.hpp; their paths are relative to `file`), and
/// applies the overrides (see override.hpp). Problems go to `diagnostics`. Throws ConfigError where the text
/// is empty or no YAML document, and where a base cannot be read. `form` describes in words the possible
/// content of the configuration. `alternatives`: keys that exclude each other; a key removes those that it
/// excludes in the file below. Intervals of the rotor's numbers (see intervals.hpp) become their values, and
/// go to `intervals`.
yaml::Node parse_config(std::string_view text, const std::filesystem::path& file, std::string_view form,
                        const std::vector<std::string>& overrides, yaml::Diagnostics& diagnostics,
                        const yaml::Alternatives& alternatives = {},
                        std::vector<KeyInterval>* intervals = nullptr);

/// Value that `read` makes from the root of a configuration. Throws ConfigError as parse_config does, and
/// also with every problem that `read` added.
template <class Read>
auto read_parsed(std::string_view text, const std::filesystem::path& file, std::string_view form,
                 const std::vector<std::string>& overrides, Read read,
                 const yaml::Alternatives& alternatives = {}) {
  yaml::Diagnostics diagnostics(file.string(), overrides);
  const yaml::Node root = parse_config(text, file, form, overrides, diagnostics, alternatives);
  auto value = read(yaml::Value{root, "", diagnostics});
  diagnostics.throw_if_any();
  return value;
}

keys::Key base_of_map();  ///< Key `base`, which any map may have.

/// Refuses a configuration of another `program`: it has a key of `theirs` but no key of `ours`, so that every
/// key would be unknown. Throws ConfigError.
void refuse_foreign(const yaml::Node& root, std::initializer_list<std::string_view> theirs,
                    std::initializer_list<std::string_view> ours, std::string_view program,
                    yaml::Diagnostics& diagnostics);

std::filesystem::path read_output(const yaml::Value& value);  ///< Reads the map `output`: {directory}.
keys::Form output_form();
void print_output(yaml::Printer& printer, const std::filesystem::path& directory);

/// Reads the map `output` of a rub configuration: {directory, warn_over_clearances}.
void read_run_output(const yaml::Value& value, RunConfig& config);
keys::Form run_output_form();
void print_run_output(yaml::Printer& printer, const RunConfig& config);

/// Reads `title`, `author` and `note` of a root: texts that change no number. Refuses characters that are not
/// shown as written: control characters (line ends are allowed in a note), and characters that change the
/// direction of writing.
void read_captions(yaml::Section& root, batch::Captions& captions);

std::vector<keys::Key> caption_keys();  ///< The keys that read_captions reads.

/// Prints the captions that are not empty.
void print_captions(yaml::Printer& printer, const batch::Captions& captions);

}  // namespace rubsweep::config
