#include "rubsweep/measurement/recording/sound_file.hpp"

#include <sndfile.h>

#include <array>
#include <cstdint>
#include <fstream>
#include <memory>
#include <optional>
#include <string>

#include "rubsweep/core/error.hpp"

namespace rubsweep::recording {
namespace {

struct Close {
  void operator()(SNDFILE* file) const { sf_close(file); }
};

constexpr sf_count_t frames_at_once = 4096;

/// Size that the header says, by the first chunk of a RIFF file; empty where it leaves that open, as a stream
/// does.
std::optional<std::uintmax_t> said_bytes(const std::filesystem::path& file) {
  std::array<unsigned char, 8> head{};
  std::ifstream stream(file, std::ios::binary);
  if (!stream.read(reinterpret_cast<char*>(head.data()), head.size()) || head[0] != 'R' || head[3] != 'F')
    return std::nullopt;
  constexpr std::uintmax_t open = 0x7fffffff;
  const std::uintmax_t size =
      head[4] + 256u * head[5] + 65536u * head[6] + 16777216u * static_cast<std::uintmax_t>(head[7]);
  if (size == 0 || size >= open) return std::nullopt;
  return size + head.size();
}

}  // namespace

Channels read_sound_file(const std::filesystem::path& file) {
  const std::string name = file.string();
  SF_INFO info{};
  const std::unique_ptr<SNDFILE, Close> open(sf_open(name.c_str(), SFM_READ, &info));
  if (!open) throw ConfigError(name + ": is damaged, " + sf_strerror(nullptr) + ", allowed: a WAV file");
  const auto said = said_bytes(file);
  if (const std::uintmax_t there = std::filesystem::file_size(file); said && there < *said)
    throw ConfigError(name + ": breaks off after " + std::to_string(there) + " of " + std::to_string(*said) +
                      " bytes, allowed: a whole WAV file");
  Channels table;
  table.sampling_rate_hz = info.samplerate;
  const auto count = static_cast<std::size_t>(info.channels);
  for (std::size_t i = 0; i < count; ++i)
    table.channels.push_back({"channel " + std::to_string(i + 1), full_scale_unit, {}});
  std::vector<double> frames(static_cast<std::size_t>(frames_at_once) * count);
  sf_count_t read = 0, all = 0;
  while ((read = sf_readf_double(open.get(), frames.data(), frames_at_once)) > 0) {
    all += read;
    for (std::size_t k = 0; k < static_cast<std::size_t>(read) * count; ++k)
      table.channels[k % count].values.push_back(frames[k]);
  }
  if (all < info.frames)
    throw ConfigError(name + ": breaks off after " + std::to_string(all) + " of " +
                      std::to_string(info.frames) + " readings, allowed: a whole WAV file");
  if (all < 2) throw ConfigError(name + ": has " + std::to_string(all) + " readings, allowed: two or more");
  return table;
}

}  // namespace rubsweep::recording
