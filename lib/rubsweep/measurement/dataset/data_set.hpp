#pragma once

#include <atomic>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "rubsweep/maps/batch/file_lock.hpp"
#include "rubsweep/maps/batch/journal.hpp"
#include "rubsweep/measurement/dataset/data_study.hpp"
#include "rubsweep/measurement/dataset/labelled_recording.hpp"
#include "rubsweep/measurement/dataset/set_digest.hpp"

namespace rubsweep::dataset {

/// Ending of the file that becomes a MATLAB file once it is whole, before that of a temporary.
inline constexpr std::string_view scratch_ending = ".part";

/// t_s, x_m, y_m (of two probes), keyphasor_v: time with twelve digits, so that it goes on at
/// every reading, and the others with seven.
std::string recording_csv(const LabelledRecording& recording);

/// Writes the same columns as variables of a MATLAB file, version 5, compressed; its head is the same in
/// every run. Whole or not at all. Returns the bytes of the file. Throws IoError.
std::string write_recording_matlab(const LabelledRecording& recording, const std::filesystem::path& file);

/// A set of recordings on the disk. Each recording is a file of its own, and a line of recordings.journal
/// says that it is whole, so that an interrupted run goes on where it ended. One process at a time.
class DataSet {
 public:
  /// Makes the directories. `program`: name and version of who writes. Throws ConfigError where the directory
  /// holds a set of another study or build, LockedError where another process is at work there, IoError.
  DataSet(const DataStudy& study, std::string program, std::string program_digest = set_digest);

  /// False where the file system has no locks.
  bool guards() const { return lock_.guards(); }

  /// Recordings that are not there yet, or not as they were written, ascending.
  std::vector<std::size_t> missing() const;

  /// Makes the recordings of these numbers on so many threads (0: all processors); `on_finished` after each,
  /// one at a time. Once `stop` is true no new one begins; false where it kept some from being made. Throws
  /// IoError, and SolverError where one cannot be made.
  bool make(const std::vector<std::size_t>& wanted, int threads, const std::function<void()>& on_finished,
            const std::atomic<bool>& stop);

  /// Writes labels.csv, README.md and instrument.yaml once nothing is missing. Throws IoError.
  void finish();

 private:
  std::filesystem::path journal_path() const;

  DataStudy study_;
  std::string program_;
  batch::JournalHeader header_;
  batch::FileLock lock_;
  batch::Journal journal_;
};

}  // namespace rubsweep::dataset
