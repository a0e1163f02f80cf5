// Finds out which stop a recording shows: reads an instrument's files, prints probabilities and parameters of
// the machine.
//
//     diagnosis RECORDING INSTRUMENT.yaml MACHINE.yaml
//
// RECORDING is a table, a MATLAB or a WAV file, INSTRUMENT.yaml gives the directions of its probes, and
// MACHINE.yaml is the configuration of the rotor. Motions of the candidates are simulated first, for about a
// minute.

#include "rubsweep/diagnosis.hpp"

#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>

#include "rubsweep/error.hpp"
#include "rubsweep/recording.hpp"

namespace {

using namespace rubsweep;

std::string bytes_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw IoError(file.string() + ": cannot be read");
  return {std::istreambuf_iterator<char>(stream), {}};
}

int look(const std::filesystem::path& file, const std::filesystem::path& description,
         const std::filesystem::path& machine) {
  // The recording becomes samples in metres at equal shaft angles, whatever the instrument wrote.
  const recording::Instrument instrument =
      config::recording::read_instrument_text(bytes_of(description), description.string());
  const recording::Recording recording = recording::make_recording(
      recording::read_recording_file(file, bytes_of(file)), instrument, file.string());

  // The verdict tells how the motion repeats, from its spectral lines alone.
  const scope::Verdict verdict = scope::judge(recording);
  std::printf("%d turns at %.6g Hz: %s\n", recording.turns(), recording.mean_speed_hz(),
              std::string(to_string(verdict.motion)).c_str());

  // Simulated motions of such a machine are compared with the recording.
  const std::optional<diagnose::answer::Answer> answer =
      diagnosis::diagnose_recording(recording, instrument, {.name = file.string(), .machine = machine});
  if (!answer) return 4;
  for (const diagnose::answer::CandidateAnswer& candidate : answer->candidates)
    std::printf("%5.1f %%  %s\n", 100 * candidate.probability, candidate.name.c_str());
  std::printf("%5.1f %%  none of these\n", 100 * answer->none);
  return 0;
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 4) {
    std::fputs("usage: diagnosis RECORDING INSTRUMENT.yaml MACHINE.yaml\n", stderr);
    return 1;
  }
  try {
    return look(arguments[1], arguments[2], arguments[3]);
  } catch (const std::exception& error) {  // the message names file, line and column, and what is allowed
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
}
