#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "rubsweep/maps/batch/parallel_run.hpp"

namespace rubsweep::batch {
namespace {

using namespace std::chrono_literals;

Chunk cells_from(std::size_t first, std::size_t count) {
  Chunk cells(count);
  std::iota(cells.begin(), cells.end(), first);
  return cells;
}

const ChunkQueue::Clock::time_point start{};

TEST(ParallelRunChunkQueue, DealsOutEveryCellOnce) {
  for (const std::size_t count : {0u, 1u, 2u, 3u, 10u, 34u, 1000u, 1024u, 1320u}) {
    const Chunk cells = cells_from(100, count);
    ChunkQueue queue(cells, 3);
    Chunk dealt;
    for (std::size_t turn = 0;; ++turn) {
      const Chunk chunk = queue.next(turn % 3, start);
      if (chunk.empty()) break;
      dealt.insert(dealt.end(), chunk.begin(), chunk.end());
    }
    std::sort(dealt.begin(), dealt.end());
    EXPECT_EQ(dealt, cells) << count;
    EXPECT_TRUE(queue.next(0, start).empty());
  }
}

TEST(ParallelRunChunkQueue, DealsOutWhatItIsFilledWithAgain) {
  ChunkQueue queue({}, 2);
  EXPECT_TRUE(queue.next(0, start).empty());
  for (const std::size_t count : {5u, 40u}) {
    queue.refill(cells_from(7, count));
    Chunk dealt;
    for (Chunk chunk = queue.next(1, start); !chunk.empty(); chunk = queue.next(1, start))
      dealt.insert(dealt.end(), chunk.begin(), chunk.end());
    std::sort(dealt.begin(), dealt.end());
    EXPECT_EQ(dealt, cells_from(7, count));
  }
}

TEST(ParallelRunChunkQueue, AChunkIsSpreadOverAllCells) {
  for (const std::size_t count : {1000u, 1024u, 1320u, 65536u}) {
    ChunkQueue queue(cells_from(0, count), 1);
    Chunk chunk = queue.next(0, start);
    chunk.push_back(0);
    chunk.push_back(count);
    std::sort(chunk.begin(), chunk.end());
    // Sixteen points at multiples of the golden ratio leave no gap larger than 2.5 / 16.
    for (std::size_t i = 1; i < chunk.size(); ++i) EXPECT_LE(16 * (chunk[i] - chunk[i - 1]), 5 * count / 2);
  }
}

/// Sizes of `count` consecutive chunks of one worker, if each of its cells takes `cell_time`.
std::vector<std::size_t> sizes(ChunkQueue& queue, std::size_t worker, ChunkQueue::Clock::duration cell_time,
                               int count) {
  std::vector<std::size_t> result;
  auto now = start;
  for (int i = 0; i < count; ++i) {
    result.push_back(queue.next(worker, now).size());
    now += static_cast<int>(result.back()) * cell_time;
  }
  return result;
}

TEST(ParallelRunChunkQueue, AChunkTakesAQuarterOfASecondForEachWorker) {
  ChunkQueue queue(cells_from(0, 10'000'000), 2);
  EXPECT_EQ(sizes(queue, 0, 250us, 6), (std::vector<std::size_t>{16, 64, 256, 1000, 1000, 1000}));
  EXPECT_EQ(sizes(queue, 1, 50ms, 4), (std::vector<std::size_t>{16, 5, 5, 5}));
}

TEST(ParallelRunChunkQueue, CellsThatTakeNoTimeMakeNoEndlessChunk) {
  ChunkQueue queue(cells_from(0, 10'000'000), 1);
  EXPECT_EQ(sizes(queue, 0, 0us, 7), (std::vector<std::size_t>{16, 64, 256, 1024, 4096, 16384, 16384}));
}

TEST(ParallelRunChunkQueue, CellsThatTakeLongComeOneByOne) {
  ChunkQueue queue(cells_from(0, 1000), 1);
  EXPECT_EQ(sizes(queue, 0, 1h, 4), (std::vector<std::size_t>{16, 1, 1, 1}));
}

TEST(ParallelRunChunkQueue, ChunksShrinkTowardsTheEnd) {
  ChunkQueue queue(cells_from(0, 100), 2);
  // A chunk contains an eighth of the remaining cells.
  EXPECT_EQ(sizes(queue, 0, 1us, 4), (std::vector<std::size_t>{12, 11, 9, 8}));
  while (!queue.next(1, start).empty()) {
  }
  ChunkQueue few(cells_from(0, 3), 4);
  EXPECT_EQ(sizes(few, 0, 1us, 4), (std::vector<std::size_t>{1, 1, 1, 0}));
}

TEST(ParallelRunChunkQueue, ClosedItDealsOutNothingMore) {
  ChunkQueue queue(cells_from(0, 100), 1);
  EXPECT_FALSE(queue.next(0, start).empty());
  queue.close();
  EXPECT_TRUE(queue.next(0, start).empty());
}

}  // namespace
}  // namespace rubsweep::batch
