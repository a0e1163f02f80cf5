#include "shared/verified_directory.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <sstream>
#include <string_view>

#include "rubsweep/core/error.hpp"
#include "rubsweep/core/response/motion/motion_class.hpp"
#include "rubsweep/maps/batch/csv_table.hpp"
#include "rubsweep/maps/batch/file_lock.hpp"
#include "rubsweep/maps/batch/table_file.hpp"
#include "rubsweep/maps/batch/whole_file.hpp"
#include "rubsweep/maps/map/map_files.hpp"
#include "rubsweep/maps/map/refined_cells.hpp"
#include "rubsweep/maps/report/map_cells.hpp"
#include "shared/written_file.hpp"

namespace rubsweep::apps {

using namespace map;

namespace {

namespace fs = std::filesystem;

constexpr std::string_view config_file = "config.yaml", labels_file = "labels.csv";

/// Head of a table.
struct TableHead {
  std::string program, digest;
  /// files that were written together with the table, or from which it was computed
  std::vector<std::string> files;

  bool is_of(std::string_view name) const { return program.starts_with(std::string(name) + ' '); }

  /// Whether the digest of the table is that of the study in config.yaml. (A recording or a data set has
  /// another digest.)
  bool tells_the_study() const {
    return !is_of("rubscope") && !is_of("rubdiagnose") && !is_of("rubdata") && !is_of("rubsweep-compare");
  }
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
    look_at_summed();
    read_configuration();
    compare_digests();
    check_files();
    check_map();
    check_recordings();
    std::ranges::move(pages_, std::back_inserter(verdict_.files));
    if (verdict_.files.empty() && verdict_.faults.empty()) fault("holds no results");
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
    if (batch::is_temporary(name)) {
      remark(fmt::format("{}: was left by a call that was killed, the next one removes it", name));
    } else if (name == family_journal_file && !has(family_files.front())) {
      fault(fmt::format("{}: rubbranch --map has not finished", name));
    } else if (name.starts_with("map.") && name.ends_with(".journal") && !has("map.csv")) {
      fault(fmt::format("{}: the map is not finished", name));
    } else if (name == "recordings.journal") {  // kept by its program, so that a lost recording is made again
      if (!has(labels_file)) fault(fmt::format("{}: the set of recordings is not finished", name));
    } else if (name.ends_with(".journal")) {
      remark(fmt::format("{}: its results are there, the next call removes it", name));
    } else if (name.ends_with(".partial.csv")) {
      if (!has("map.csv") && !has("chart.csv")) fault(fmt::format("{}: is not finished", name));
    } else if (name.ends_with(".csv")) {
      look_at_table(name);
    } else if (name.ends_with(".html")) {
      look_at_page(name);
    } else if (name.ends_with(".cases")) {
      look_at_cases(name);
    }
  }

  void look_at_table(const std::string& name) {
    const Origin origin = origin_of(directory_ / name);
    if (!origin.ours) {
      if (name == "map.csv" && has(config_file)) fault(fmt::format("{}: {}", name, origin.why_not));
      remark(fmt::format("{}: {}, it is not looked at", name, origin.why_not));
      return;
    }
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
      for (const std::string& comment : table.comments()) {
        std::istringstream words(comment);
        std::string mark, file, digits;
        if (words >> mark >> file >> digits && mark == "sum") sums_[file].insert(digits);
      }
      heads_[name] = std::move(head);
      verdict_.files.push_back(name);
    } catch (const IoError& error) {
      fault(error.what());
    }
  }

  /// Checks a page. A page without a checksum counts as written by this program only if it is the report of a
  /// map.
  void look_at_page(const std::string& name) {
    const bool of_map = name == report_page_file && has("map.csv");
    const CheckedPage checked = check_page_file(directory_ / name, of_map);
    if (!checked.summed && !of_map) return;
    if (name == report_page_file) page_ = checked.text;
    if (!checked.problem.empty()) return fault(fmt::format("{}: {}", name, checked.problem));
    if (!checked.summed) remark(fmt::format("{}: has no checksum, it is of an earlier version", name));
    pages_.push_back(name);
  }

  void look_at_cases(const std::string& name) {
    const auto whole = are_cases_whole(directory_ / name);
    if (!whole) return;
    if (!*whole) return fault(fmt::format("{}: is not as it was written", name));
    verdict_.files.push_back(name);
  }

  /// Checks files whose checksums stand in a table. A configuration may be annotated as long as its digest is
  /// the same.
  void look_at_summed() {
    for (const auto& [name, sums] : sums_) {
      if (!has(name)) continue;
      const std::string problem = problem_of(directory_ / name, sums);
      if (problem.empty()) {
        as_written_.insert(name);
        verdict_.files.push_back(name);
      } else if (name != config_file) {
        fault(fmt::format("{}: {}", name, problem));
      }
    }
  }

