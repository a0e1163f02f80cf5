#include "rubsweep/maps/map/earlier_results.hpp"

#include <fmt/format.h>

#include "rubsweep/core/error.hpp"
#include "rubsweep/maps/batch/csv_table.hpp"
#include "rubsweep/maps/batch/opened_file.hpp"
#include "rubsweep/maps/batch/table_file.hpp"
#include "rubsweep/maps/config/run_config.hpp"
#include "rubsweep/maps/config/yaml/differing_keys.hpp"
#include "rubsweep/maps/config/yaml/text.hpp"
#include "rubsweep/maps/report/map_cells.hpp"
#include "rubsweep/maps/report/map_csv.hpp"
#include "rubsweep/maps/report/study_columns.hpp"

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

namespace fs = std::filesystem;

/// One line for each key that differs, or the reason why the keys are unknown.
std::string keys_that_differ(const fs::path& config_file, const std::string& digest,
                             const std::string& study_here) {
  std::string study_there;
  try {
    const config::RunConfig there = config::read_run_config(config_file, {});
    if (config::study_digest(there.study) != digest) {
      return fmt::format("\n  which keys differ is not known: {} is not the one of the map",
                         config_file.string());
    }
    study_there = config::print_study(there.study);
  } catch (const std::runtime_error&) {  // ConfigError and IoError
    return fmt::format("\n  which keys differ is not known: {} cannot be read", config_file.string());
  }
  std::string text;
  for (const std::string& line : config::yaml::differing_keys(study_there, study_here)) text += "\n  " + line;
  return text;
}

/// Digest in the comments above the header of a table; empty where there is none.
std::string digest_in(const fs::path& table) {
  batch::InputLines lines(table);
  constexpr std::string_view mark = "# digest ";
  for (std::string_view line = lines.next(); line.starts_with('#'); line = lines.next()) {
    if (line.starts_with(mark))
      return std::string(line.substr(mark.size(), line.find_first_of("\r\n") - mark.size()));
  }
  return "";
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

void require_whole_table(std::string_view program, const fs::path& path) {
  try {
    if (batch::check_table(path) == batch::TableSum::right) return;
  } catch (const batch::DamagedTable& damage) {
    throw batch::DamagedTable(fmt::format(
        "{}\nIt is left as it is; allowed: a copy of it that is whole, or computing it anew, a map "
        "with --fresh",
        damage.what()));
  }
  config::yaml::say(
      fmt::format("{}: {}: has no checksum, so whether it is as it was written cannot be told\n", program,
                  path.string()));
}

FinishedMap read_finished_map(std::string_view program, const fs::path& map, const sweep::Study& study,
                              double warn_over_clearances) {
  FinishedMap found;
  found.summary = report::MapSummary(warn_over_clearances);
  found.digest = digest_in(map);
  if (found.digest.empty()) return found;
  require_whole_table(program, map);
  if (found.digest != config::study_digest(study)) return found;
  batch::CsvReader rows(map);
  report::CellsOfRows cells(rows, study.grid);
  const std::string columns = batch::csv_row(rows.header());
  found.known_columns = report::without_unit_columns(columns) == report::map_header(study);
  while (rows.next()) {
    cells.take(rows);
    if (found.known_columns) found.summary.add(batch::csv_row(rows.cells()));
  }
  found.cells = cells.taken();
  if (const auto missing = cells.first_missing(); missing && !study.grid.refinement)
    found.missing = report::name_of_cell(study.grid, *missing);
  return found;
}

void warn(std::string_view program, const report::MapSummary& summary) {
  const std::string warning = summary.warning();
  if (!warning.empty()) config::yaml::say(fmt::format("{}: {}", program, warning));
}

std::string map_is_there(std::string_view program) {
  return fmt::format("{}: the map is there, nothing is left to do; --fresh computes it anew\n", program);
}

void refuse_map_of_another(const FinishedMap& there, const fs::path& map, const batch::JournalHeader& here) {
  constexpr std::string_view others = "another --output, or --fresh to replace it";
  if (there.digest.empty()) {
    throw ConfigError(
        fmt::format("{}: is no map of this program: it says no digest\nallowed: {}", map.string(), others));
  }
  if (there.digest != here.study_digest) {
    throw ConfigError(
        fmt::format("{}: is a finished map of another configuration (digest {}, this one has "
                    "{}):{}\nallowed: the same again, {}",
                    map.string(), there.digest, here.study_digest,
                    keys_that_differ(map.parent_path() / "config.yaml", there.digest, here.study), others));
  }
  if (there.cells != here.cells) {
    throw ConfigError(
        fmt::format("{}: holds {} cells of this configuration, which has {}: there is no row of {}\n"
                    "allowed: {}",
                    map.string(), there.cells, here.cells, there.missing, others));
  }
}

}  // namespace rubsweep::map
