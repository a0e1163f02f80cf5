#pragma once

#include <filesystem>
#include <functional>
#include <string_view>

namespace rubsweep::batch {

/// Where a process writes what is to take the name `path`: beside it, under a name that no other process of
/// this or of another host has.
std::filesystem::path temporary_beside(const std::filesystem::path& path);

/// Removes from `directory` what killed processes were about to write whole under a name for which `is_ours`.
/// A temporary that a living process locks stays, and so does one that cannot be locked.
void remove_leftovers(const std::filesystem::path& directory,
                      const std::function<bool(std::string_view name)>& is_ours);

}  // namespace rubsweep::batch