  void read_configuration() {
    const bool told =
        std::ranges::any_of(heads_, [](const auto& head) { return head.second.tells_the_study(); });
    if (!has(config_file) || !told) return;
    try {
      configuration_ = read_(directory_ / config_file);
    } catch (const std::runtime_error& error) {
      return fault(error.what());
    }
    if (!as_written_.contains(config_file)) verdict_.files.emplace_back(config_file);
  }

  /// Checks that all tables in the directory belong to the map there, or else to the configuration.
  void compare_digests() {
    const auto map = heads_.find("map.csv");
    auto first = map;
    for (auto head = heads_.begin(); first == heads_.end() && head != heads_.end(); ++head)
      if (head->second.tells_the_study()) first = head;
    std::map<std::string, std::string> of_program;  // digest by program, for tables without a study
    for (const auto& [name, head] : heads_) {
      const bool study = head.tells_the_study();
      const std::string& other =
          study ? first->second.digest : of_program.try_emplace(head.program, head.digest).first->second;
      if (head.digest == other) continue;
      fault(fmt::format("{}: belongs to another study than {} (digest {}, not {})", name,
                        study ? first->first : "the other tables of its program", head.digest, other));
    }
    if (first == heads_.end()) return;
    digest_ = first->second.digest;
    if (!page_.empty() && page_.find(digest_) == std::string::npos)
      fault(fmt::format("{}: belongs to another map", report_page_file));
    compare_configuration(first->first, first->second);
  }

  /// Compares config.yaml with the tables. After a fit the written configuration differs from the one that
  /// was read.
  void compare_configuration(const std::string& table, const TableHead& head) {
    if (configuration_.digest.empty() || as_written_.contains(config_file)) return;
    if (configuration_.digest == digest_ && !head.is_of("rubfit")) return;
    const bool summed = sums_.contains(config_file);
    if (summed && head.is_of("rubfit"))
      return fault(fmt::format("config.yaml: is not as it was written with {}", table));
    const bool of_this_version = head.program.ends_with(std::string(" ") + RUBSWEEP_VERSION);
    // A later version may have keys that do not occur in the digest of an earlier version.
    if (!summed && (!of_this_version || head.is_of("rubfit"))) {
      remark(
          fmt::format("config.yaml: has digest {} by this version, {} is of {}: whether they belong together "
                      "cannot be told",
                      configuration_.digest, table, head.program));
      return;
    }
    fault(fmt::format("config.yaml: is not the one of {} (digest {}, not {})", table, configuration_.digest,
                      digest_));
  }

  void check_files() {
    std::map<std::string, std::string> listed;  // listed files, each with the table that names it
    for (const auto& [name, head] : heads_)
      for (const std::string& file : head.files) listed.emplace(file, name);
    if (heads_.contains("map.csv")) listed.emplace(config_file, "map.csv");
    for (const auto& [file, table] : listed) {
      if (!has(file) && file == config_file && table == "map.csv") {
        fault("config.yaml: is missing, that of map.csv");
      } else if (!has(file)) {
        const bool source = file == "map.csv";
        fault(
            fmt::format("{}: is missing, {} {}", file, source ? "the map of" : "it was written with", table));
      } else if (file.ends_with(".csv") && !heads_.contains(file) && !origin_of(directory_ / file).ours) {
        fault(fmt::format("{}: is not as it was written with {}: {}", file, table,
                          origin_of(directory_ / file).why_not));
      }
    }
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

  void check_recordings() {
    const auto labels = heads_.find(labels_file);
    if (labels == heads_.end() || !labels->second.is_of("rubdata")) return;
    const CheckedRecordings checked = check_set(directory_ / labels_file);
    for (const std::string& problem : checked.faults) fault(problem);
    if (!checked.summed)
      remark(fmt::format("{}: has no checksums of recordings, it is of an earlier version", labels_file));
    verdict_.files.push_back(fmt::format("{} recordings", checked.whole));
  }

  fs::path directory_;
  const ReadConfiguration& read_;
  std::vector<std::string> names_;  ///< names in the directory, ascending
  std::map<std::string, TableHead, std::less<>> heads_;
  std::map<std::string, std::set<std::string>, std::less<>> sums_;  ///< checksums of files, given by tables
  std::set<std::string, std::less<>> as_written_;                   ///< files whose digest agrees
  std::vector<std::string> pages_;                                  ///< pages that are undamaged
  std::string page_;  ///< text of report.html, if this program wrote it
  VerifiedConfiguration configuration_;
  std::string digest_;  ///< digest of the study that the files belong to
  DirectoryVerdict verdict_;
};

}  // namespace

DirectoryVerdict verify_directory(const fs::path& directory, const ReadConfiguration& read) {
  if (!fs::is_directory(directory)) throw IoError(fmt::format("{}: is no directory", directory.string()));
  return Verification(directory, read).verdict();
}

}  // namespace rubsweep::apps
