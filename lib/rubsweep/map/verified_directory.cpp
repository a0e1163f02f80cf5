#include "rubsweep/map/verified_directory.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>
#include <string_view>

#include "rubsweep/batch/csv_table.hpp"
#include "rubsweep/batch/file_lock.hpp"
#include "rubsweep/batch/input_file.hpp"
#include "rubsweep/batch/table_file.hpp"
#include "rubsweep/error.hpp"
#include "rubsweep/map/derived_files.hpp"
#include "rubsweep/map/refined_cells.hpp"
#include "rubsweep/report/cells_of_rows.hpp"
#include "rubsweep/report/map_cells.hpp"
#include "rubsweep/response/motion/motion_class.hpp"

namespace rubsweep::map {
namespace {

namespace fs = std::filesystem;

/// Head of a table.
struct TableHead {
  std::string program, digest;
  std::vector<std::string> files;  ///< that were written with it
};

class Verification {
 public:
  Verification(fs::path directory, const ReadConfiguration& read)
      : directory_(std::move(directory)), read_(read) {
    for (const auto& entry : fs::directory_iterator(directory_)) names_.push_back(entry.path().filename());
    std::ranges::sort(names_);
  }

  DirectoryVerdict verdict() {
    refuse_work();
    for (const std::string& name : names_) look_at(name);
    if (names_.empty() || (heads_.empty() && verdict_.faults.empty())) fault("holds no results");
    if (has("config.yaml")) read_configuration();
    compare_digests();
    check_files();
    check_map();
    check_report();
    return std::move(verdict_);
  }

 private:
  bool has(std::string_view name) const { return std::ranges::binary_search(names_, name); }

  void fault(const std::string& text) { verdict_.faults.push_back(text); }
  void remark(const std::string& text) { verdict_.remarks.push_back(text); }

  void refuse_work() const {
    for (const std::string& name : names_) {
      if (!name.ends_with(".lock")) continue;
      if (const auto holder = batch::lock_holder(directory_ / name))
        throw LockedError(fmt::format("{} is held by {}", (directory_ / name).string(), *holder));
    }
  }

  void look_at(const std::string& name) {
    if (name.find(".tmp-") != std::string::npos) {
      remark(fmt::format("{}: was left by a call that was killed, the next one removes it", name));
    } else if (name == family_journal_file && !has(family_files.front())) {
      fault(fmt::format("{}: rubbranch --map has not finished", name));
    } else if (name.starts_with("map.") && name.ends_with(".journal") && !has("map.csv")) {
      fault(fmt::format("{}: the map is not finished", name));
    } else if (name.ends_with(".journal")) {
      remark(fmt::format("{}: its results are there, the next call removes it", name));
    } else if (name.ends_with(".partial.csv")) {
      if (!has("map.csv") && !has("chart.csv")) fault(fmt::format("{}: is not finished", name));
    } else if (name.ends_with(".csv")) {
      look_at_table(name);
    }
  }

  void look_at_table(const std::string& name) {
    try {
      const bool summed = batch::check_table(directory_ / name) == batch::TableSum::right;
      const batch::CsvReader table(directory_ / name);
      TableHead head{table.comments().empty() ? "" : table.comments().front(),
                     report::comment_after(table, "digest "),
                     {}};
      if (head.digest.empty()) {
        remark(fmt::format("{}: says no digest, so what it belongs to cannot be told", name));
        return;
      }
      if (!summed) remark(fmt::format("{}: has no checksum, it is of an earlier version", name));
      std::istringstream files(report::comment_after(table, "files "));
      head.files.assign(std::istream_iterator<std::string>(files), {});
      heads_[name] = std::move(head);
      verdict_.files.push_back(name);
    } catch (const IoError& error) {
      fault(error.what());
    }
  }

  void read_configuration() {
    const fs::path file = directory_ / "config.yaml";
    try {
      configuration_ = read_(file);
    } catch (const std::runtime_error& error) {
      fault(error.what());
      return;
    }
    verdict_.files.emplace_back("config.yaml");
  }

