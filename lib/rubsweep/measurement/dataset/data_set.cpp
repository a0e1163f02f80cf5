#include "rubsweep/measurement/dataset/data_set.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

#include "rubsweep/core/error.hpp"
#include "rubsweep/maps/batch/opened_file.hpp"
#include "rubsweep/maps/batch/parallel_run.hpp"
#include "rubsweep/maps/batch/sha256.hpp"
#include "rubsweep/maps/batch/table_file.hpp"
#include "rubsweep/maps/batch/whole_file.hpp"
#include "rubsweep/maps/matlab/version_5.hpp"
#include "rubsweep/measurement/dataset/labels.hpp"

namespace rubsweep::dataset {
namespace {

namespace fs = std::filesystem;

batch::JournalHeader header_of(const DataStudy& study, std::string program_digest) {
  batch::JournalHeader header;
  header.study = study_text(study);
  header.study_digest = batch::sha256_of(header.study);
  header.program_digest = std::move(program_digest);
  header.cells = static_cast<std::size_t>(study.recordings);
  return header;
}

constexpr std::array<std::string_view, 3> parts{"training", "validation", "test"};

fs::path made(const fs::path& directory) {
  for (const std::string_view part : parts) batch::make_directory(directory / part);
  return directory;
}

/// Whether a file is a recording: 000123.csv, 000123.mat, or 000123.mat.part, which is not whole yet.
bool is_recording(std::string_view name) {
  if (name.ends_with(scratch_ending)) name.remove_suffix(scratch_ending.size());
  const std::size_t digits = std::min(name.find_first_not_of("0123456789"), name.size());
  return digits > 0 && (name.substr(digits) == ".csv" || name.substr(digits) == ".mat");
}

/// Removes unfinished files of killed processes. Scratch files of an earlier version end with
/// `scratch_ending` alone.
void remove_left_over(const fs::path& directory) {
  for (const std::string_view part : parts) {
    batch::remove_leftovers(directory / part, is_recording);
    for (const auto& entry : fs::directory_iterator(directory / part)) {
      const std::string name = entry.path().filename();
      if (name.ends_with(scratch_ending) && is_recording(name)) fs::remove(entry.path());
    }
  }
}

/// Returns the path `journal`. Throws ConfigError where the directory holds recordings of another study or
/// build.
fs::path checked(const fs::path& journal, const batch::JournalHeader& header) {
  if (fs::exists(journal) && !batch::same_results(batch::read_journal_header(journal), header))
    throw ConfigError(
        journal.parent_path().string() +
        ": holds a data set of another study or build of the program, allowed: another directory");
  return journal;
}

/// Name of the recording's file: the second cell of a line of labels.csv.
std::string_view file_in(std::string_view label) {
  label.remove_prefix(label.find(',') + 1);
  return label.substr(0, label.find(','));
}

/// Checksum of the recording's file in its line of labels.csv. Later columns are numbers, so the search for
/// commas cannot hit one inside a cell.
std::string_view sum_in(std::string_view label) {
  const std::vector<LabelColumn> columns = label_columns();
  for (std::size_t k = columns.size() - 1; columns[k].name != "sha256"; --k)
    label = label.substr(0, label.rfind(','));
  return label.substr(label.rfind(',') + 1);
}

bool is_whole(const fs::path& file, std::string_view sum) {
  return batch::find_input(file).problem.empty() && batch::sha256_of(batch::read_input(file)) == sum;
}

/// Writes the file of a recording; returns the file's checksum.
std::string write_recording(const DataStudy& study, const LabelledRecording& recording) {
  const fs::path file = study.directory / file_of(study, recording);
  if (study.format == Format::matlab) return batch::sha256_of(write_recording_matlab(recording, file));
  const std::string text = recording_csv(recording);
  batch::write_whole_file(file, text);
  return batch::sha256_of(text);
}

}  // namespace

std::string recording_csv(const LabelledRecording& recording) {
  const bool plane = !recording.y_m.empty();
  std::string text = plane ? "t_s,x_m,y_m,keyphasor_v\n" : "t_s,x_m,keyphasor_v\n";
  for (std::size_t k = 0; k < recording.t_s.size(); ++k) {
    fmt::format_to(std::back_inserter(text), "{:.12g},{:.7g},", recording.t_s[k], recording.x_m[k]);
    if (plane) fmt::format_to(std::back_inserter(text), "{:.7g},", recording.y_m[k]);
    fmt::format_to(std::back_inserter(text), "{:.7g}\n", recording.keyphasor_v[k]);
  }
  return text;
}

std::string write_recording_matlab(const LabelledRecording& recording, const std::filesystem::path& file) {
  std::vector<matlab::NamedVector> columns{{"t_s", recording.t_s}, {"x_m", recording.x_m}};
  if (!recording.y_m.empty()) columns.push_back({"y_m", recording.y_m});
  columns.push_back({"keyphasor_v", recording.keyphasor_v});
  std::string bytes = matlab::version_5_file("MATLAB 5.0 MAT-file, written by rubdata", columns);
  batch::write_whole_file(file, bytes);
  return bytes;
}

DataSet::DataSet(const DataStudy& study, std::string program, std::string program_digest)
    : study_(study),
      program_(std::move(program)),
      header_(header_of(study, std::move(program_digest))),
      lock_(made(study.directory) / "recordings.lock", batch::LockMode::exclusive, program_),
      journal_(checked(journal_path(), header_), header_) {
  if (lock_.guards()) remove_left_over(study.directory);
}

fs::path DataSet::journal_path() const { return study_.directory / "recordings.journal"; }

std::vector<std::size_t> DataSet::missing() const {
  batch::FinishedCells finished(header_.cells);
  finished.add(journal_path());
  std::vector<std::size_t> missing;
  for (std::size_t index = 0; index < header_.cells; ++index) {
    const std::string label = finished.contains(index) ? finished.text(index) : std::string();
    if (label.empty() || !is_whole(study_.directory / file_in(label), sum_in(label)))
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
        LabelledRecording recording = make_recording(study_, wanted[i], workspace);
        recording.sha256 = write_recording(study_, recording);
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

void DataSet::finish(const std::map<std::string, std::string>& others) {
  batch::FinishedCells finished(header_.cells);
  finished.add(journal_path());
  batch::TableSource source{program_, header_.study_digest, {"labels.csv"}};
  for (const auto& [name, text] : others) {
    batch::write_whole_file(study_.directory / name, text);
    source.files.push_back(name);
    source.sums.emplace_back(name, batch::sha256_of(text));
  }
  batch::TableFile labels(study_.directory / "labels.csv", source);
  labels.write(label_header() + "\n");
  for (std::size_t index = 0; index < header_.cells; ++index) labels.write(finished.text(index) + "\n");
  labels.commit();
}

}  // namespace rubsweep::dataset
