#include "rubsweep/recording/sound_file.hpp"

#include <sndfile.h>

#include <memory>
#include <string>

#include "rubsweep/error.hpp"

namespace rubsweep::recording {
namespace {

struct Close {
  void operator()(SNDFILE* file) const { sf_close(file); }
};

constexpr sf_count_t frames_at_once = 4096;

}  // namespace

Channels read_sound_file(const std::filesystem::path& file) {
  const std::string name = file.string();
  SF_INFO info{};
  const std::unique_ptr<SNDFILE, Close> open(sf_open(name.c_str(), SFM_READ, &info));
  if (!open) throw ConfigError(name + ": is damaged, " + sf_strerror(nullptr) + ", allowed: a WAV file");
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
