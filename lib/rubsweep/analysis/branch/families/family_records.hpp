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

/// Results of following families so far, cell by cell, so that a second run need not find them again. Every
/// number is kept to its last bit, and what is found depends on the study alone: families that are followed
/// with records are those that are followed without.
class FamilyRecords {
 public:
  /// Where each new record goes as one line of text, together with the cell that it belongs to.
  using Keep = std::function<void(std::size_t cell, std::string_view line)>;

  FamilyRecords() = default;
  explicit FamilyRecords(Keep keep) : keep_(std::move(keep)) {}

  /// Takes back a line that was kept for `cell`. False where it is none of this class.
  bool read(std::size_t cell, std::string_view line);

  /// The orbit that a cell settles on, empty where there is none to follow; null where that is not known yet.
  const std::optional<CellOrbit>* settled(std::size_t cell) const;
  void keep_settled(std::size_t cell, const std::optional<CellOrbit>& orbit);

  /// Passage of the orbit of the family of `seed` on the way between two cells; null: not known yet.
  const Passage* passage(std::size_t seed, std::size_t from, std::size_t to) const;
  void keep_passage(std::size_t seed, std::size_t from, std::size_t to, const Passage& passage);

  /// Whether the machine that starts on the orbit of the family of `seed` in a cell settles on it; empty: not
  /// known yet.
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
