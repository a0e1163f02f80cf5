#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace rubsweep::batch {

/// Throws IoError "cannot ACTION PATH: the system's reason" for the error number `error`, or bad_alloc where
/// the system was out of memory.
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

  /// Releases the descriptor without closing it; the caller must close it.
  int release();

 private:
  int value_;
};

/// Opens a file with the flags of open(2). A new file gets the permissions that the umask allows. Throws
/// IoError "cannot ACTION KNOWN_AS: ...", with O_NOFOLLOW also for a symbolic link.
Descriptor open_file(const std::filesystem::path& path, int flags, std::string_view action,
                     const std::filesystem::path& known_as);
inline Descriptor open_file(const std::filesystem::path& path, int flags, std::string_view action) {
  return open_file(path, flags, action, path);
}

/// Whether `path` is still a name of the open file.
bool is_file_at(int descriptor, const std::filesystem::path& path);

/// Throws IoError "cannot ACTION PATH: it is a symbolic link" where `path` is one, even if it leads nowhere.
/// Protects files whose names others could guess.
void refuse_link(std::string_view action, const std::filesystem::path& path);

/// Writes everything; returns 0 or the system's error number.
int write_all(int descriptor, std::string_view text);

/// Waits until the names in a directory are on the disk, after files were renamed, created or removed there.
/// Without this, a loss of power may undo these changes in any order. Does nothing on a file system that
/// cannot sync. Throws IoError.
void sync_directory(const std::filesystem::path& directory);

/// Creates a directory and missing ones above it, and syncs them to the disk. Throws IoError.
void make_directory(const std::filesystem::path& directory);

/// Kinds of files that may be read. A pipe or a device could make its reader wait forever, so a name must
/// lead to a regular file. `also_passed_on` also permits files that the caller of the program opened, such as
/// /dev/stdin or /dev/fd/63.
enum class InputKind { regular_file, also_passed_on };

/// An open file, or the reason why it could not be opened.
struct Input {
  Descriptor descriptor;
  std::string problem;  ///< such as "No such file or directory"; empty: the file is open
};

/// Opens a file for reading. Never waits for a writer.
Input find_input(const std::filesystem::path& path, InputKind kind = InputKind::regular_file);

/// Opens a file for reading, as find_input does. Throws IoError "cannot read PATH: ...".
Descriptor open_input(const std::filesystem::path& path);

/// Lines of a file of any size, one at a time.
class InputLines {
 public:
  /// Throws IoError "cannot read PATH: ...".
  explicit InputLines(std::filesystem::path path);
  ~InputLines();
  InputLines(const InputLines&) = delete;
  InputLines& operator=(const InputLines&) = delete;

  /// The next line with its line end, which the last line may lack; an empty view at the end of the file. The
  /// view is valid until the next call. Throws IoError with the name of the file, and bad_alloc for a line
  /// that does not fit into memory.
  std::string_view next();

  /// Continues with the line that begins at this offset. Throws IoError.
  void go_to(std::uint64_t offset);

 private:
  std::filesystem::path path_;
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> stream_;
  char* text_ = nullptr;  ///< as getline(3) wants it
  std::size_t capacity_ = 0;
};

/// Reads all bytes of a file. Throws IoError.
std::string read_input(const std::filesystem::path& path);

/// Appends at most `most` bytes of an open file to `text`; returns 0 or the system's error number.
int read_bytes(int descriptor, std::size_t most, std::string& text);

}  // namespace rubsweep::batch
