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

/// Identity of the computation to which the results in a journal belong. Results of two journals with equal
/// digests and cells may be mixed.
struct JournalHeader {
  std::string study_digest;       ///< digest of everything that decides the results
  std::string program_digest;     ///< digest of the code that computes the results
  std::size_t cells = 0;          ///< cells of the whole grid; records have cells 0 ... cells - 1
  std::string study;              ///< study as lines of text, to name differences
  std::size_t damaged_lines = 0;  ///< number of damaged lines that the reader could do without
};

/// Thrown where a journal is too damaged to show to which computation its records belong.
class DamagedJournal : public IoError {
  using IoError::IoError;
};

/// Whether results of both journals may be mixed: compares their digests, or the studies if the digest of `a`
/// was damaged.
bool same_results(const JournalHeader& a, const JournalHeader& b);

/// One finished cell in a journal.
struct JournalRecord {
  std::size_t cell;
  std::string_view text;  ///< one line without its end
  std::uint64_t offset;   ///< place of the text in the file
};

/// Reads the header above the records. Damage to one part is ignored where the other parts suffice: to the
/// first line, to the line above the records, to the study if its digest is intact, or to the digest (then
/// left empty) if the study is intact. Throws DamagedJournal where more is damaged, or IoError.
JournalHeader read_journal_header(const std::filesystem::path& path);

/// Calls `on_record` with every undamaged record, in the order of the file, and returns the number of damaged
/// records. Their cells count as not finished; the same holds for the cell of a last record that is cut off.
/// A cell may occur more than once. Throws IoError as read_journal_header does.
std::size_t read_journal(const std::filesystem::path& path,
                         const std::function<void(const JournalRecord&)>& on_record);

/// Append-only file of finished cells: one line each, `CRC-32 cell text`, so that every record can be
/// verified separately. The header is written whole or not at all.
class Journal {
 public:
  /// Continues the journal at `path`, or begins a new one. The caller must have checked that an existing
  /// header fits. Throws IoError.
  Journal(const std::filesystem::path& path, const JournalHeader& header);

  /// Adds a finished cell; `text` is one line. Throws IoError, and SolverError where `text` has a line end.
  void append(std::size_t cell, std::string_view text);

  // Same functions as in LineLog.
  void refresh() { log_.refresh(); }
  void sync() { log_.sync(); }

 private:
  LineLog log_;
};

/// Index of the finished cells in several journals. It takes eight bytes for each cell of the grid. The texts
/// stay in the files, which must not become shorter.
class FinishedCells {
 public:
  explicit FinishedCells(std::size_t cells) : places_(cells, nowhere) {}

  /// Adds the undamaged records of a journal of this grid; the first record of a cell counts. Returns the
  /// number of damaged records. Throws IoError.
  std::size_t add(const std::filesystem::path& journal);

  std::size_t count() const { return count_; }
  bool contains(std::size_t cell) const { return places_[cell] != nowhere; }

  /// Cells that no journal holds, ascending.
  std::vector<std::size_t> missing() const;

  /// Text of a finished cell, read from its journal. Throws IoError.
  std::string text(std::size_t cell) const;

 private:
  static constexpr std::uint64_t nowhere = ~std::uint64_t{0};

  struct File {
    std::filesystem::path path;
    Descriptor descriptor;
  };

  std::vector<File> files_;
  /// Position of each cell's record: upper 16 bits index of the file, lower 48 bits offset of the text.
  std::vector<std::uint64_t> places_;
  std::size_t count_ = 0;
};

}  // namespace rubsweep::batch
