#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "rubsweep/maps/sweep/study.hpp"

namespace rubsweep::map {

/// Facts from config.yaml, as the program that wrote it reads it.
struct VerifiedConfiguration {
  std::string digest;
  std::optional<sweep::Study> study = {};  ///< study of a rotor
};
using ReadConfiguration = std::function<VerifiedConfiguration(const std::filesystem::path& file)>;

/// Verdict on a directory of results that no program is at work in.
struct DirectoryVerdict {
  std::vector<std::string> faults;   ///< why it is not whole; none: it is
  std::vector<std::string> remarks;  ///< on facts that are uncertain or do no harm
  std::vector<std::string> files;    ///< names of those that were checked
};

/// Checks whether the results in a directory, of whichever program, are whole and belong together: every
/// table by its checksum, by its digest and by the files that it was written with, the map by its cells, the
/// configuration and the report by the digest of the map. Throws LockedError where a program is at work
/// there, IoError where the directory cannot be read. `read` throws where the configuration is none.
DirectoryVerdict verify_directory(const std::filesystem::path& directory, const ReadConfiguration& read);

}  // namespace rubsweep::map
