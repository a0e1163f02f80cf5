#include "rubsweep/maps/map/map_directory.hpp"

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <set>
#include <utility>

#include "rubsweep/core/error.hpp"
#include "rubsweep/maps/batch/opened_file.hpp"
#include "rubsweep/maps/batch/whole_file.hpp"
#include "rubsweep/maps/config/run_config.hpp"
#include "rubsweep/maps/config/yaml/text.hpp"
#include "rubsweep/maps/map/refined_cells.hpp"
#include "rubsweep/maps/report/map_csv.hpp"
#include "rubsweep/maps/report/study_columns.hpp"

namespace rubsweep::map {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> files(const fs::path& directory, std::string_view ending) {
  std::vector<fs::path> found;
  for (const auto& entry : fs::directory_iterator(directory)) {
    const std::string name = entry.path().filename();
    if (name.starts_with("map.") && name.ends_with(ending)) found.push_back(entry.path());
  }
  std::ranges::sort(found);
  return found;
}

std::string comments_and_header(const sweep::Study& study) {
  return report::map_comments(study) + report::map_header(study) + report::unit_header(study.grid) + '\n';
}

/// Raises the limit of open files to the largest value that the system allows. A map may have one journal for
/// each part, more than the usual limit.
void allow_as_many_files_as_there_may_be() {
  rlimit files{};
  if (::getrlimit(RLIMIT_NOFILE, &files) != 0) return;
  files.rlim_cur = files.rlim_max;
  ::setrlimit(RLIMIT_NOFILE, &files);
}

}  // namespace

batch::Journal rank_journal(const config::RunConfig& config, int rank) {
  return {config.output_directory / fmt::format("map.rank-{}.journal", rank), journal_header(config.study)};
}

MapDirectory::MapDirectory(fs::path directory, const config::RunConfig& config, std::optional<Share> part,
                           bool fresh, const std::string& program)
    : directory_(std::move(directory)),
      name_(share_name(part)),
      part_(part),
      header_(journal_header(config.study)),
      source_{fmt::format("rubsweep {}", RUBSWEEP_VERSION),
              header_.study_digest,
              {},
              batch::caption_lines(config.captions)},
      head_(comments_and_header(config.study)),
      warn_over_clearances_(config.warn_over_clearances),
      refined_(config.study.grid.refinement.has_value()) {
  written_.written_speed = config.study.grid.written_speed;
  written_.written_unbalance = config.study.grid.written_unbalance;
  allow_as_many_files_as_there_may_be();
  batch::make_directory(directory_);
  // Only one program at a time may begin here, so that no file is removed while another one reads it.
  const batch::FileLock beginning(directory_ / "map.begin.lock", batch::LockMode::exclusive, program,
                                  batch::Patience::wait);
  lock(program);
  refuse_what_is_no_file();
  remove_leftovers();
  if (fresh) forget();
  refuse_journals_of_others();
  if (fs::exists(map())) {
    finished_map_ = read_finished_map(program, map(), config.study, warn_over_clearances_);
    if (refined_) finished_map_->cells = header_.cells;  // only the map knows how many it needs
    refuse_map_of_another(*finished_map_, map(), header_);
    // The process that wrote the map may have been killed before it removed its journals.
    if (!part_) remove_journals();
  }
  batch::write_whole_file(directory_ / "config.yaml", config::print_config(config));
  if (!finished_map_) read_journals();
}

std::size_t MapDirectory::share_in(std::size_t cell, std::size_t count) const {
  return map::share_of(cell, count, refined_);
}

std::size_t MapDirectory::share_of(std::size_t cell) const {
  return share_in(cell, part_.value_or(Share{}).count);
}

std::size_t MapDirectory::shards_begun() const {
  std::size_t most = 0;
  for (const fs::path& journal : journals())
    most = std::max(most, share_count_of(journal.filename().string()));
  return most;
}

