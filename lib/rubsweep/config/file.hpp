#pragma once

#include <filesystem>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "rubsweep/batch/input_file.hpp"
#include "rubsweep/config/diagnostics.hpp"
#include "rubsweep/config/document.hpp"

namespace rubsweep::config {

/// Contents of a file, or the reason why there are none.
struct FileBytes {
  std::string text;
  std::string problem;  ///< empty: none
};

/// The bytes of a configuration file, at most one more than a document may have.
FileBytes read_bytes(const std::filesystem::path& file,
                     batch::InputKind kind = batch::InputKind::regular_file);

/// The same of a file that the command line names, which may be one that the caller opened and passed on, as
/// <(...) of a shell is. Throws IoError when the file cannot be read.
std::string read_config_bytes(const std::filesystem::path& file);

/// Parses a configuration, writes it over its bases (see base.hpp; `file` is where they are looked for from)
/// and applies the overrides (see override.hpp), whose problems `diagnostics` collects. Throws ConfigError
/// when the text is no YAML document or nothing at all, `form` says what may stand there, and when a base
/// cannot be had.
Node parse_config(std::string_view text, const std::filesystem::path& file, std::string_view form,
                  const std::vector<std::string>& overrides, Diagnostics& diagnostics);

/// Refuses a configuration of another program, of which every key would be unknown: one that has a key of
/// `theirs` and none of `ours`. Throws ConfigError.
void refuse_foreign(const Node& root, std::initializer_list<std::string_view> theirs,
                    std::initializer_list<std::string_view> ours, std::string_view program,
                    Diagnostics& diagnostics);

}  // namespace rubsweep::config
