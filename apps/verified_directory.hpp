#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace rubsweep::apps {

/// Verdict on a directory of results that no program is at work in.
struct DirectoryVerdict {
  std::vector<std::string> faults;   ///< why it is not whole; none: it is
  std::vector<std::string> remarks;  ///< on facts that are uncertain or do no harm
  std::vector<std::string> files;    ///< names of those that were checked
};

/// Checks whether the results in a directory, of whichever program, are whole and belong together: every
/// table by its checksum, by its digest and by the files that it was written with, the map by its cells, the
/// configuration and the report by the digest of the map. Throws LockedError where a program is at work
/// there, IoError where the directory cannot be read.
DirectoryVerdict verify_directory(const std::filesystem::path& directory);

}  // namespace rubsweep::apps
