#pragma once

#include <optional>
#include <string_view>

#include "rubsweep/maps/config/yaml/diagnostics.hpp"
#include "rubsweep/maps/config/yaml/document.hpp"

namespace rubsweep::config::yaml {

/// Parses a TOML document into the tree that YAML gives, keys in the order of the file. Problems go to
/// `diagnostics` under `path`, with their place in the file `file` (Diagnostics::add_file); then the result
/// is empty. The limits of parse_document hold.
std::optional<Node> parse_toml(std::string_view text, std::string_view path, Diagnostics& diagnostics,
                               int file);

/// The same as parse_toml of a JSON document. The place of a value is where its last character stands, that
/// of a map or a list where it opens.
std::optional<Node> parse_json(std::string_view text, std::string_view path, Diagnostics& diagnostics,
                               int file);

}  // namespace rubsweep::config::yaml
