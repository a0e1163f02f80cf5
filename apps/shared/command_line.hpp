#pragma once

#include <boost/program_options/options_description.hpp>
#include <boost/program_options/positional_options.hpp>
#include <boost/program_options/variables_map.hpp>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "rubsweep/maps/batch/progress.hpp"
#include "shared/action.hpp"

/// Options common to several programs. Options appear in --help in the order in which they are added.
namespace rubsweep::apps {

namespace po = boost::program_options;

void add_output(po::options_description& options, const char* meaning);
void add_threads(po::options_description& options, const char* meaning);
void add_set(po::options_description& options);
void add_actions(po::options_description& options, const char* meaning_of_explain);
void add_progress(po::options_description& options);
void add_verify(po::options_description& options, const char* meaning);
/// Adds --quiet, --help and --version, which every program has.
void add_last(po::options_description& options);

/// The options as text for --help.
std::string text_of(const po::options_description& options);

/// Reads a command line; option names must be complete. Throws UsageError, like all functions below.
po::variables_map read_command_line(int argc, const char* const* argv, const po::options_description& options,
                                    const po::positional_options_description& positional);

/// Reads the command line of a program with one configuration file.
po::variables_map read_study_command_line(int argc, const char* const* argv, po::options_description options);

/// Action on the command line: the first of --version and --help, else the first of --check, --explain and
/// --print-config.
Action action_of(const po::variables_map& given);

/// Arguments from `read_study_command_line`; `program` is the name in the message about a missing file.
StudyArguments study_arguments(const po::variables_map& given, std::string_view program);

/// The parts of a text between separators, at least one.
std::vector<std::string_view> parts_of(std::string_view text, char separator);

/// Value of an option, which must be finite and > 0, or >= 0; empty where it is not given.
std::optional<double> positive_number(const po::variables_map& given, const char* name);
std::optional<double> not_negative_number(const po::variables_map& given, const char* name);

/// Whether the option `name` is given, which replaces a run. It may be combined only with --quiet, --summary
/// and the option `beside`. Throws UsageError for any other combination.
bool asks_for(const char* name, const po::variables_map& given, std::string_view beside = "");

/// The directory given by --verify.
std::optional<std::filesystem::path> verified_directory_of(const po::variables_map& given);

int threads_of(const po::variables_map& given);
batch::ProgressMode progress_of(const po::variables_map& given);

/// The word for a mode in --progress.
std::string progress_word(batch::ProgressMode mode);

}  // namespace rubsweep::apps
