#pragma once

#include <string>
#include <vector>

#include "rubsweep/analysis/design/design_check.hpp"

namespace rubsweep::design {

/// Term for a clearance, without a verdict.
Term clearance_term(std::string check, const ClearanceMargin& margin);

/// All terms of a check: vibration, clearances, dry whip, stability, those of the lateral analysis, the
/// smallest kick.
std::vector<Term> terms_of(const DesignCheck& check);

/// Verdict of a whole check. not_met: a limit is not met. not_told: all known limits are met, but some term
/// is unknown. pass: all limits are met.
enum class Answer { pass, not_met, not_told };
Answer answer_of(const DesignCheck& check);

}  // namespace rubsweep::design
