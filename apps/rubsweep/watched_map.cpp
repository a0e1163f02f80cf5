#include "watched_map.hpp"

#include <unistd.h>

#include <cstdio>
#include <string>
#include <string_view>

#include "character_map.hpp"
#include "map_status.hpp"
#include "rubsweep/core/error.hpp"
#include "rubsweep/maps/batch/journal.hpp"
#include "rubsweep/maps/config/run_config.hpp"
#include "rubsweep/maps/sweep/grid.hpp"
#include "shared/program.hpp"
#include "terminal_map.hpp"

namespace rubsweep::apps {
namespace {

namespace fs = std::filesystem;

/// Map of characters from the finished cells of all journals; empty where there is nothing to show.
std::string cells_under_way(const fs::path& directory, const sweep::Grid& grid) {
  batch::FinishedCells finished(sweep::cell_count(grid));
  for (const auto& entry : fs::directory_iterator(directory)) {
    const std::string name = entry.path().filename();
    if (name.starts_with("map.") && name.ends_with(".journal")) finished.add(entry.path());
  }
  if (finished.count() == 0 || sweep::disordered_axis(grid)) return "";
  CharacterMap map(grid);
  for (std::size_t cell = 0; cell < sweep::cell_count(grid); ++cell) {
    if (finished.contains(cell)) {
      map.add(finished.text(cell));
    } else {
      map.add_unfinished();
    }
  }
  return map.text(terminal_width(), shows_colours());
}

/// The map so far; empty where it cannot be read.
std::string picture(const fs::path& directory) {
  try {
    const sweep::Grid grid = config::read_run_config(directory / "config.yaml", {}).study.grid;
    if (fs::exists(directory / "map.csv")) return map_in_characters(directory / "map.csv", grid);
    return cells_under_way(directory, grid);
  } catch (const IoError&) {
    return "";
  } catch (const fs::filesystem_error&) {
    return "";
  }
}

struct Screen {
  std::string status, picture;
  bool at_work = false;
};

Screen look(const fs::path& directory) {
  // Determined before the map is read, so that the last screen shows the finished map.
  const bool at_work = is_at_work(directory);
  const std::string status = map_status(directory);  // takes two seconds while a process works
  return {status, picture(directory), at_work};
}

/// Reads the status again if it fails, because files may vanish when processes end; throws after five
/// failures.
Screen look_again(const fs::path& directory) {
  constexpr int tries = 5;
  for (int i = 1; i < tries; ++i) {
    try {
      return look(directory);
    } catch (const IoError&) {
      if (!fs::is_directory(directory)) throw;
    } catch (const fs::filesystem_error&) {
      if (!fs::is_directory(directory)) throw;
    }
  }
  return look(directory);
}

}  // namespace

void watch_map(const fs::path& directory) {
  // Escape codes: go to the upper left corner, and delete everything below.
  constexpr std::string_view from_the_top = "\x1b[H\x1b[J";
  const bool again = ::isatty(STDOUT_FILENO) != 0;
  for (bool first = true;; first = false) {
    const Screen screen = look_again(directory);
    if (again)
      std::fputs((first ? "\x1b[2J" + std::string(from_the_top) : std::string(from_the_top)).c_str(), stdout);
    std::fputs(screen.picture.c_str(), stdout);  // not by print, as the picture contains colour codes
    print("{}", screen.status);
    std::fflush(stdout);
    if (!again || !screen.at_work) return;
  }
}

}  // namespace rubsweep::apps
