#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <string_view>
#include <tuple>
#include <utility>

#include "rubsweep/analysis/branch/families/passage.hpp"

namespace rubsweep::branch::families {

/// Results of following families, cell by cell, so that a second run can reuse them. Numbers are stored
/// exactly, and results depend on the study alone. Families are therefore the same with and without records.
class FamilyRecords {
 public:
  /// Function that stores each new record as one line of text, with the cell to which it belongs.
  using Keep = std::function<void(std::size_t cell, std::string_view line)>;

  FamilyRecords() = default;
  explicit FamilyRecords(Keep keep) : keep_(std::move(keep)) {}

  /// Reads back a line that was stored for `cell`. False where the line is no record of this class.
  bool read(std::size_t cell, std::string_view line);

  /// Orbit on which a cell settles, empty if there is none to follow; a null pointer if this is not known
  /// yet.
  const std::optional<CellOrbit>* settled(std::size_t cell) const;
  void keep_settled(std::size_t cell, const std::optional<CellOrbit>& orbit);

  /// Passage of the orbit of family `seed` on the way between two cells; null if not known yet.
  const Passage* passage(std::size_t seed, std::size_t from, std::size_t to) const;
  void keep_passage(std::size_t seed, std::size_t from, std::size_t to, const Passage& passage);

  /// Whether the machine, started in a cell on the orbit of family `seed`, settles on it; empty: not known
  /// yet.
  std::optional<bool> stays(std::size_t seed, std::size_t cell) const;
  void keep_stays(std::size_t seed, std::size_t cell, bool stays);

 private:
  void keep(std::size_t cell, std::string_view line) const;

  Keep keep_;
  std::map<std::size_t, std::optional<CellOrbit>> settled_;
  std::map<std::tuple<std::size_t, std::size_t, std::size_t>, Passage> passages_;
  std::map<std::pair<std::size_t, std::size_t>, bool> stays_;
};

}  // namespace rubsweep::branch::families
