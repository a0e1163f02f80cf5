// libFuzzer target for the configuration reader: whatever the bytes are, the answer is a configuration that
// prints and reads back as itself, or a ConfigError made of whole printable lines. The input is the file;
// what follows the first NUL byte is given as --set.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

#include "rubsweep/config/print_config.hpp"
#include "rubsweep/config/read_run_config.hpp"
#include "rubsweep/config/study_digest.hpp"
#include "rubsweep/config/text.hpp"
#include "rubsweep/error.hpp"

namespace {

namespace config = rubsweep::config;

void require(bool holds) {
  if (!holds) std::abort();
}

void check_message(std::string_view message) {
  require(!message.empty());
  while (!message.empty()) {
    const std::string_view line = message.substr(0, message.find('\n'));
    require(line.starts_with("fuzz.yaml:") || line.starts_with("--set "));
    for (const char c : line) require(!config::is_control(c));
    message.remove_prefix(std::min(line.size() + 1, message.size()));
  }
}

void check_config(const config::RunConfig& read) {
  const std::string printed = config::print_config(read);
  const config::RunConfig again = config::read_run_config_text(printed, "printed.yaml", {});
  require(config::print_config(again) == printed);
  require(config::study_digest(again.study) == config::study_digest(read.study));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view input(reinterpret_cast<const char*>(data), size);
  const std::size_t end = std::min(input.find('\0'), size);
  std::vector<std::string> overrides;
  if (end < size) overrides.emplace_back(input.substr(end + 1));
  config::RunConfig read;
  try {
    read = config::read_run_config_text(input.substr(0, end), "fuzz.yaml", overrides);
  } catch (const rubsweep::ConfigError& error) {
    check_message(error.what());
    return 0;
  }
  check_config(read);
  return 0;
}
