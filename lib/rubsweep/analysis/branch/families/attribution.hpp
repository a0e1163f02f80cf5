#pragma once

#include <atomic>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "rubsweep/analysis/branch/families/family.hpp"
#include "rubsweep/analysis/branch/families/family_records.hpp"
#include "rubsweep/core/vocabulary.hpp"
#include "rubsweep/maps/sweep/study.hpp"

namespace rubsweep::branch::families {

/// Kind of the quiet motion of a cell, known in closed form.
enum class Quiet {
  stable,    ///< no contact, and free vibration decays
  unstable,  ///< no contact, but free vibration grows
  touches,   ///< no quiet motion: it would reach a wall, or does not exist
};

/// Kind of the quiet motion in every cell of the grid.
std::vector<Quiet> quiet_cells(const sweep::Study& study);

/// Reason why two neighbouring cells of a map have different labels.
enum class Attribution {
  ceases,  ///< the motion after one of the kicks ends between the cells, or loses its stability
  /// the motion after one of the kicks (perhaps the quiet one) exists and is stable in both cells, but the
  /// kick of the other cell does not lead to it
  basin,
  unresolved,  ///< no motion of either cell could be followed to the other
};

constexpr std::string_view to_string(Attribution attribution) { return enumerator_word(attribution); }

struct MapEdge {
  std::size_t first = 0, second = 0;
  Attribution attribution = Attribution::unresolved;
  /// Event at which a motion ceases. For `unresolved` the reason, if known. For `basin` empty if both motions
  /// exist in both cells; `one_motion` if this is known of one motion only, while the other may have ceased.
  std::string_view kind;
};

constexpr std::string_view one_motion = "one_motion";

/// Whether `kind` is an event of the orbit, and not a failure to follow it.
bool is_an_end(std::string_view kind);

/// Attribution of every pair of neighbouring cells with different labels. `labels` and `quiet` have one
/// element for each cell of the grid. Cells with `quiet_label` settle on the quiet motion.
std::vector<MapEdge> attribute(const sweep::Grid& grid, std::span<const std::string> labels,
                               const std::vector<Family>& families, std::span<const Quiet> quiet,
                               std::string_view quiet_label);

/// Result of checking the label of a cell in or beside the domain of a family.
enum class CheckResult {
  reached,        ///< inside: the kick leads to the family's orbit
  stays,          ///< inside: without a kick, the machine started on the family's orbit settles on it
  another_orbit,  ///< outside: the label is that of another orbit, which also exists inside
  ends_as_well,   ///< outside: the label is that of another orbit, which ends on the way in
  // The results below are contradictions.
  leaves,      ///< inside: the machine started on the orbit settles on something else
  same_orbit,  ///< outside: the other family's orbit, followed inside, is this same orbit
  /// outside: the continuation failed, either of this family outwards or of the other orbit inwards
  not_followed,
  not_found,  ///< the proven orbit of the cell could not be found again
  unproven,   ///< outside: the label is not proven, so that there is no orbit to compare
};

constexpr std::string_view to_string(CheckResult finding) { return enumerator_word(finding); }
inline constexpr auto all_findings = words_of<CheckResult>().values;

constexpr bool contradicts(CheckResult finding) { return finding >= CheckResult::leaves; }

/// Check of one label.
struct LabelCheck {
  std::size_t cell = 0;
  std::optional<std::size_t> family;  ///< index in the list of families; empty: no family has the cell
  bool inside = true;                 ///< true: inside the family's domain; false: just outside
  CheckResult finding = CheckResult::reached;
  std::string_view end;                     ///< outside: event that ends the family on the way there
  std::optional<std::size_t> other_family;  ///< outside: family to which the kick leads
};

/// Checks the label of every cell inside the domain of a family, and of every cell just outside that has the
/// family's label (the label of its first cell). Inside, the orbit exists and is stable according to
/// continuation. If the kick does not lead to the orbit, the machine is started on it and must settle on it
/// by the proofs of `response::settle`. Outside, the orbit does not continue, so that a cell with the label
/// must be on another orbit. `labels`: one per cell of the grid. Once `stop` is true no new check begins, and
/// the result is incomplete. New results are added to `records`, as in `families_of`.
std::vector<LabelCheck> check_labels(const sweep::Study& study, std::span<const std::string> labels,
                                     const Families& families, int threads, const std::atomic<bool>& stop,
                                     FamilyRecords& records);

}  // namespace rubsweep::branch::families
