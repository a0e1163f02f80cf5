#include "rubsweep/dataset/data_set.hpp"

#include <string_view>
#include <utility>

#include "rubsweep/batch/directory.hpp"
#include "rubsweep/batch/finished_cells.hpp"
#include "rubsweep/batch/parallel_run.hpp"
#include "rubsweep/batch/sha256.hpp"
#include "rubsweep/batch/table_file.hpp"
#include "rubsweep/batch/whole_file.hpp"
#include "rubsweep/dataset/datasheet.hpp"
#include "rubsweep/dataset/labels.hpp"
#include "rubsweep/dataset/recording_text.hpp"
#include "rubsweep/error.hpp"

namespace rubsweep::dataset {
namespace {

namespace fs = std::filesystem;

batch::JournalHeader header_of(const DataStudy& study, std::string program_digest) {
  batch::JournalHeader header;
  header.study = study_text(study);
  batch::Sha256 sum;
  sum.add(header.study);
  header.study_digest = sum.digits();
  header.program_digest = std::move(program_digest);
  header.cells = static_cast<std::size_t>(study.recordings);
  return header;
}

fs::path made(const fs::path& directory) {
  for (const char* part : {"training", "validation", "test"}) batch::make_directory(directory / part);
  return directory;
}

/// Refuses a directory with recordings of something else.
fs::path checked(const fs::path& journal, const batch::JournalHeader& header) {
  if (fs::exists(journal) && !batch::same_results(batch::read_journal_header(journal), header))
    throw ConfigError(
        journal.parent_path().string() +
        ": holds a data set of another study or build of the program, allowed: another directory");
  return journal;
}

/// The file that a line of labels names, its second cell.
std::string_view file_in(std::string_view label) {
  label.remove_prefix(label.find(',') + 1);
  return label.substr(0, label.find(','));
}

void write_recording(const DataStudy& study, const LabelledRecording& recording) {
  const fs::path file = study.directory / file_of(study, recording);
  if (study.format == Format::csv) {
    batch::write_whole_file(file, recording_csv(recording));
  } else {
    write_recording_matlab(recording, file);
  }
}

}  // namespace

DataSet::DataSet(const DataStudy& study, std::string program, std::string program_digest)
    : study_(study),
      program_(std::move(program)),
      header_(header_of(study, std::move(program_digest))),
      lock_(made(study.directory) / "recordings.lock", batch::LockMode::exclusive, program_),
      journal_(checked(journal_path(), header_), header_) {}

fs::path DataSet::journal_path() const { return study_.directory / "recordings.journal"; }

std::vector<std::size_t> DataSet::missing() const {
  batch::FinishedCells finished(header_.cells);
  finished.add(journal_path());
  std::vector<std::size_t> missing;
  for (std::size_t index = 0; index < header_.cells; ++index) {
    if (!finished.contains(index) || !fs::exists(study_.directory / file_in(finished.text(index))))
      missing.push_back(index);
  }
  return missing;
}

bool DataSet::make(const std::vector<std::size_t>& wanted, int threads,
                   const std::function<void()>& on_finished, const std::atomic<bool>& stop) {
  std::vector<std::string> labels(wanted.size());
  const std::size_t made = batch::parallel_run(
      wanted.size(), threads,
      [&](std::size_t i) {
        thread_local response::motion::Workspace workspace;
        const LabelledRecording recording = make_recording(study_, wanted[i], workspace);
        write_recording(study_, recording);
        labels[i] = label_line(study_, recording);
      },
      [&](std::size_t i) {
        journal_.append(wanted[i], std::exchange(labels[i], {}));
        on_finished();
      },
      stop);
  journal_.sync();
  return made == wanted.size();
}

void DataSet::finish() {
  batch::FinishedCells finished(header_.cells);
  finished.add(journal_path());
  batch::TableFile labels(study_.directory / "labels.csv", {program_, header_.study_digest, {}, {}});
  labels.write(label_header() + "\n");
  for (std::size_t index = 0; index < header_.cells; ++index) labels.write(finished.text(index) + "\n");
  labels.commit();
  batch::write_whole_file(study_.directory / "README.md", datasheet(study_, program_));
  batch::write_whole_file(study_.directory / "instrument.yaml", instrument_yaml(study_));
}

}  // namespace rubsweep::dataset
