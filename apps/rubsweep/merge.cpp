#include "merge.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string>
#include <vector>

#include "rubsweep/core/error.hpp"
#include "shell_word.hpp"
#include "unfinished_cells.hpp"

namespace rubsweep::apps {
namespace {

/// Largest number of commands in a message, so that they do not fill the screen.
constexpr std::size_t most_commands = 20;

}  // namespace

std::string command_of(const RubsweepArguments& arguments, std::string_view more) {
  std::string command = "rubsweep " + shell_word(arguments.config.string());
  for (const std::string& key : arguments.overrides) command += " --set " + shell_word(key);
  if (arguments.output) command += " --output " + shell_word(arguments.output->string());
  return more.empty() ? command : command + " " + std::string(more);
}

void refuse_to_merge_too_early(const RubsweepArguments& arguments, const config::RunConfig& config,
                               const map::MapDirectory& directory) {
  const UnfinishedCells unfinished = unfinished_cells(directory, config.study.grid);
  if (unfinished.cells.empty()) return;
  const bool refined = config.study.grid.refinement.has_value();
  const std::size_t wanted = unfinished.cells.size(), count = unfinished.shard_count;
  std::string text =
      refined
          ? fmt::format("nothing to merge yet: the refined map wants {} cells more", wanted)
          : fmt::format("nothing to merge yet: {} of {} cells are not finished", wanted, directory.cells());
  if (count == 0) {
    throw IoError(fmt::format("{}, and no shard was begun, allowed: first\n  {}", text,
                              command_of(arguments, "--shard I/N")));
  }
  std::vector<std::string> names;
  for (const std::size_t shard : unfinished.shards) names.push_back(fmt::format("{}/{}", shard, count));
  text += fmt::format(", {} shard{} {}, allowed: first{}", refined ? "of" : "those of",
                      names.size() == 1 ? "" : "s", fmt::join(names, ", "),
                      refined ? " (begun at the same time they wait for each other)" : "");
  for (std::size_t i = 0; i < std::min(names.size(), most_commands); ++i)
    text += "\n  " + command_of(arguments, "--shard " + names[i]);
  if (names.size() > most_commands) text += fmt::format("\n  ... and {} more", names.size() - most_commands);
  throw IoError(text);
}

}  // namespace rubsweep::apps
