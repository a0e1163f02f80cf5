#pragma once

#include <filesystem>

#include "rubsweep/maps/batch/journal.hpp"
#include "rubsweep/maps/map/map_digest.hpp"
#include "rubsweep/maps/sweep/study.hpp"

namespace rubsweep::map {

/// Header for the results that this build of the program computes of a study.
batch::JournalHeader journal_header(const sweep::Study& study, const char* program_digest = map_digest);

/// Throws ConfigError, with every key that differs, where the records of the journal at `path` are not
/// results under `here`, DamagedJournal where that cannot be told, or IoError. Says on stderr what was
/// damaged and is not needed.
void refuse_journal_of_another(const std::filesystem::path& path, const batch::JournalHeader& here);

}  // namespace rubsweep::map
