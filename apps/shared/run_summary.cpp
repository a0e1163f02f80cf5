#include "shared/run_summary.hpp"

#include <boost/json/array.hpp>
#include <boost/json/object.hpp>
#include <boost/json/serialize.hpp>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <map>

#include "rubsweep/batch/written_files.hpp"
#include "rubsweep/config/yaml/said_lines.hpp"
#include "shared/program.hpp"

namespace rubsweep::apps {
namespace {

namespace json = boost::json;

using Clock = std::chrono::steady_clock;

const Clock::time_point begun = Clock::now();
bool wanted = false, held_back = false;

std::map<std::string, std::size_t>& counts() {
  static std::map<std::string, std::size_t> of_this_run;
  return of_this_run;
}

bool is_warning(std::string_view line) {
  return line.find(": warning: ") != std::string_view::npos || line.find(": question: ") != std::string_view::npos;
}

/// To the millisecond: more digits would only be noise.
double elapsed_s() {
  return std::round(std::chrono::duration<double>(Clock::now() - begun).count() * 1e3) / 1e3;
}

}  // namespace

void want_summary() { wanted = true; }

bool summary_is_wanted() { return wanted && !held_back; }

void hold_summary(bool held) { held_back = held; }

void count_in_summary(const std::string& name, std::size_t number) {
  if (wanted) counts()[name] = number;
}

void print_summary(std::string_view program, int exit_code) {
  json::object counted;
  for (const auto& [name, number] : counts()) counted[name] = number;
  json::array warnings, messages, files;
  for (const std::string& line : config::yaml::said_lines()) (is_warning(line) ? warnings : messages).emplace_back(line);
  std::error_code none;
  for (const auto& path : batch::written_files()) files.emplace_back(std::filesystem::absolute(path, none).string());
  const json::object summary{{"program", program},         {"version", RUBSWEEP_VERSION}, {"exit_code", exit_code},
                             {"seconds", elapsed_s()},     {"counts", counted},           {"warnings", warnings},
                             {"messages", messages},       {"files", files}};
  print_text(json::serialize(summary) + "\n");
}

}  // namespace rubsweep::apps
