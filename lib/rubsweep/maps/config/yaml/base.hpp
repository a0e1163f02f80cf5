#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "rubsweep/maps/batch/opened_file.hpp"
#include "rubsweep/maps/config/yaml/alternatives.hpp"
#include "rubsweep/maps/config/yaml/diagnostics.hpp"
#include "rubsweep/maps/config/yaml/document.hpp"

namespace rubsweep::config::yaml {

/// Contents of a file, or the reason why it could not be read.
struct FileBytes {
  std::string text;
  std::string problem;  ///< empty: none
};

/// Bytes of a configuration file, at most one byte more than the largest document, so that the reader notices
/// a file that is too large.
FileBytes read_bytes(const std::filesystem::path& file,
                     batch::InputKind kind = batch::InputKind::regular_file);

/// Bytes of a configuration file that the command line names. It may be a file that the shell opened and
/// passed on, as <(...) does. Throws IoError where the file cannot be read.
std::string read_config_bytes(const std::filesystem::path& file);

/// Value that results when `over` is written over `base`, both found at `path`:
/// - Two maps are merged key by key. A key of `over` removes alternative keys of `base` (see
///   Alternatives), and a key of `over` without a value removes the same key of `base`. Maps with a
///   different key `kind` are not merged: `over` stands alone.
/// - Anything else, lists included, replaces the value of `base`.
/// Keys that stay keep their places, and the merged map has the place of `over`. Repeated keys in either map
/// are a problem.
Node merged(Node base, Node over, std::string_view path, const Alternatives& alternatives,
            Diagnostics& diagnostics);

/// Key that names the file over which the map is written. Any map may have it.
inline constexpr std::string_view base_key = "base";

/// Limits that keep any number of bases within small time and memory.
inline constexpr int max_base_files = 100;       ///< file reads for one configuration, repeated ones included
inline constexpr int max_base_generations = 16;  ///< length of a chain of bases: a base of a base of ...

/// Replaces every map of `root`, itself included, that has the key `base`: the map is written over the
/// content of that file (see merged), which may have bases itself. A path is relative to the file in which it
/// stands; `file` is the file of `root`. A base that cannot be used (no text, unreadable, no map, leading
/// back to itself, above the limits) is a problem at the place that names it. Returns false after such a
/// problem.
bool resolve_bases(Node& root, const std::filesystem::path& file, const Alternatives& alternatives,
                   Diagnostics& diagnostics);

/// Refuses a key `base` that is still in the root after resolve_bases: only an override can have written it
/// there.
void refuse_base_of_override(const Node& root, Diagnostics& diagnostics);

}  // namespace rubsweep::config::yaml
