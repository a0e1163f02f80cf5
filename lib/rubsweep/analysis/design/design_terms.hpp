#pragma once

#include <string>
#include <vector>

#include "rubsweep/analysis/design/design_check.hpp"

namespace rubsweep::design {

/// Term for a clearance, without a verdict.
Term clearance_term(std::string check, const ClearanceMargin& margin,
                    const std::vector<std::string>& stop_names);

/// All terms of a check: vibration, clearances, dry whip, stability, those of the lateral analysis, the
/// smallest kick.
std::vector<Term> terms_of(const DesignCheck& check);

/// Verdict of a whole check: some limit is not kept; else there is a term that nothing is known of; else all
/// are met. Level I asks for nothing, since Level II decides.
enum class Answer { pass, not_met, not_told };
Answer answer_of(const DesignCheck& check);

}  // namespace rubsweep::design
