#pragma once

#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "rubsweep/core/error.hpp"
#include "rubsweep/maps/batch/sha256.hpp"
#include "rubsweep/maps/batch/whole_file.hpp"

namespace rubsweep::batch {

/// Layout of tables, the number after `# format`. A new column at the end or a new comment leaves it.
inline constexpr int table_format = 1;

/// Author program of a table, and the study that its numbers belong to.
struct TableSource {
  std::string program;             ///< with its version: "rubsweep 1.0.0"
  std::string digest;              ///< of all that decides the numbers
  std::vector<std::string> files;  ///< names of all files that were written together; empty: this one alone
  std::string captions{};          ///< comment lines of title, author and note (see captions.hpp)
  std::vector<std::pair<std::string, std::string>>
      sums{};  ///< SHA-256 of files that have no place for it, by name
};

/// The comment lines that every table begins with, but for its checksum, which a table that grows has not.
std::string table_head(const TableSource& source);

/// A comma-separated file with its head, whole or not at all. One of its lines, `# sha256 DIGITS`, holds the
/// SHA-256 of all others: `sed '/^# sha256 /d' FILE | sha256sum`. Every function throws IoError.
class TableFile {
 public:
  TableFile(std::filesystem::path path, const TableSource& source);

  /// Comments, header and rows that follow the head.
  void write(std::string_view text);

  /// As of WholeFile; nothing may be written afterwards.
  void finish();
  void commit();
  void rename();

 private:
  WholeFile file_;
  Sha256 sum_;
  std::size_t place_of_sum_ = 0;
  bool finished_ = false;
};

/// A table that is not as it was written.
class DamagedTable : public IoError {
  using IoError::IoError;
};

enum class TableSum {
  right,
  none  ///< a version of the program without checksums wrote the table, or something else did
};

/// Compares a table with its checksum. Throws DamagedTable where they do not agree, or where the checksum of
/// a table that must have one is missing; IoError. Ends of lines in CR LF, as a checkout for another system
/// makes them, change nothing.
TableSum check_table(const std::filesystem::path& path);

/// The same of an open file, which is at its begin before and after.
TableSum check_table(std::FILE* stream, const std::filesystem::path& path);

/// The same of all bytes of a file.
TableSum check_table_text(std::string_view text, const std::filesystem::path& path);

}  // namespace rubsweep::batch
