#include "shared/premises.hpp"

#include <fmt/format.h>

#include "explain/explain_rotor.hpp"
#include "rubsweep/maps/sweep/study_warnings.hpp"
#include "shared/program.hpp"

namespace rubsweep::apps {

void warn_of_premises(std::string_view program, const sweep::Study& study,
                      const scene::PreparedMachine& prepared) {
  const std::string sparse = describe_sparse_tables(study.machine);
  for (std::size_t begin = 0; begin < sparse.size();) {
    const std::size_t end = sparse.find('\n', begin) + 1;
    say(fmt::format("{}: warning: {}", program, sparse.substr(begin, end - begin)));
    begin = end;
  }
  const std::string where = sweep::where_rotor_is_unstable(study, prepared);
  if (!where.empty()) say(fmt::format("{}: warning: {}", program, where));
}

void warn_of_premises_at(std::string_view program, const std::vector<double>& speeds_hz, sweep::Study study,
                         const scene::PreparedMachine& prepared) {
  study.grid.axes.clear();
  study.grid.speed_hz = speeds_hz;
  warn_of_premises(program, study, prepared);
}

}  // namespace rubsweep::apps
