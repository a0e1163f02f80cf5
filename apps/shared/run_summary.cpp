#include "shared/run_summary.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <filesystem>
#include <map>
#include <optional>
#include <system_error>
#include <vector>

#include "rubsweep/maps/batch/whole_file.hpp"
#include "rubsweep/maps/config/yaml/diagnostics.hpp"
#include "rubsweep/maps/config/yaml/document.hpp"
#include "rubsweep/maps/config/yaml/other_documents.hpp"
#include "rubsweep/maps/config/yaml/text.hpp"
#include "shared/json_string.hpp"
#include "shared/program.hpp"

namespace rubsweep::apps {
namespace {

using config::yaml::Node;

using Clock = std::chrono::steady_clock;

const Clock::time_point begun = Clock::now();
bool wanted = false, held_back = false;

std::map<std::string, std::size_t>& counts() {
  static std::map<std::string, std::size_t> of_this_run;
  return of_this_run;
}

bool is_warning(std::string_view line) {
  return line.find(": warning: ") != std::string_view::npos ||
         line.find(": question: ") != std::string_view::npos;
}

/// Time since the start in seconds, rounded to milliseconds.
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

std::string take_summary(std::string printed) {
  if (!printed.ends_with('\n')) return printed;
  printed.pop_back();
  const std::size_t begin = printed.rfind('\n') + 1;  // 0 if no line end is there
  config::yaml::Diagnostics problems("summary", {});
  const std::optional<Node> summary =
      config::yaml::parse_json(std::string_view(printed).substr(begin), "", problems, 0);
  if (!summary || summary->kind != Node::Kind::map) return printed + '\n';
  for (std::size_t i = 0; i < summary->keys.size(); ++i) {
    const std::string& key = summary->keys[i].text;
    const Node& value = summary->items[i];
    for (std::size_t j = 0; j < value.items.size(); ++j) {
      const std::string& text = value.items[j].text;
      if (key == "counts") count_in_summary(value.keys[j].text, std::stoul(text));
      if (key == "warnings" || key == "messages") config::yaml::remember_lines(text);
      if (key == "files") batch::note_written_file(text);
    }
  }
  printed.resize(begin);
  return printed;
}

void print_summary(std::string_view program, int exit_code) {
  std::string counted;
  for (const auto& [name, number] : counts())
    counted += fmt::format("{}{}:{}", counted.empty() ? "" : ",", json_string(name), number);
  std::vector<std::string> warnings, messages, files;
  for (const std::string& line : config::yaml::said_lines())
    (is_warning(line) ? warnings : messages).push_back(line);
  std::error_code none;
  for (const auto& path : batch::written_files())
    files.push_back(std::filesystem::absolute(path, none).string());
  print_text(fmt::format(R"({{"program":{},"version":{},"exit_code":{},"seconds":{},"counts":{{{}}},)"
                         R"("warnings":{},"messages":{},"files":{}}})"
                         "\n",
                         json_string(program), json_string(RUBSWEEP_VERSION), exit_code, elapsed_s(), counted,
                         json_list(warnings), json_list(messages), json_list(files)));
}

}  // namespace rubsweep::apps
