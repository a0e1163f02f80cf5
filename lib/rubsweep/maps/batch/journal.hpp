#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "rubsweep/core/error.hpp"
#include "rubsweep/maps/batch/opened_file.hpp"
#include "rubsweep/maps/batch/whole_file.hpp"

namespace rubsweep::batch {

/// Identity of the computation that the results in a journal belong to. Results of two journals with equal
/// digests and cells may be mixed.
struct JournalHeader {
  std::string study_digest;       ///< digest of everything that decides the results
  std::string program_digest;     ///< digest of the code that computes them
  std::size_t cells = 0;          ///< cells of the whole grid; records name cells 0 ... cells - 1
  std::string study;              ///< the study itself as lines of text, so that a difference can be named
  std::size_t damaged_lines = 0;  ///< lines that could not be read and were not needed
};

/// Thrown where a journal does not say which computation its records belong to.
class DamagedJournal : public IoError {
  using IoError::IoError;
};

/// True when results under one header are results under the other: by the digests, or by the study where the
/// digest of `a` was damaged.
bool same_results(const JournalHeader& a, const JournalHeader& b);

/// A finished cell as the journal holds it.
struct JournalRecord {
  std::size_t cell;
  std::string_view text;  ///< one line without its end
  std::uint64_t offset;   ///< place of the text in the file
};

/// Reads the header before the records. Damaged lines are ignored where the others suffice: the
/// first line, the study as long as its digest is good, the digest as long as the study is (it
/// is empty then), the line before the records. Throws DamagedJournal where they do not, or
/// IoError.
JournalHeader read_journal_header(const std::filesystem::path& path);

/// Hands every good record to `on_record`, in the order of the file, and returns how many were damaged on the
/// disk: their cells are simply not finished, as is that of a last record that the end of a process tore. A
/// cell may come more than once. Throws IoError as read_journal_header.
std::size_t read_journal(const std::filesystem::path& path,
                         const std::function<void(const JournalRecord&)>& on_record);

/// An append-only file of finished cells: one line each, `CRC-32 cell text`, so that every record stands for
/// itself. The header is written whole or not at all.
class Journal {
 public:
  /// Continues the journal at `path`, whose header must have been found to fit, or begins one. Throws
  /// IoError.
  Journal(const std::filesystem::path& path, const JournalHeader& header);

  /// Keeps a finished cell, `text` being one line. Throws IoError; SolverError when `text` has a line end.
  void append(std::size_t cell, std::string_view text);

  // As those of LineLog.
  void refresh() { log_.refresh(); }
  void sync() { log_.sync(); }

 private:
  LineLog log_;
};

/// Index of the cells of a grid that some journals hold. Takes eight bytes for each cell of the grid: the
/// texts stay in the files, which must not shrink meanwhile.
class FinishedCells {
 public:
  explicit FinishedCells(std::size_t cells) : places_(cells, nowhere) {}

  /// Adds the good records of a journal, of which the first one counts for a cell. Returns how many records
  /// were damaged. The journal must be one of this grid. Throws IoError.
  std::size_t add(const std::filesystem::path& journal);

  std::size_t count() const { return count_; }
  bool contains(std::size_t cell) const { return places_[cell] != nowhere; }

  /// Cells that no journal holds, ascending.
  std::vector<std::size_t> missing() const;

  /// Text in the journal of a cell that it contains. Throws IoError.
  std::string text(std::size_t cell) const;

 private:
  static constexpr std::uint64_t nowhere = ~std::uint64_t{0};

  struct File {
    std::filesystem::path path;
    Descriptor descriptor;
  };

  std::vector<File> files_;
  /// Place of each cell: the index of the file in the upper 16 bits, below it the offset of the text.
  std::vector<std::uint64_t> places_;
  std::size_t count_ = 0;
};

}  // namespace rubsweep::batch
