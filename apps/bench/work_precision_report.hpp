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
  std::optional<LabelAgreement> labels{};  ///< agreement over the whole map; empty: not asked or too slow
  bool labels_too_slow = false;
  Reference reference{};  ///< solver that the state error was measured against
};

/// "75 Hz whirl 0.4" or "75 Hz e 3e-05 m".
std::string cell_name(const scene::Place& place);

/// "adaptive dopri5 located 1e-08", or "exact located" of closed forms and Taylor pieces.
std::string variant_name(const Variant& variant);

/// One sentence on the reference of a cell, what is known of its error, and how far other routes are away.
std::string reference_sentence(const std::string& cell, const Reference& reference);

/// `#` lines that explain the columns, one per line with its end.
std::string work_precision_comments(const WorkPrecisionOptions& options);

/// Header and rows. steps, switches and rhs_calls are those of one timed run; empty: does not apply.
std::string work_precision_csv(const std::vector<WorkPrecisionLine>& lines);

/// The same for a terminal: per revolution, and then every variant whose status is not `ok` by its name.
std::string work_precision_table(const std::vector<WorkPrecisionLine>& lines, int turns);

/// `ok` or one word per cause joined by ';': the outcome of the run, `labels_cut` (time was up before every
/// cell was compared), `labels_too_slow` (none was).
std::string status_of(const WorkPrecisionLine& line);

}  // namespace rubsweep::bench
