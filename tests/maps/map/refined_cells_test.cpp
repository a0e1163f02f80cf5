#include "rubsweep/maps/map/refined_cells.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "maps/map/small_map.hpp"
#include "rubsweep/core/error.hpp"
#include "rubsweep/maps/batch/csv_table.hpp"
#include "rubsweep/maps/map/map_files.hpp"

namespace rubsweep::map {
namespace {

/// Adds the wanted cells, with orders from `order_of`, until no more are wanted; returns their number.
template <class OrderOf>
std::size_t cells_wanted(const sweep::Grid& grid, const OrderOf& order_of) {
  RefinedCells known(grid);
  std::size_t cells = 0;
  for (auto wanted = known.wanted(); !wanted.empty(); wanted = known.wanted()) {
    cells += wanted.size();
    for (const std::size_t cell : wanted) known.add(cell, SmallMap::line(0, order_of(cell)));
  }
  return cells;
}

TEST(RefinedCells, WantMoreWhereLabelsDiffer) {
  const config::RunConfig config = SmallMap::config(SmallMap::refined());
  const sweep::Grid& grid = config.study.grid;
  const std::size_t all = sweep::cell_count(grid);
  const std::size_t alike = cells_wanted(grid, [](std::size_t) { return 2; }),
                    differing = cells_wanted(grid, [](std::size_t cell) { return cell % 5 < 2 ? 2 : 3; });
  EXPECT_GT(alike, 0u);
  EXPECT_LT(alike, differing);
  EXPECT_LE(differing, all);
}

TEST(RefinedCells, ReadWhatAnyJournalOfTheDirectoryHolds) {
  const SmallMap map;
  const config::RunConfig config = SmallMap::config(SmallMap::refined());
  const MapDirectory directory = map.begin({}, false, SmallMap::refined());
  RefinedCells known(config.study.grid);
  const std::vector<std::size_t> wanted = known.wanted();
  ASSERT_GT(wanted.size(), 1u);
  directory.journal().append(wanted.front(), SmallMap::line(0));
  known.read(directory);
  EXPECT_EQ(known.wanted(), std::vector<std::size_t>(wanted.begin() + 1, wanted.end()));
}

const batch::TableSource source{"test 1", "0123", {}};

/// Order 2 in the last two columns of the grid, order 1 elsewhere.
int order_of(std::size_t cell) { return cell % 5 < 3 ? 1 : 2; }

/// Writes the rows that the refinement of a grid needs; returns their number.
std::size_t write_refined_map(const std::filesystem::path& file, const sweep::Grid& grid) {
  RefinedCells known(grid);
  std::ofstream map(file);
  map << "speed_hz,whirl_ratio,class,order,kind\n";
  std::size_t rows = 0;
  for (auto wanted = known.wanted(); !wanted.empty(); wanted = known.wanted()) {
    for (const std::size_t cell : wanted) {
      known.add(cell, SmallMap::line(0, order_of(cell)));
      map << batch::csv_number(grid.speed_hz[cell % 5]) << ',' << batch::csv_number(grid.unbalance[cell / 5])
          << ',' << (order_of(cell) == 1 ? "synchronous,1,circle" : "subharmonic,2,subharmonic_2") << '\n';
      ++rows;
    }
  }
  return rows;
}

TEST(RefinedCellsPaintedMap, HasARowForEachCellWithTheMotionOfItsBlock) {
  const TemporaryDirectory directory;
  const sweep::Grid grid = SmallMap::config(SmallMap::refined()).study.grid;
  const std::size_t computed = write_refined_map(directory.path() / "map.csv", grid);
  ASSERT_LT(computed, 25u);
  write_painted_map(directory.path() / "map.csv", grid, source);

  batch::CsvReader rows(directory.path() / painted_map_file);
  const std::vector<std::string> header{"speed_hz", "whirl_ratio", "class", "order", "kind", "computed"};
  EXPECT_EQ(rows.header(), header);
  std::size_t cell = 0;
  std::ptrdiff_t of_them = 0;
  for (; rows.next(); ++cell) {
    ASSERT_LT(cell, 25u);
    EXPECT_EQ(rows.number(0), grid.speed_hz[cell % 5]);
    EXPECT_EQ(rows.number(1), grid.unbalance[cell / 5]);
    EXPECT_EQ(rows.number(3), order_of(cell)) << "cell " << cell;
    EXPECT_EQ(rows.cells()[4], order_of(cell) == 1 ? "circle" : "subharmonic_2");
    of_them += rows.cells()[5] == "1" ? 1 : 0;
  }
  EXPECT_EQ(cell, 25u);
  EXPECT_EQ(of_them, static_cast<std::ptrdiff_t>(computed));
}

TEST(RefinedCellsPaintedMap, RefusesARowThatIsNoCell) {
  const TemporaryDirectory directory;
  const sweep::Grid grid = SmallMap::config(SmallMap::refined()).study.grid;
  std::ofstream(directory.path() / "map.csv")
      << "speed_hz,whirl_ratio,class,order,kind\n61,0.1,synchronous,1,circle\n";
  EXPECT_THROW(write_painted_map(directory.path() / "map.csv", grid, source), IoError);
  EXPECT_FALSE(std::filesystem::exists(directory.path() / painted_map_file));
}

}  // namespace
}  // namespace rubsweep::map
