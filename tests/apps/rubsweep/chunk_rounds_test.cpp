#include "rubsweep/chunk_rounds.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace rubsweep::apps {
namespace {

std::vector<std::size_t> cells_from(std::size_t first, std::size_t count) {
  std::vector<std::size_t> cells(count);
  std::iota(cells.begin(), cells.end(), first);
  return cells;
}

/// Lets the workers request chunks in turn until each is finished or waits; returns all cells dealt out,
/// ascending.
std::vector<std::size_t> deal(ChunkRounds& chunks, std::size_t workers) {
  std::vector<std::size_t> dealt;
  std::vector<bool> asks(workers, true);
  while (std::ranges::find(asks, true) != asks.end()) {
    for (std::size_t worker = 0; worker < workers; ++worker) {
      if (!asks[worker]) continue;
      const auto chunk = chunks.next(worker);
      asks[worker] = chunk && !chunk->empty();
      if (chunk) dealt.insert(dealt.end(), chunk->begin(), chunk->end());
    }
  }
  std::ranges::sort(dealt);
  return dealt;
}

TEST(ChunkRounds, DealOutEachCellOnceAndThenNone) {
  ChunkRounds chunks(cells_from(7, 500), 3, false);
  EXPECT_TRUE(chunks.is_last());
  EXPECT_EQ(deal(chunks, 3), cells_from(7, 500));
  EXPECT_EQ(chunks.waiting(), 0u);
  ASSERT_TRUE(chunks.next(1));
  EXPECT_TRUE(chunks.next(1)->empty());
}

TEST(ChunkRounds, LetWorkersWaitForTheNextRoundAndAnswerThemInTheirOrder) {
  ChunkRounds chunks(cells_from(0, 40), 3, true);
  EXPECT_EQ(deal(chunks, 3), cells_from(0, 40));
  EXPECT_EQ(chunks.waiting(), 3u);
  EXPECT_FALSE(chunks.next(2));
  EXPECT_EQ(chunks.waiting(), 3u) << "who asks twice waits once";
  chunks.begin_round(cells_from(100, 30));
  EXPECT_FALSE(chunks.is_last());
  EXPECT_EQ(chunks.take_waiting().size(), 3u);
  EXPECT_FALSE(chunks.waits(0));
  EXPECT_EQ(deal(chunks, 3), cells_from(100, 30));

  ChunkRounds order({}, 3, true);
  for (const std::size_t worker : {2u, 0u, 1u}) EXPECT_FALSE(order.next(worker));
  EXPECT_EQ(order.take_waiting(), (std::vector<std::size_t>{2, 0, 1}));
}

TEST(ChunkRounds, EndWithARoundThatHasNoCells) {
  ChunkRounds chunks(cells_from(0, 5), 2, true);
  deal(chunks, 2);
  chunks.begin_round({});
  EXPECT_TRUE(chunks.is_last());
  for (const std::size_t worker : chunks.take_waiting()) {
    const auto chunk = chunks.next(worker);
    ASSERT_TRUE(chunk);
    EXPECT_TRUE(chunk->empty());
  }
}

TEST(ChunkRounds, DealOutNothingOnceGivenUp) {
  ChunkRounds chunks(cells_from(0, 1000), 2, true);
  ASSERT_TRUE(chunks.next(0));
  ChunkRounds waiting({}, 2, true);
  ASSERT_FALSE(waiting.next(1));
  for (ChunkRounds* given_up : {&chunks, &waiting}) {
    given_up->give_up();
    EXPECT_TRUE(given_up->is_last());
    ASSERT_TRUE(given_up->next(1));
    EXPECT_TRUE(given_up->next(1)->empty());
  }
  EXPECT_TRUE(waiting.waits(1)) << "it is still to be told";
}

}  // namespace
}  // namespace rubsweep::apps
