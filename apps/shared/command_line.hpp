#pragma once

#include <boost/program_options/options_description.hpp>
#include <boost/program_options/positional_options.hpp>
#include <boost/program_options/variables_map.hpp>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "rubsweep/maps/batch/progress.hpp"
#include "shared/action.hpp"

/// Options that several programs have in common. An option is added where --help shows it.
namespace rubsweep::apps {

namespace po = boost::program_options;

void add_output(po::options_description& options, const char* meaning);
void add_threads(po::options_description& options, const char* meaning);
void add_set(po::options_description& options);
void add_actions(po::options_description& options, const char* meaning_of_explain);
void add_progress(po::options_description& options);
void add_verify(po::options_description& options, const char* meaning);
/// --quiet, --help and --version, of every program.
void add_last(po::options_description& options);

/// The options as --help shows them.
std::string text_of(const po::options_description& options);

/// Options must be spelt in full. Throws UsageError, as do all that follow.
po::variables_map read_command_line(int argc, const char* const* argv, const po::options_description& options,
                                    const po::positional_options_description& positional);

/// The same for a program that takes one configuration file.
po::variables_map read_study_command_line(int argc, const char* const* argv, po::options_description options);

/// Action asked for: of --version and --help the first that is given, else that of --check, --explain and
/// --print-config.
Action action_of(const po::variables_map& given);

/// Arguments read by `read_study_command_line`; `program` is who asks for the configuration file.
StudyArguments study_arguments(const po::variables_map& given, std::string_view program);

/// The number of an option that is finite and > 0, or >= 0; empty where it is not given.
std::optional<double> positive_number(const po::variables_map& given, const char* name);
std::optional<double> not_negative_number(const po::variables_map& given, const char* name);

/// Whether `name` is given, an option that asks for no run and goes alone or with --quiet, --summary and
/// `beside`. Throws UsageError.
bool asks_for(const char* name, const po::variables_map& given, std::string_view beside = "");

/// The directory of --verify.
std::optional<std::filesystem::path> verified_directory_of(const po::variables_map& given);

int threads_of(const po::variables_map& given);
batch::ProgressMode progress_of(const po::variables_map& given);

/// The word that --progress has for it.
std::string progress_word(batch::ProgressMode mode);

}  // namespace rubsweep::apps
