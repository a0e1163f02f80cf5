#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "rubsweep/maps/batch/opened_file.hpp"
#include "rubsweep/maps/config/yaml/alternatives.hpp"
#include "rubsweep/maps/config/yaml/diagnostics.hpp"
#include "rubsweep/maps/config/yaml/document.hpp"

namespace rubsweep::config::yaml {

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

/// The value that results when `over` is written over `base`, both found at `path`:
/// - Two maps are merged key by key. A key of `over` takes back what the base says by other means (see
///   Alternatives), and without a value it takes back the base's own. Two maps that name different kinds
///   (key `kind`) share nothing: that of `over` stands alone.
/// - Anything else, lists included, replaces what the base has.
/// Remaining keys keep their places; the merged map itself has that of `over`. Repeated keys are a problem in
/// either.
Node merged(Node base, Node over, std::string_view path, const Alternatives& alternatives,
            Diagnostics& diagnostics);

/// The key under which any map names the file that it is written over.
inline constexpr std::string_view base_key = "base";

/// Limits that keep any number of bases within small time and memory.
inline constexpr int max_base_files = 100;       ///< read for one configuration, repeated ones included
inline constexpr int max_base_generations = 16;  ///< a base of a base of ...

/// Replaces every map of `root`, itself included, that has the key `base` by what results when the map is
/// written over the content of that file (see merged), which may have bases of its own. A path is relative
/// to the file that names it; `file` is that of `root`. What cannot be had (no text, no file that can be
/// read, no map in it, a file that leads back to itself, more than the limits above) is a problem of the
/// place that names it; false when there is such a problem.
bool resolve_bases(Node& root, const std::filesystem::path& file, const Alternatives& alternatives,
                   Diagnostics& diagnostics);

/// Refuses the key `base` of a root whose own was resolved: an override wrote it, which is no file.
void refuse_base_of_override(const Node& root, Diagnostics& diagnostics);

}  // namespace rubsweep::config::yaml
