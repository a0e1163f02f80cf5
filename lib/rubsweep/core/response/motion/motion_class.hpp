#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "rubsweep/core/response/spectrum/orbit_shape.hpp"
#include "rubsweep/core/vocabulary.hpp"

namespace rubsweep::response::motion {

/// Classes of motion.
enum class MotionClass {
  non_contact,
  synchronous,
  resting_contact,
  subharmonic,
  quasi_periodic,
  chaotic,
  unsettled,
  initial_contact,
  failed,
};

/// Properties of one class. Maps, summaries, comparisons and help texts use this table; colours are in
/// MotionKind.
struct MotionClassRow {
  std::string_view word;         ///< word in map.csv
  std::string_view description;  ///< text for --help
  bool rubs = false;             ///< the rotor keeps touching a stop
  /// true: measures do not depend on when they are taken, so that maps may be compared
  bool repeats = false;
};

/// Table of all classes. It is a switch so that a class without a row does not compile.
constexpr MotionClassRow row_of(MotionClass motion_class) {
  switch (motion_class) {
    case MotionClass::non_contact:
      return {.word = "non_contact",
              .description = "no contact after the kick's transient",
              .rubs = false,
              .repeats = true};
    case MotionClass::synchronous:
      return {.word = "synchronous",
              .description = "the section returns after one turn",
              .rubs = true,
              .repeats = true};
    case MotionClass::resting_contact:
      return {.word = "resting_contact",
              .description = "pressed on a stop and at rest there: no line but 0X",
              .rubs = true,
              .repeats = true};
    case MotionClass::subharmonic:
      return {.word = "subharmonic",
              .description = "the section returns after n >= 2 turns and no fewer",
              .rubs = true,
              .repeats = true};
    case MotionClass::quasi_periodic:
      return {.word = "quasi_periodic",
              .description = "discrete lines without a common period; in symmetric scenes a comb",
              .rubs = true,
              .repeats = false};
    case MotionClass::chaotic:
      return {.word = "chaotic",
              .description = "largest Lyapunov exponent positive beyond its error bar",
              .rubs = true,
              .repeats = false};
    case MotionClass::unsettled:
      return {.word = "unsettled",
              .description = "not decided when the run ended",
              .rubs = true,
              .repeats = false};
    case MotionClass::initial_contact:
      return {.word = "initial_contact",
              .description =
                  "static forces press the rotor on the wall, so that no unbalance gives the whirl "
                  "ratio asked for",
              .rubs = false,
              .repeats = false};
    case MotionClass::failed:
      return {
          .word = "failed", .description = "the integration did not finish", .rubs = false, .repeats = false};
  }
  return {};
}

/// Word of a class in map.csv; empty for a number that is no class.
constexpr std::string_view to_string(MotionClass motion_class) { return row_of(motion_class).word; }

/// All classes, in the order of the enumeration.
inline constexpr auto motion_classes =
    enumerators_of<MotionClass, [](MotionClass motion_class) { return row_of(motion_class).word; }>;

/// Class for a word in map.csv; empty for any other word.
constexpr std::optional<MotionClass> motion_class_of(std::string_view word) {
  const auto found = std::ranges::find(motion_classes, word,
                                       [](MotionClass motion_class) { return to_string(motion_class); });
  return found == motion_classes.end() ? std::nullopt : std::optional(*found);
}

/// A kind of motion as maps show it: the class, the order of a subharmonic motion, and the shape and
/// direction by which motions at an annular stop differ. Terminal, figures and report use this table.
struct MotionKind {
  std::string_view name;      ///< name in map.csv
  std::string_view label;     ///< label in legends
  std::uint32_t colour;       ///< 0xRRGGBB
  std::uint32_t dark_colour;  ///< colour on a dark background
  char sign;                  ///< letter on a terminal; a subharmonic motion shows the digit of its order
  bool hatched = false;       ///< true: hatched in figures
  bool settled_rub = true;
};

/// The colours of most periodic kinds are from Paul Tol's "muted" scheme for colour-blind readers; the other
/// kinds have colours of their own.
inline constexpr std::array motion_kinds{
    MotionKind{"non_contact", "no contact", 0xF4F4F4, 0x2B2F36, '.', false, false},
    MotionKind{"synchronous_circle", "synchronous circle", 0x4F9BD0, 0x4F9BD0, '1'},
    MotionKind{"synchronous_circle_backward", "backward circle", 0xF4A6B8, 0xF4A6B8, '1'},
    MotionKind{"synchronous", "synchronous", 0x88CCEE, 0x88CCEE, '1'},
    MotionKind{"resting_contact", "at rest on a stop", 0xA8C686, 0xA8C686, 'r'},
    MotionKind{"subharmonic_2", "subharmonic 1/2", 0xCC6677, 0xCC6677, '2'},
    MotionKind{"subharmonic_3", "subharmonic 1/3", 0x332288, 0x5A48C8, '3'},
    MotionKind{"subharmonic_4", "subharmonic 1/4", 0xDDCC77, 0xDDCC77, '4'},
    MotionKind{"subharmonic_5", "subharmonic 1/5", 0x117733, 0x117733, '5'},
    MotionKind{"subharmonic_6", "subharmonic 1/6", 0x882255, 0x882255, '6'},
    MotionKind{"subharmonic_7", "subharmonic 1/7", 0x44AA99, 0x44AA99, '7'},
    MotionKind{"subharmonic_8", "subharmonic ≤ 1/8", 0x999933, 0x999933, '8'},
    MotionKind{"quasi_periodic_oval", "quasi-periodic oval", 0xEE8866, 0xEE8866, 'o'},
    MotionKind{"quasi_periodic_whip", "backward dry whip", 0x7A4F20, 0x7A4F20, 'w'},
    MotionKind{"quasi_periodic", "quasi-periodic", 0xAA4499, 0xAA4499, 'q'},
    MotionKind{"chaotic", "chaotic", 0x000000, 0xFFFFFF, '*'},
    MotionKind{"unsettled", "unsettled", 0x555555, 0x8A8A8A, '?', true, false},
    MotionKind{"initial_contact", "pressed on the wall", 0x999999, 0x999999, '#', true, false},
    MotionKind{"failed", "failed", 0xCC0000, 0xCC0000, '!', true, false},
};

/// Kind for a name in map.csv; null for any other word.
const MotionKind* motion_kind_of(std::string_view name);

/// Kind of a motion. `order`: of a periodic motion; `orbit`, `whirl`: shape and direction, if it has any;
/// `comb`: it is a closed orbit in the rotating frame (Measures::comb_spacing).
const MotionKind& kind_of(MotionClass motion_class, std::optional<int> order,
                          std::optional<spectrum::OrbitKind> orbit, std::optional<spectrum::WhirlKind> whirl,
                          bool comb);

}  // namespace rubsweep::response::motion
