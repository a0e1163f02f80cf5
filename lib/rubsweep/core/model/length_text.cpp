#include "rubsweep/core/model/length_text.hpp"

#include <fmt/format.h>

#include <array>
#include <cstddef>

namespace rubsweep::model {
namespace {

struct UnitRow {
  LengthUnit unit;
  std::string_view word;
  double in_a_metre;
};

constexpr std::array unit_rows{UnitRow{LengthUnit::m, "m", 1}, UnitRow{LengthUnit::mm, "mm", 1e3},
                               UnitRow{LengthUnit::um, "um", 1e6},
                               UnitRow{LengthUnit::mil, "mil", 1 / 25.4e-6}};

}  // namespace

std::optional<LengthUnit> length_unit_of(std::string_view word) {
  for (const UnitRow& row : unit_rows)
    if (row.word == word && row.unit != LengthUnit::m) return row.unit;
  return std::nullopt;
}

std::string_view word_of(LengthUnit unit) { return unit_rows[static_cast<std::size_t>(unit)].word; }

std::string length_text(double length_m, const ShownLengths& shown, LengthUnit usual, int digits) {
  const UnitRow& row = unit_rows[static_cast<std::size_t>(shown.unit.value_or(usual))];
  return fmt::format("{:.{}g} {}", length_m * row.in_a_metre, digits, row.word);
}

std::string amplitude_text(double amplitude_m, const ShownLengths& shown, LengthUnit usual, int digits) {
  if (!shown.peak_to_peak) return length_text(amplitude_m, shown, usual, digits);
  return length_text(2 * amplitude_m, shown, usual, digits) + " peak to peak";
}

}  // namespace rubsweep::model
