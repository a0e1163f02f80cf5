#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "rubsweep/batch/descriptor.hpp"

namespace rubsweep::batch {

/// A file that appears under its name whole or not at all: what is written goes to a temporary beside it,
/// which takes the name at the end; a symbolic link stays, a device or pipe is refused. Not for two threads
/// and one path. Every function throws IoError with the path and the system's reason, and then an older file
/// of that name is as it was.
class WholeFile {
 public:
  explicit WholeFile(std::filesystem::path path);
  ~WholeFile();  ///< removes the temporary unless commit() succeeded
  WholeFile(const WholeFile&) = delete;
  WholeFile& operator=(const WholeFile&) = delete;

  void write(std::string_view text);

  /// Where another process may write instead, as its standard output.
  int descriptor() const { return descriptor_.get(); }

  /// Waits until everything is on the disk, then renames. Nothing may be written afterwards.
  void commit();

 private:
  void flush();

  std::filesystem::path path_, temporary_;
  Descriptor descriptor_;
  std::string waiting_;  ///< not yet handed to the system
  bool committed_ = false;
};

/// Makes `path` hold exactly `text`, whole or not at all (see WholeFile).
void write_whole_file(const std::filesystem::path& path, std::string_view text);

}  // namespace rubsweep::batch
