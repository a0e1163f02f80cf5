#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "rubsweep/config/diagnostics.hpp"
#include "rubsweep/config/document.hpp"

namespace rubsweep::config {

/// The bytes of a configuration file, at most one more than a document may have. Throws IoError.
std::string read_config_bytes(const std::filesystem::path& file);

/// Parses a configuration and applies the overrides (see override.hpp), whose problems `diagnostics`
/// collects. Throws ConfigError when the text is no YAML document or nothing at all; `form` says what may
/// stand there.
Node parse_config(std::string_view text, std::string_view form, const std::vector<std::string>& overrides,
                  Diagnostics& diagnostics);

}  // namespace rubsweep::config
