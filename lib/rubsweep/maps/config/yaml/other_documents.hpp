#pragma once

#include <optional>
#include <string_view>

#include "rubsweep/maps/config/yaml/diagnostics.hpp"
#include "rubsweep/maps/config/yaml/document.hpp"

namespace rubsweep::config::yaml {

/// Parses a TOML document into the same kind of tree as YAML, with keys in the order of the file. Problems go
/// to `diagnostics` under `path`, with their place in the file number `file` (Diagnostics::add_file); the
/// result is then empty. The limits of parse_document hold.
std::optional<Node> parse_toml(std::string_view text, std::string_view path, Diagnostics& diagnostics,
                               int file);

/// Parses a JSON document as parse_toml does a TOML document. The place of a scalar is its last character,
/// the place of a map or a list its opening bracket.
std::optional<Node> parse_json(std::string_view text, std::string_view path, Diagnostics& diagnostics,
                               int file);

}  // namespace rubsweep::config::yaml
