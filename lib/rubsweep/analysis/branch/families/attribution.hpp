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

/// Kind of quiet motion of a cell, which is there in closed form.
enum class Quiet {
  stable,    ///< no contact, and free vibration about it decays
  unstable,  ///< no contact, but free vibration grows
  touches,   ///< no such motion: it would reach a wall, or there is none
};

/// The quiet motion of every cell of the grid.
std::vector<Quiet> quiet_cells(const sweep::Study& study);

/// Why two neighbouring cells of a map have different labels.
enum class Attribution {
  ceases,  ///< a motion that one of the kicks leads to ends between them, or loses its stability
  basin,   ///< a motion that one of the kicks leads to, the quiet one included, exists and is stable in both
           ///< cells: the kick of the other one no longer reaches it
  unresolved,  ///< neither cell has a motion that could be followed, or following it failed
};

constexpr std::string_view to_string(Attribution attribution) { return enumerator_word(attribution); }

struct MapEdge {
  std::size_t first = 0, second = 0;
  Attribution attribution = Attribution::unresolved;
  /// Kind of event where a motion ceases; where unresolved why, or empty; of a basin empty where both motions
  /// are on both sides, `one_motion` where that is known of one of them, and the other one may cease as well.
  std::string_view kind;
};

constexpr std::string_view one_motion = "one_motion";

/// Whether `kind` is something that happens to an orbit, and not to following it.
bool is_an_end(std::string_view kind);

/// Every pair of neighbouring cells with different labels. For each cell of the grid: its label, and its
/// quiet motion, which is what the cells labelled `quiet_label` settle on.
std::vector<MapEdge> attribute(const sweep::Grid& grid, std::span<const std::string> labels,
                               const std::vector<Family>& families, std::span<const Quiet> quiet,
                               std::string_view quiet_label);

/// Verdict on the label of a cell beside the domain of a family.
enum class CheckResult {
  reached,        ///< inside: the kick leads to the family's orbit
  stays,          ///< inside: the machine that starts on the family's orbit, without a kick, settles on it
  another_orbit,  ///< outside: the label is that of another orbit, which is there inside as well
  ends_as_well,   ///< outside: it is that of another orbit, which ends on the way in, too
  // From here on: contradictions.
  leaves,        ///< inside: the machine that starts on the orbit settles on something else
  same_orbit,    ///< outside: the other family's orbit, followed inside, is this one
  not_followed,  ///< outside: following failed on the way out, or that of the other orbit on the way in
  not_found,     ///< the proven orbit of the cell is not found again
  unproven,      ///< outside: the label rests on no proof, so that there is no orbit to compare
};

constexpr std::string_view to_string(CheckResult finding) { return enumerator_word(finding); }
inline constexpr auto all_findings = words_of<CheckResult>().values;

constexpr bool contradicts(CheckResult finding) { return finding >= CheckResult::leaves; }

/// One label that was looked at.
struct LabelCheck {
  std::size_t cell = 0;
  std::optional<std::size_t> family;  ///< number in the list; empty: no family has the cell
  bool inside = true;                 ///< inside the family's domain; else just outside
  CheckResult finding = CheckResult::reached;
  std::string_view end;                     ///< outside: what ends the family on the way there
  std::optional<std::size_t> other_family;  ///< outside: that which the kick leads to
};

/// Looks at the label of every cell inside of the domain of a family, and of every cell just outside of it
/// that has the label of the family (that of its first cell). Inside, the orbit exists and is stable by
/// continuation: where the kick does not lead to it, the machine is started on it and must settle on it,
/// which the proofs of `response::settle` decide. Outside, the orbit does not go on: a cell with its label
/// must be on another orbit. `labels`: one per cell of the grid. Once `stop` is true nothing more is begun,
/// and what is returned is not whole. What is found goes to `records`, as in `families_of`.
std::vector<LabelCheck> check_labels(const sweep::Study& study, std::span<const std::string> labels,
                                     const Families& families, int threads, const std::atomic<bool>& stop,
                                     FamilyRecords& records);

}  // namespace rubsweep::branch::families
