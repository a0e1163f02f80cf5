#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "rubsweep/core/error.hpp"
#include "rubsweep/maps/batch/opened_file.hpp"
#include "rubsweep/maps/batch/sha256.hpp"
#include "rubsweep/maps/batch/whole_file.hpp"

namespace rubsweep::batch {

/// Layout of tables, the number after `# format`. A new column at the end or a new comment leaves it.
inline constexpr int table_format = 1;

/// Author program of a table, and the study that its numbers belong to.
struct TableSource {
  std::string program;             ///< name with version: "rubsweep 1.0.0"
  std::string digest;              ///< digest of all that decides the numbers
  std::vector<std::string> files;  ///< names of all files that were written together; empty: this one alone
  std::string captions{};          ///< comment lines of title, author and note (see Captions)
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
TableSum check_table(InputLines& lines, const std::filesystem::path& path);

/// The same of all bytes of a file.
TableSum check_table_text(std::string_view text, const std::filesystem::path& path);

/// Remarks of a person on a configuration, beside its numbers: shown, and part of no digest. UTF-8 without
/// control characters, but line ends in the note.
struct Captions {
  std::string title{}, author{}, note{};

  bool operator==(const Captions&) const = default;
};

/// Comment lines for the head of a table, each with its end: `# title T`, `# author A`, and one `# note N`
/// for every line of the note. Empty where nothing is said.
std::string caption_lines(const Captions& captions);

/// Texts by file name; tables without the head that all tables have.
using ResultFiles = std::map<std::string_view, std::string>;

/// Program that wrote some results, and the study that they belong to.
struct ResultSource {
  std::string program;  ///< name without version
  std::string digest;
  std::string captions{};              ///< lines as caption_lines gives them
  std::vector<std::string> made_of{};  ///< names of files in the same directory that the results are made of
};

/// Replaces the files `names` of a directory, all that a run may leave there, by those of a new run: a file
/// of `names` without a text is removed. A directory never mixes two runs, wherever the process or the power
/// ends: all new files are on the disk before the first of the old ones goes, and all old ones are gone
/// before the first new one has its name. Throws IoError.
void write_result_files(const ResultFiles& files, std::span<const std::string_view> names,
                        const std::filesystem::path& directory, const ResultSource& source);

/// Removes the existing files of `names`, on the disk as well, and temporaries that killed processes left for
/// these names. Throws IoError.
void remove_result_files(std::span<const std::string_view> names, const std::filesystem::path& directory);

/// The head of a table of such results that grows, and so has no checksum.
std::string growing_table_head(const ResultSource& source);

/// "files     DIRECTORY: NAME NAME" and a line end.
std::string files_line(const ResultFiles& files, const std::filesystem::path& directory);

/// The directory of another result of the study whose map goes into `map`: results/map and results/map/ to
/// results/map_trace.
std::filesystem::path directory_beside(const std::filesystem::path& map, std::string_view ending);

}  // namespace rubsweep::batch
