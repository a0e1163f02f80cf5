#include "motion_kinds_csv.hpp"

#include <fmt/format.h>

#include "rubsweep/core/response/motion/motion_class.hpp"

namespace rubsweep::apps {

std::string motion_kinds_csv() {
  std::string text = "name,label,colour,dark_colour,sign,hatched,settled_rub\n";
  for (const response::motion::MotionKind& kind : response::motion::motion_kinds)
    text += fmt::format("{},{},#{:06X},#{:06X},{},{:d},{:d}\n", kind.name, kind.label, kind.colour,
                        kind.dark_colour, kind.sign, kind.hatched, kind.settled_rub);
  return text;
}

}  // namespace rubsweep::apps