bool MapDirectory::is_at_work_on(const std::vector<std::size_t>& cells) const {
  std::set<std::size_t> shares;
  for (const std::size_t cell : cells) shares.insert(share_of(cell));
  return std::ranges::any_of(shares, [&](std::size_t index) {
    const std::string name = share_name(Share{index, part_.value_or(Share{}).count});
    return index != part_.value_or(Share{}).index &&
           batch::lock_holder(directory_ / (name + ".lock")).has_value();
  });
}

void MapDirectory::leave() {
  own_lock_.reset();
  directory_lock_.reset();
}

fs::path MapDirectory::path(std::string_view ending) const {
  return directory_ / (name_ + std::string(ending));
}

std::vector<fs::path> MapDirectory::journals() const { return files(directory_, ".journal"); }

/// Each part takes a lock of its own and shares the directory; a whole map locks the directory alone.
void MapDirectory::lock(const std::string& program) {
  lock_share(program);
  if (!directory_lock_->guards()) config::yaml::say(batch::no_locks(program, directory_));
}

void MapDirectory::lock_share(const std::string& program) {
  const fs::path whole = directory_ / "map.lock";
  if (part_) {
    own_lock_.emplace(path(".lock"), batch::LockMode::exclusive, program);
    directory_lock_.emplace(whole, batch::LockMode::shared, program);
    return;
  }
  try {
    directory_lock_.emplace(whole, batch::LockMode::exclusive, program);
  } catch (const LockedError&) {
    for (const fs::path& other : files(directory_, ".lock")) {
      if (other == whole || other.filename() == "map.begin.lock") continue;
      const auto holder = batch::lock_holder(other);
      if (holder) throw LockedError(fmt::format("{} is held by {}", other.string(), *holder));
    }
    throw;
  }
}

/// Refuses existing files with these names that are not regular: writing them would fail, and reading a pipe
/// would wait forever.
void MapDirectory::refuse_what_is_no_file() const {
  std::vector<fs::path> ours = journals();
  ours.push_back(partial());
  // Only this program uses these names. A link with such a name would lead to a file of somebody else.
  for (const fs::path& file : ours) batch::refuse_link("write", file);
  ours.insert(ours.end(), {directory_ / "config.yaml", map()});
  for (const fs::path& file : ours) {
    if (fs::exists(file) && !fs::is_regular_file(file))
      throw IoError(fmt::format("{}: is not a regular file", file.string()));
  }
}

/// Removes temporary files of processes that were killed.
void MapDirectory::remove_leftovers() const {
  batch::remove_leftovers(directory_, [](std::string_view name) {
    return name == "config.yaml" || name == family_journal_file || name.starts_with("map.") ||
           std::ranges::count(derived_files(), name) > 0;
  });
}

/// Removes earlier results, the map last: after an interruption, all remaining files still belong to the map.
/// Each step is on the disk before the next one begins.
void MapDirectory::forget() const {
  if (const auto holder = batch::lock_holder(directory_ / family_lock_file)) {
    throw LockedError(fmt::format("{} is held by {}", (directory_ / family_lock_file).string(), *holder));
  }
  fs::remove(directory_ / family_journal_file);
  batch::remove_result_files(derived_files(), directory_);
  std::vector<fs::path> forgotten = journals();
  if (part_)
    std::erase_if(forgotten, [&](const fs::path& journal) { return belongs_to_other_part(journal); });
  for (const fs::path& journal : forgotten) fs::remove(journal);
  batch::sync_directory(directory_);
  fs::remove(map());
  batch::sync_directory(directory_);
}

/// Whether the journal of another part belongs to this study and must therefore stay. Throws LockedError
/// where it belongs to another study whose process is at work.
bool MapDirectory::belongs_to_other_part(const fs::path& journal) const {
  if (journal == path(".journal")) return false;
  try {
    if (batch::same_results(batch::read_journal_header(journal), header_)) return true;
  } catch (const batch::DamagedJournal&) {
  }
  const fs::path other_lock = fs::path(journal).replace_extension(".lock");
  const auto holder = other_lock == directory_ / "map.lock" ? std::nullopt : batch::lock_holder(other_lock);
  if (holder) throw LockedError(fmt::format("{} is held by {}", other_lock.string(), *holder));
  return false;
}

