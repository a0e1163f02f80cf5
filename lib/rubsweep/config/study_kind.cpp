#include "rubsweep/config/study_kind.hpp"

#include <algorithm>
#include <array>
#include <functional>

#include "rubsweep/config/key_axis.hpp"
#include "rubsweep/config/section.hpp"

namespace rubsweep::config {
namespace {

constexpr std::string_view threshold_kind = "threshold";
constexpr std::array kinds{threshold_kind};
constexpr model::Range tolerances{.low = 1e-12, .high = 0.5};

sweep::ThresholdScan read_threshold(Section& section) {
  sweep::ThresholdScan scan{read_key_axis(section)};
  section.field("tolerance", scan.tolerance, tolerances);
  const std::vector<double>& values = scan.axis.values;
  const bool ascending = std::ranges::adjacent_find(values, std::greater_equal<>()) == values.end();
  if (!values.empty() && (values.size() < 2 || !ascending)) {
    section.refuse_together(section.find("values") ? "values" : "count", {"values", "from", "to", "count"},
                            values.size() < 2 ? "one value is no scan" : "does not ascend",
                            "two values or more, each larger than the one before");
  }
  return scan;
}

}  // namespace

void read_study_kind(const Value& value, sweep::Study& study) {
  Section section(value);
  const auto kind = section.require_kind("kind", kinds);
  if (!kind) return;
  study.threshold = read_threshold(section);
  section.refuse_unknown_keys();
}

void print_study_kind(Printer& printer, const sweep::Study& study) {
  if (!study.threshold) return;
  printer.open("study");
  printer.word("kind", threshold_kind);
  print_key_axis(printer, study.threshold->axis);
  printer.number("tolerance", study.threshold->tolerance);
  printer.close();
}

}  // namespace rubsweep::config
