#include "map_status.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <optional>
#include <set>
#include <string_view>
#include <thread>
#include <vector>

#include "rubsweep/core/error.hpp"
#include "rubsweep/maps/batch/file_lock.hpp"
#include "rubsweep/maps/batch/journal.hpp"
#include "rubsweep/maps/map/map_files.hpp"

namespace rubsweep::apps {
namespace {

namespace fs = std::filesystem;

constexpr std::chrono::seconds watched{2};

/// Finished cells in the journals of a directory.
struct Finished {
  std::map<std::string, std::size_t> by_journal;  ///< journal name without its ending -> number of its cells
  std::set<std::size_t> cells;                    ///< cells of all shards together
  std::size_t all = 0;                            ///< number of cells in the grid
};

std::vector<std::string> names_with(const fs::path& directory, std::string_view ending) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(directory)) {
    const std::string name = entry.path().filename();
    if (name.starts_with("map.") && name.ends_with(ending) && name != "map.begin.lock")
      names.push_back(name.substr(0, name.size() - ending.size()));
  }
  std::ranges::sort(names);
  return names;
}

Finished read_finished(const fs::path& directory) {
  Finished finished;
  for (const std::string& name : names_with(directory, ".journal")) {
    const fs::path journal = directory / (name + ".journal");
    finished.all = batch::read_journal_header(journal).cells;
    std::set<std::size_t> own;
    batch::read_journal(journal, [&](const batch::JournalRecord& record) { own.insert(record.cell); });
    finished.by_journal[name] = own.size();
    finished.cells.merge(own);
  }
  return finished;
}

std::string rate_text(std::size_t before, std::size_t now) {
  const double rate =
      static_cast<double>(now - std::min(before, now)) / std::chrono::duration<double>(watched).count();
  return fmt::format(", {:.3g} cells/s", rate);
}

/// Maps the name of a journal, without its ending, to the process that holds its lock.
using Holders = std::map<std::string, std::string>;

Holders holders_in(const fs::path& directory) {
  Holders holders;
  for (const std::string& name : names_with(directory, ".lock")) {
    if (const auto holder = batch::lock_holder(directory / (name + ".lock"))) holders[name] = *holder;
  }
  return holders;
}

std::size_t cells_in(const Finished& finished, const std::string& name) {
  const auto there = finished.by_journal.find(name);
  return there == finished.by_journal.end() ? 0 : there->second;
}

/// State of the process that writes a journal. Each MPI process writes its own, but only the first one holds
/// a lock.
std::string work_on(const std::string& name, const Holders& holders, const Finished& before,
                    const Finished& now) {
  const std::string rate = rate_text(cells_in(before, name), cells_in(now, name));
  if (const auto holder = holders.find(name); holder != holders.end())
    return "at work: " + holder->second + rate;
  const auto first = holders.find("map");
  if (name.starts_with("map.rank-") && first != holders.end() && first->second.starts_with("rubsweep-mpi,"))
    return "helps" + rate;
  return now.by_journal.contains(name) ? "nobody is at work" : "not begun";
}

}  // namespace

bool is_at_work(const fs::path& directory) { return !holders_in(directory).empty(); }

std::string map_status(const fs::path& directory) {
  if (!fs::is_directory(directory)) throw IoError(fmt::format("{}: is not a directory", directory.string()));
  const Holders holders = holders_in(directory);
  Finished finished = read_finished(directory);
  const Finished before = finished;
  if (!holders.empty()) {
    std::this_thread::sleep_for(watched);
    finished = read_finished(directory);
  }
  if (finished.by_journal.empty()) {
    if (fs::exists(directory / "map.csv"))
      return fmt::format("{}: the map is there, nothing is left to do\n", directory.string());
    return fmt::format("{}: no map was begun here{}\n", directory.string(),
                       holders.empty() ? "" : ", one is beginning");
  }
  std::string text = fmt::format(
      "{}: {} of {} cells are finished ({} %){}\n", directory.string(), finished.cells.size(), finished.all,
      100 * finished.cells.size() / finished.all,
      holders.empty() ? ", nobody is at work" : rate_text(before.cells.size(), finished.cells.size()));
  std::set<std::string> names;
  std::size_t shards = 0;
  for (const auto& [name, cells] : finished.by_journal) {
    names.insert(name);
    shards = std::max(shards, map::share_count_of(name));
  }
  for (const auto& [name, holder] : holders) shards = std::max(shards, map::share_count_of(name));
  for (std::size_t i = 1; i <= shards; ++i) names.insert(map::share_name(map::Share{i - 1, shards}));
  for (const std::string& name : names) {
    const bool begun = finished.by_journal.contains(name);
    text += fmt::format("  {:24} {:>8}  {}\n", name, begun ? std::to_string(cells_in(finished, name)) : "-",
                        work_on(name, holders, before, finished));
  }
  return text;
}

}  // namespace rubsweep::apps
