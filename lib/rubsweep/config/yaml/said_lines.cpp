#include "rubsweep/config/yaml/said_lines.hpp"

#include <algorithm>
#include <mutex>

namespace rubsweep::config::yaml {
namespace {

constexpr std::size_t most_lines = 1000;

std::mutex mutex;  // guards the lines

std::vector<std::string>& lines() {
  static std::vector<std::string> of_this_process;
  return of_this_process;
}

}  // namespace

void remember_lines(std::string_view shown) {
  const std::lock_guard lock(mutex);
  while (!shown.empty() && lines().size() < most_lines) {
    const std::size_t end = std::min(shown.find('\n'), shown.size());
    if (end > 0) lines().emplace_back(shown.substr(0, end));
    shown.remove_prefix(std::min(end + 1, shown.size()));
  }
}

std::vector<std::string> said_lines() {
  const std::lock_guard lock(mutex);
  return lines();
}

}  // namespace rubsweep::config::yaml
