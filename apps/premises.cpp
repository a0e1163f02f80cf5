#include "premises.hpp"

#include <fmt/format.h>

#include "program.hpp"
#include "rubsweep/sweep/unstable_rotor.hpp"

namespace rubsweep::apps {

void warn_of_premises(std::string_view program, const sweep::Study& study,
                      const scene::PreparedMachine& prepared) {
  const std::string where = sweep::where_rotor_is_unstable(study, prepared);
  if (!where.empty()) say(fmt::format("{}: warning: {}", program, where));
}

}  // namespace rubsweep::apps
