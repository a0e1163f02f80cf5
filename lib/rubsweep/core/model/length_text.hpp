#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace rubsweep::model {

/// A mil is a thousandth of an inch.
enum class LengthUnit { m, mm, um, mil };

/// The unit that a command line calls "mm", "um" or "mil"; empty for any other word.
std::optional<LengthUnit> length_unit_of(std::string_view word);

/// The word of a unit, "m" among them.
std::string_view word_of(LengthUnit unit);

/// How lengths are said to a reader.
struct ShownLengths {
  std::optional<LengthUnit> unit = {};  ///< unit that was asked for; empty: the usual one of the text
  bool peak_to_peak = false;            ///< amplitudes as twice their size, as vibration is often given
};

/// A length (m) in the unit that was asked for, else in the usual one: "0.85 mil", rounded to so many digits.
std::string length_text(double length_m, const ShownLengths& shown, LengthUnit usual, int digits = 4);

/// The same of the amplitude of a vibration: "1.7 mil peak to peak" where that was asked for.
std::string amplitude_text(double amplitude_m, const ShownLengths& shown, LengthUnit usual, int digits = 4);

}  // namespace rubsweep::model
