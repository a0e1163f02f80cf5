#include "rubsweep/maps/map/journal_header.hpp"

#include <fmt/format.h>

#include <string>

#include "rubsweep/core/error.hpp"
#include "rubsweep/maps/config/print_config.hpp"
#include "rubsweep/maps/config/study_digest.hpp"
#include "rubsweep/maps/config/yaml/differing_keys.hpp"
#include "rubsweep/maps/config/yaml/terminal_text.hpp"

namespace rubsweep::map {
namespace {

std::string describe_difference(const batch::JournalHeader& there, const batch::JournalHeader& here) {
  if (there.study_digest == here.study_digest) {
    return fmt::format("of another build of the program (digest {}, this one has {})", there.program_digest,
                       here.program_digest);
  }
  std::string text = fmt::format("of another configuration (digest {}, this one has {}):", there.study_digest,
                                 here.study_digest);
  if (there.damaged_lines > 0) return text + "\n  which keys differ is not known: its header is damaged";
  for (const std::string& line : config::yaml::differing_keys(there.study, here.study)) text += "\n  " + line;
  return text;
}

}  // namespace

batch::JournalHeader journal_header(const sweep::Study& study, const char* program_digest) {
  return {config::study_digest(study), program_digest, sweep::cell_count(study.grid),
          config::print_study(study)};
}

void refuse_journal_of_another(const std::filesystem::path& path, const batch::JournalHeader& here) {
  batch::JournalHeader there;
  try {
    there = batch::read_journal_header(path);
  } catch (const batch::DamagedJournal& damage) {
    throw batch::DamagedJournal(fmt::format(
        "{}\nIt is left as it is, for what its records belong to cannot be told; allowed: another "
        "--output, moving it away, or --fresh to forget it",
        damage.what()));
  }
  if (!batch::same_results(there, here)) {
    throw ConfigError(
        fmt::format("{}: holds finished cells {}\nallowed: the same again, another --output, or --fresh "
                    "to forget them",
                    path.string(), describe_difference(there, here)));
  }
  if (there.damaged_lines > 0) {
    config::yaml::say(fmt::format("{}: {} damaged lines before its records, which are used all the same\n",
                                  path.string(), there.damaged_lines));
  }
}

}  // namespace rubsweep::map