  /// All that lies in one directory belongs to the map there, or to the configuration.
  void compare_digests() {
    const auto map = heads_.find("map.csv");
    const auto first = map != heads_.end() ? map : heads_.begin();
    if (first == heads_.end()) return;
    digest_ = first->second.digest;
    for (const auto& [name, head] : heads_) {
      if (head.digest == digest_) continue;
      fault(fmt::format("{}: belongs to another study than {} (digest {}, not {})", name, first->first,
                        head.digest, digest_));
    }
    if (configuration_.digest.empty() || configuration_.digest == digest_) return;
    const bool of_this_version = first->second.program.ends_with(std::string(" ") + RUBSWEEP_VERSION);
    // A later version may have keys that the digest of an earlier one did not know.
    if (!of_this_version) {
      remark(
          fmt::format("config.yaml: has digest {} by this version, {} is of {}: whether they belong together "
                      "cannot be told",
                      configuration_.digest, first->first, first->second.program));
      return;
    }
    fault(fmt::format("config.yaml: is not the one of {} (digest {}, not {})", first->first,
                      configuration_.digest, digest_));
  }

  void check_files() {
    std::map<std::string, std::string> missing;  // with a table that names it
    for (const auto& [name, head] : heads_) {
      for (const std::string& file : head.files)
        if (!has(file)) missing.emplace(file, name);
    }
    for (const auto& [file, table] : missing)
      fault(fmt::format("{}: is missing, it was written with {}", file, table));
    if (heads_.contains("map.csv") && !has("config.yaml")) fault("config.yaml: is missing, that of map.csv");
  }

  void check_map() {
    if (!heads_.contains("map.csv") || !configuration_.study || configuration_.digest != digest_) return;
    const sweep::Grid& grid = configuration_.study->grid;
    try {
      batch::CsvReader rows(directory_ / "map.csv");
      report::CellsOfRows cells(rows, grid);
      RefinedCells known(grid);
      const std::size_t class_column = rows.column("class");
      while (rows.next()) {
        const std::string& word = rows.cells()[class_column];
        if (!response::motion::motion_class_of(word)) {
          throw IoError(fmt::format("{}:{}: '{}' is no class of a motion", rows.path().string(),
                                    rows.place().line, word));
        }
        known.add(cells.take(rows), batch::csv_row(rows.cells()));
      }
      if (!grid.refinement) cells.require_all();
      if (const auto wanted = known.wanted(); grid.refinement && !wanted.empty())
        fault(fmt::format("map.csv: lacks {} cells that its refined map wants", wanted.size()));
    } catch (const IoError& error) {
      fault(error.what());
    }
  }

  void check_report() {
    if (!has(report_page_file) || digest_.empty()) return;
    const std::string page = batch::read_input(directory_ / report_page_file);
    const std::size_t end = page.find_last_not_of('\n');
    if (end == std::string::npos || !page.substr(0, end + 1).ends_with("</html>")) {
      fault(fmt::format("{}: is cut off", report_page_file));
    } else if (page.find(digest_) == std::string::npos) {
      fault(fmt::format("{}: belongs to another map", report_page_file));
    } else {
      verdict_.files.emplace_back(report_page_file);
    }
  }

  fs::path directory_;
  const ReadConfiguration& read_;
  std::vector<std::string> names_;  ///< ascending
  std::map<std::string, TableHead> heads_;
  VerifiedConfiguration configuration_;
  std::string digest_;  ///< of all that belongs together
  DirectoryVerdict verdict_;
};

}  // namespace

DirectoryVerdict verify_directory(const fs::path& directory, const ReadConfiguration& read) {
  if (!fs::is_directory(directory)) throw IoError(fmt::format("{}: is no directory", directory.string()));
  return Verification(directory, read).verdict();
}

bool was_written_by(std::string_view program, const fs::path& directory) {
  if (!fs::is_directory(directory)) return false;
  const std::string begin = fmt::format("# {} ", program);
  return std::ranges::any_of(fs::directory_iterator(directory), [&](const fs::directory_entry& entry) {
    std::string line;
    return entry.path().extension() == ".csv" && std::getline(std::ifstream(entry.path()), line) &&
           line.starts_with(begin);
  });
}

}  // namespace rubsweep::map
