#pragma once

#include <filesystem>
#include <functional>
#include <string_view>

namespace rubsweep::batch {

/// Name of the temporary for a file that is to take the name `path`: beside it, under a name that no other
/// process of this or of another host has.
std::filesystem::path temporary_beside(const std::filesystem::path& path);

/// Whether such a name is that of a temporary; one that only looks similar, as map.csv.tmp-old, is not.
bool is_temporary(std::string_view name);

/// Removes from `directory` the temporaries that killed processes left of files for whose name `is_ours`. A
/// temporary that a living process locks stays, and so does one that cannot be locked.
void remove_leftovers(const std::filesystem::path& directory,
                      const std::function<bool(std::string_view name)>& is_ours);

}  // namespace rubsweep::batch
