#include "shared/command_line.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/program_options.hpp>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "rubsweep/core/model/range.hpp"
#include "rubsweep/maps/config/yaml/text.hpp"
#include "shared/program.hpp"
#include "shared/run_summary.hpp"

namespace rubsweep::apps {
namespace {

/// Largest number of threads: more than one per processor does not help, and very many exhaust the system.
constexpr int most_threads = 1024;

bool is_given(const po::variables_map& given, const char* name) { return given.count(name) != 0; }

/// Hint for an unknown option, such as " (did you mean '--threads'?)"; empty where no name is similar.
std::string meant_instead_of(std::string_view given, const po::options_description& options) {
  given.remove_prefix(std::min(given.find_first_not_of('-'), given.size()));
  std::vector<std::string_view> names;
  for (const auto& option : options.options()) {
    if (option->long_name() != "config")
      names.push_back(option->long_name());  // without the file, which is given without an option name
  }
  const auto meant = config::yaml::nearest(given, names);
  return meant ? fmt::format(" (did you mean '--{}'?)", *meant) : "";
}

/// Arguments with -h, -o and -j (also -j4) replaced by the long options.
std::vector<std::string> spelt_out(int argc, const char* const* argv) {
  std::vector<std::string> words;
  for (int i = 1; i < argc; ++i) {
    const std::string_view word = argv[i];
    if (word == "-h") {
      words.emplace_back("--help");
    } else if (word == "-o") {
      words.emplace_back("--output");
    } else if (word == "-j") {
      words.emplace_back("--threads");
    } else if (word.starts_with("-j") && word.find_first_not_of("0123456789", 2) == std::string_view::npos) {
      words.push_back(fmt::format("--threads={}", word.substr(2)));
    } else {
      words.emplace_back(word);
    }
  }
  return words;
}

}  // namespace

void add_output(po::options_description& options, const char* meaning) {
  options.add_options()("output", po::value<std::string>()->value_name("DIR"), meaning);
}

void add_threads(po::options_description& options, const char* meaning) {
  options.add_options()("threads", po::value<int>()->value_name("N")->default_value(0), meaning);
}

void add_set(po::options_description& options) {
  options.add_options()("set",
                        po::value<std::vector<std::string>>()->value_name("KEY.PATH=VALUE")->composing(),
                        "replace one value of the configuration; lists are indexed by number; may be "
                        "repeated");
}

void add_actions(po::options_description& options, const char* meaning_of_explain) {
  options.add_options()("check", "read the configuration, report every problem, run nothing")(
      "explain", meaning_of_explain)("print-config",
                                     "print the complete configuration with every default, run nothing");
}

void add_progress(po::options_description& options) {
  options.add_options()("progress", po::value<std::string>()->value_name("WHEN")->default_value("auto"),
                        "auto (only on a terminal), always or never");
}

void add_verify(po::options_description& options, const char* meaning) {
  options.add_options()("verify", po::value<std::string>()->value_name("DIR"), meaning);
}

void add_last(po::options_description& options) {
  options.add_options()(
      "summary", po::value<std::string>()->value_name("json"),
      "end with one line of JSON on standard output: exit code, seconds, counts, warnings, files")(
      "quiet", "print errors only")(
      "help", "print this and exit; -h, -o and -j are short for --help, --output and --threads")(
      "version", "print the version and exit");
}

std::string text_of(const po::options_description& options) {
  std::ostringstream text;
  text << options;
  return text.str();
}

po::variables_map read_command_line(int argc, const char* const* argv, const po::options_description& options,
                                    const po::positional_options_description& positional) {
  po::variables_map given;
  try {
    // Abbreviated options are refused: --thread is an error, not --threads.
    const int style = po::command_line_style::default_style & ~po::command_line_style::allow_guessing;
    po::store(po::command_line_parser(spelt_out(argc, argv))
                  .options(options)
                  .positional(positional)
                  .style(style)
                  .run(),
              given);
  } catch (const po::unknown_option& error) {
    throw UsageError(error.what() + meant_instead_of(error.get_option_name(), options));
  } catch (const po::invalid_option_value& error) {
    // Only numbers can fail to convert; texts are taken as they are.
    throw UsageError(fmt::format("{}, allowed: a number", error.what()));
  } catch (const po::error& error) {
    throw UsageError(error.what());
  }
  if (is_given(given, "summary")) {
    const auto& form = given["summary"].as<std::string>();
    if (form != "json") throw UsageError(fmt::format("--summary: '{}' is not allowed, allowed: json", form));
    want_summary();
  }
  return given;
}

po::variables_map read_study_command_line(int argc, const char* const* argv,
                                          po::options_description options) {
  options.add_options()("config", po::value<std::string>());
  po::positional_options_description positional;
  positional.add("config", 1);
  return read_command_line(argc, argv, options, positional);
}

Action action_of(const po::variables_map& given) {
  Action action = Action::run;
  int count = 0;
  const auto choose = [&](const char* name, Action chosen) {
    if (!is_given(given, name)) return;
    action = chosen;
    ++count;
  };
  choose("check", Action::check);
  choose("explain", Action::explain);
  choose("print-config", Action::print_config);
  if (count > 1) throw UsageError("--check, --explain and --print-config exclude each other");
  if (is_given(given, "version")) return Action::version;
  if (is_given(given, "help")) return Action::help;
  return action;
}

StudyArguments study_arguments(const po::variables_map& given, std::string_view program) {
  StudyArguments arguments;
  arguments.action = action_of(given);
  if (arguments.action == Action::help || arguments.action == Action::version) return arguments;
  if (!is_given(given, "config"))
    throw UsageError(fmt::format("a configuration file is needed: {} CONFIG.yaml", program));
  arguments.config = given["config"].as<std::string>();
  if (is_given(given, "output")) {
    arguments.output = given["output"].as<std::string>();
    if (arguments.output->empty()) throw UsageError("--output: allowed: the name of a directory");
  }
  if (is_given(given, "set")) arguments.overrides = given["set"].as<std::vector<std::string>>();
  arguments.quiet = is_given(given, "quiet");
  return arguments;
}

std::vector<std::string_view> parts_of(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (std::size_t from = 0;;) {
    const std::size_t to = text.find(separator, from);
    parts.push_back(text.substr(from, to - from));
    if (to == std::string_view::npos) return parts;
    from = to + 1;
  }
}

std::optional<double> positive_number(const po::variables_map& given, const char* name) {
  if (!is_given(given, name)) return std::nullopt;
  const double value = given[name].as<double>();
  if (!model::contains(model::positive, value))
    throw UsageError(fmt::format("--{}: allowed: {}", name, model::describe(model::positive, value)));
  return value;
}

std::optional<double> not_negative_number(const po::variables_map& given, const char* name) {
  if (!is_given(given, name)) return std::nullopt;
  const double value = given[name].as<double>();
  if (!model::contains(model::not_negative, value))
    throw UsageError(fmt::format("--{}: allowed: {}", name, model::describe(model::not_negative, value)));
  return value;
}

bool asks_for(const char* name, const po::variables_map& given, std::string_view beside) {
  if (!is_given(given, name) || is_given(given, "help") || is_given(given, "version")) return false;
  for (const auto& [other, value] : given) {
    if (!value.defaulted() && other != name && other != beside && other != "quiet" && other != "summary")
      throw UsageError(fmt::format("--{}: is asked for alone, allowed: without {}", name,
                                   other == "config" ? "CONFIG.yaml" : "--" + other));
  }
  return true;
}

std::optional<std::filesystem::path> verified_directory_of(const po::variables_map& given) {
  if (!asks_for("verify", given)) return std::nullopt;
  return given["verify"].as<std::string>();
}

int threads_of(const po::variables_map& given) {
  const int threads = given["threads"].as<int>();
  if (threads < 0 || threads > most_threads)
    throw UsageError(fmt::format("--threads: allowed: a number from 0 to {}", most_threads));
  return threads;
}

std::string progress_word(batch::ProgressMode mode) {
  switch (mode) {
    case batch::ProgressMode::automatic: return "auto";
    case batch::ProgressMode::always: return "always";
    case batch::ProgressMode::never: return "never";
  }
  throw std::logic_error("progress without a word");
}

batch::ProgressMode progress_of(const po::variables_map& given) {
  const auto& word = given["progress"].as<std::string>();
  for (const auto mode :
       {batch::ProgressMode::automatic, batch::ProgressMode::always, batch::ProgressMode::never})
    if (word == progress_word(mode)) return mode;
  throw UsageError(fmt::format("--progress: '{}' is not allowed, allowed: auto, always, never", word));
}

}  // namespace rubsweep::apps
