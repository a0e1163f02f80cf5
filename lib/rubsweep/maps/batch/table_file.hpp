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

/// Version of the layout of tables, given by `# format`. New columns at the end or new comments do not change
/// it.
inline constexpr int table_format = 1;

/// Program that wrote a table, and the study to which its numbers belong.
struct TableSource {
  std::string program;             ///< name with version: "rubsweep 1.0.0"
  std::string digest;              ///< digest of everything that decides the numbers
  std::vector<std::string> files;  ///< names of all files that were written together; empty: only this one
  std::string captions{};          ///< comment lines of title, author and note (see Captions)
  std::vector<std::pair<std::string, std::string>>
      sums{};  ///< SHA-256 of files that cannot contain it, by name
};

/// Comment lines at the begin of every table, without the checksum, because a growing table has none.
std::string table_head(const TableSource& source);

/// Comma-separated file with its comment lines (table_head). It appears whole or not at all. Its line `#
/// sha256 DIGITS` has the SHA-256 of all other lines: `sed '/^# sha256 /d' FILE | sha256sum`. Every function
/// throws IoError.
class TableFile {
 public:
  TableFile(std::filesystem::path path, const TableSource& source);

  /// Writes comments, header and rows below the head.
  void write(std::string_view text);

  /// Like WholeFile::finish; nothing may be written afterwards.
  void finish();
  void commit();
  void rename();

 private:
  WholeFile file_;
  Sha256 sum_;
  std::size_t place_of_sum_ = 0;
  bool finished_ = false;
};

/// Thrown where a table was changed after it was written.
class DamagedTable : public IoError {
  using IoError::IoError;
};

enum class TableSum {
  right,
  none  ///< no checksum: an old version of the program, or another program, wrote the table
};

/// Compares a table with its checksum. Throws DamagedTable where they do not agree, or where a table that
/// must have a checksum has none. Throws IoError. Line ends CR LF of other systems count as LF.
TableSum check_table(const std::filesystem::path& path);

/// Checks the table in an open file, which must be at its begin and is there again afterwards.
TableSum check_table(InputLines& lines, const std::filesystem::path& path);

/// Checks the table with these bytes; `path` is only for messages.
TableSum check_table_text(std::string_view text, const std::filesystem::path& path);

/// Remarks of a person on a configuration. They are shown with the results, but no digest includes them.
/// UTF-8 without control characters; the note may have line ends.
struct Captions {
  std::string title{}, author{}, note{};

  bool operator==(const Captions&) const = default;
};

/// Comment lines for the head of a table, each with its line end: `# title T`, `# author A`, and `# note N`
/// for every line of the note. Empty where all captions are empty.
std::string caption_lines(const Captions& captions);

/// Texts by file name. Tables are given without the comment lines that write_result_files adds at their
/// begin.
using ResultFiles = std::map<std::string_view, std::string>;

/// Program that wrote some results, and the study to which they belong.
struct ResultSource {
  std::string program;  ///< name without version
  std::string digest;
  std::string captions{};              ///< lines as caption_lines gives them
  std::vector<std::string> made_of{};  ///< files in the same directory from which the results were computed
};

/// Replaces the files `names` of a directory (all that a run may write there) by those of a new run. A file
/// of `names` without a text is removed. A directory never mixes two runs, even after a crash or a loss of
/// power. First all new files are written to the disk under temporary names, then all old files are removed,
/// and only then do the new files get their names. Throws IoError.
void write_result_files(const ResultFiles& files, std::span<const std::string_view> names,
                        const std::filesystem::path& directory, const ResultSource& source);

/// Removes the existing files of `names`, also on the disk, and temporary files for these names that killed
/// processes left. Throws IoError.
void remove_result_files(std::span<const std::string_view> names, const std::filesystem::path& directory);

/// Comment lines at the begin of a table of `source` that still grows and therefore has no checksum.
std::string growing_table_head(const ResultSource& source);

/// Line for a terminal, "files     DIRECTORY: NAME NAME", with its line end.
std::string files_line(const ResultFiles& files, const std::filesystem::path& directory);

/// Directory for another result of the study whose map is written to `map`: with the ending trace,
/// results/map or results/map/ gives results/map_trace.
std::filesystem::path directory_beside(const std::filesystem::path& map, std::string_view ending);

}  // namespace rubsweep::batch
