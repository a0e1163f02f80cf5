#pragma once

#include <filesystem>
#include <string_view>

namespace rubsweep::batch {

/// "cannot ACTION PATH: the system's reason" for the error number `error`. Throws IoError; bad_alloc where
/// the system had no memory left.
[[noreturn]] void throw_io_error(std::string_view action, const std::filesystem::path& path, int error);

/// Owns one open file.
class Descriptor {
 public:
  explicit Descriptor(int value) : value_(value) {}
  Descriptor(Descriptor&& other) noexcept : value_(other.release()) {}
  ~Descriptor();
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  Descriptor& operator=(Descriptor&&) = delete;

  int get() const { return value_; }

  /// The caller closes it from now on.
  int release();

 private:
  int value_;
};

/// Opens with the flags of open(2); a new file may be read and written by all whom the mask allows. Throws
/// IoError "cannot ACTION KNOWN_AS: ..."; with O_NOFOLLOW also for a symbolic link.
Descriptor open_file(const std::filesystem::path& path, int flags, std::string_view action,
                     const std::filesystem::path& known_as);
inline Descriptor open_file(const std::filesystem::path& path, int flags, std::string_view action) {
  return open_file(path, flags, action, path);
}

/// Whether the open file is still the one that has the name `path`.
bool is_file_at(int descriptor, const std::filesystem::path& path);

/// For files of ours that are written under names which others could guess. Throws IoError "cannot ACTION
/// PATH: it is a symbolic link" where it is one, whether or not there is something behind it.
void refuse_link(std::string_view action, const std::filesystem::path& path);

/// Writes everything; returns 0 or the system's error number.
int write_all(int descriptor, std::string_view text);

}  // namespace rubsweep::batch
