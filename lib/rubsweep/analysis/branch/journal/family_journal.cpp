#include "rubsweep/analysis/branch/journal/family_journal.hpp"

#include <fmt/format.h>

#include <string_view>

#include "rubsweep/maps/batch/opened_file.hpp"
#include "rubsweep/maps/config/yaml/text.hpp"
#include "rubsweep/maps/map/earlier_results.hpp"
#include "rubsweep/maps/map/map_files.hpp"

namespace rubsweep::branch::journal {

namespace fs = std::filesystem;

FamilyJournal::FamilyJournal(const fs::path& directory, const sweep::Study& study, bool fresh)
    : path_(directory / map::family_journal_file), records_([this](std::size_t cell, std::string_view line) {
        const std::lock_guard lock(mutex_);
        journal_->append(cell, line);
      }) {
  batch::make_directory(directory);
  lock_.emplace(directory / map::family_lock_file, batch::LockMode::exclusive, "rubbranch");
  if (!lock_->guards()) config::yaml::say(batch::no_locks("rubbranch", directory));
  const batch::JournalHeader header = map::journal_header(study, family_digest);
  read(header, fresh);
  journal_.emplace(path_, header);
}

void FamilyJournal::read(const batch::JournalHeader& header, bool fresh) {
  if (fresh) fs::remove(path_);
  if (!fs::exists(path_)) return;
  map::refuse_journal_of_another(path_, header);
  std::size_t unreadable = 0;
  const std::size_t torn = batch::read_journal(path_, [&](const batch::JournalRecord& record) {
    ++(records_.read(record.cell, record.text) ? found_before_ : unreadable);
  });
  const std::size_t damaged = torn + unreadable;
  if (damaged > 0)
    config::yaml::say(
        fmt::format("{}: {} damaged records; what they held is computed again\n", path_.string(), damaged));
}

void FamilyJournal::remove() {
  const std::lock_guard lock(mutex_);
  journal_.reset();
  fs::remove(path_);
}

void FamilyJournal::refresh() {
  const std::lock_guard lock(mutex_);
  if (journal_) journal_->refresh();
}

void FamilyJournal::leave() {
  mutex_.lock();  // never unlocked: threads that wait for the lock end with the process
  if (journal_) journal_->sync();
  lock_.reset();
}

}  // namespace rubsweep::branch::journal
