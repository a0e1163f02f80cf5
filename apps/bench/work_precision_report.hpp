#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bench/label_agreement.hpp"
#include "bench/reference.hpp"
#include "bench/work_precision.hpp"

namespace rubsweep::bench {

/// One line of a work-precision table: one variant on one cell.
struct WorkPrecisionLine {
  std::string cell;
  Measurement measurement;
  std::optional<LabelAgreement> labels{};  ///< agreement over the whole map; empty: not wanted or too slow
  bool labels_too_slow = false;
  Reference reference{};  ///< solution against which the state error was measured
};

/// Name of a cell, such as "75 Hz whirl 0.4" or "75 Hz e 3e-05 m".
std::string cell_name(const scene::Place& place);

/// Name of a variant, such as "adaptive dopri5 located 1e-08"; "exact located" for closed forms and Taylor
/// pieces.
std::string variant_name(const Variant& variant);

/// One sentence about the reference of a cell, its error, and its distance from other solvers.
std::string reference_sentence(const std::string& cell, const Reference& reference);

/// Lines beginning with `#` that explain the columns.
std::string work_precision_comments(const WorkPrecisionOptions& options);

/// Header and rows as CSV. steps, switches and rhs_calls belong to one timed run; empty: does not apply.
std::string work_precision_csv(const std::vector<WorkPrecisionLine>& lines);

/// Table for a terminal, with numbers per revolution, followed by the names of all variants whose status is
/// not `ok`.
std::string work_precision_table(const std::vector<WorkPrecisionLine>& lines, int turns);

/// `ok`, or one word per cause joined by ';': the outcome of the run, `labels_cut` (the time was up before
/// every cell was compared), `labels_too_slow` (no cell was compared).
std::string status_of(const WorkPrecisionLine& line);

}  // namespace rubsweep::bench