void MapDirectory::refuse_journals_of_others() const {
  for (const fs::path& journal : journals()) refuse_journal_of_another(journal, header_);
}

void MapDirectory::read_journals() {
  batch::FinishedCells finished(header_.cells);
  for (const fs::path& journal : journals()) {
    // A part needs no cells of the other parts of the same division, unless the map is refined.
    const std::string name = journal.filename();
    if (part_ && !refined_ && name.starts_with("map.shard-") && name != name_ + ".journal" &&
        name.ends_with(fmt::format("-of-{}.journal", part_->count))) {
      continue;
    }
    if (const std::size_t damaged = finished.add(journal)) {
      config::yaml::say(
          fmt::format("{}: {} damaged records; their cells are computed again\n", journal.string(), damaged));
    }
  }
  missing_ = finished.missing();
  std::erase_if(missing_, [this](std::size_t cell) { return !has_in_share(cell); });
  cells_ = 0;
  for (std::size_t cell = 0; cell < header_.cells; ++cell) cells_ += has_in_share(cell) ? 1U : 0U;
  write_partial(finished);
}

void MapDirectory::write_partial(const batch::FinishedCells& finished) const {
  batch::WholeFile file(partial());
  file.write(batch::table_head(source_) + head_);
  for (std::size_t cell = 0; cell < header_.cells; ++cell) {
    if (has_in_share(cell) && finished.contains(cell)) file.write(in_map(finished.text(cell)) + '\n');
  }
  file.commit();
}

std::string MapDirectory::in_map(const std::string& line) const {
  return line + report::unit_cells(line, written_);
}

/// Removes the journals and the partial map when map.csv is complete.
void MapDirectory::remove_journals() const {
  for (const fs::path& other : files(directory_, ".partial.csv")) fs::remove(other);
  for (const fs::path& journal : journals()) fs::remove(journal);
}

void MapDirectory::for_each_finished(
    const std::function<void(std::size_t cell, const std::string& line)>& visit) const {
  batch::FinishedCells finished(header_.cells);
  for (const fs::path& journal : journals()) finished.add(journal);
  for (std::size_t cell = 0; cell < header_.cells; ++cell) {
    if (finished.contains(cell)) visit(cell, finished.text(cell));
  }
}

report::MapSummary MapDirectory::write_map() const {
  batch::FinishedCells finished(header_.cells);
  for (const fs::path& journal : journals()) finished.add(journal);
  report::MapSummary summary(warn_over_clearances_);
  batch::TableFile file(map(), source_);
  file.write(head_);
  for (std::size_t cell = 0; cell < header_.cells; ++cell) {
    if (refined_ && !finished.contains(cell)) continue;
    if (!finished.contains(cell)) {
      throw IoError(fmt::format("{}: {} of {} cells are not finished", directory_.string(),
                                header_.cells - finished.count(), header_.cells));
    }
    const std::string line = finished.text(cell);
    summary.add(line);
    file.write(in_map(line) + '\n');
  }
  file.finish();
  batch::remove_result_files(derived_files(), directory_);  // derived files of an earlier map
  file.commit();
  remove_journals();
  return summary;
}

void MapDirectory::paint(const sweep::Grid& grid) const {
  const bool old_columns = finished_map_ && !finished_map_->known_columns;
  if (!refined_ || old_columns || fs::exists(directory_ / painted_map_file)) return;
  batch::TableSource source = source_;
  source.files = {"map.csv", std::string(painted_map_file)};
  write_painted_map(map(), grid, source);
}

}  // namespace rubsweep::map
