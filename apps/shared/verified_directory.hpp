#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "rubsweep/maps/sweep/study.hpp"

namespace rubsweep::apps {

/// Facts from config.yaml, as the program that wrote it reads it.
struct VerifiedConfiguration {
  std::string digest;
  std::optional<sweep::Study> study = {};  ///< study, for a configuration of a rotor
};
using ReadConfiguration = std::function<VerifiedConfiguration(const std::filesystem::path& file)>;

/// Verdict on a directory of results where no program is at work.
struct DirectoryVerdict {
  std::vector<std::string> faults;   ///< reasons why it is incomplete or damaged; empty: it is whole
  std::vector<std::string> remarks;  ///< uncertain or harmless facts
  std::vector<std::string> files;    ///< names of the files that were checked
};

/// Checks whether the results in a directory, of any program, are whole and belong together. Tables are
/// checked by their checksum, by their digest and by the files written with them. The map is also checked by
/// its cells; configuration and report are checked by the digest of the map. Throws LockedError where a
/// program is at work there, IoError where the directory cannot be read. `read` must throw where a file is no
/// configuration.
DirectoryVerdict verify_directory(const std::filesystem::path& directory, const ReadConfiguration& read);

}  // namespace rubsweep::apps
