// Streams in threads: the same items in the same order, and no thread that stays.
#include "base/read_ahead.h"

#include <atomic>
#include <chrono>
#include <numeric>
#include <vector>

#include <gtest/gtest.h>

namespace kadr::read_ahead_test {
namespace {

/// Counts up, in portions that change, to an end; says how far it came and when it is left.
class Counter final : public Stream<int> {
  public:
    explicit Counter(int end) : end_(end) {}
    std::size_t pull(std::span<int> out) override {
        // Between nothing left out and less than asked for, never 0 before the end.
        const auto most = std::min<std::size_t>(out.size(), 1 + static_cast<std::size_t>(at_) % 5);
        std::size_t written = 0;
        while (written < most && at_ < end_) out[written++] = at_++;
        reached_ = at_;
        return written;
    }
    int reached() const { return reached_; }

  private:
    int end_;
    int at_ = 0;
    std::atomic<int> reached_ = 0;
};

std::vector<int> all_of(Stream<int>& stream, std::size_t batch) {
    std::vector<int> out(batch);
    std::vector<int> all;
    while (const std::size_t n = stream.pull(out))
        all.insert(all.end(), out.begin(), out.begin() + static_cast<long>(n));
    return all;
}

TEST(ReadAhead, GivesTheSameWhateverTheBatchesAre) {
    std::vector<int> expected(1000);
    std::iota(expected.begin(), expected.end(), 0);
    for (const std::size_t batch : {1u, 2u, 3u, 7u, 64u, 999u, 2000u}) {
        for (const std::size_t depth : {1u, 2u, 5u}) {
            for (const std::size_t out : {1u, 4u, 512u}) {
                Counter counter(1000);
                ReadAhead<int> ahead(counter, batch, depth);
                EXPECT_EQ(all_of(ahead, out), expected);
                // After the end every further pull gives nothing.
                std::vector<int> more(3);
                EXPECT_EQ(ahead.pull(more), 0u);
                EXPECT_EQ(ahead.pull(more), 0u);
            }
        }
    }
}

TEST(ReadAhead, StagesMayFollowEachOther) {
    Counter counter(5000);
    ReadAhead<int> first(counter, 16, 2);
    ReadAhead<int> second(first, 5, 3);
    std::vector<int> expected(5000);
    std::iota(expected.begin(), expected.end(), 0);
    EXPECT_EQ(all_of(second, 33), expected);
}

TEST(ReadAhead, AnEmptyStreamEnds) {
    Counter counter(0);
    ReadAhead<int> ahead(counter);
    EXPECT_TRUE(all_of(ahead, 8).empty());
}

/// Who leaves in the middle, or without a pull, leaves no thread behind; the producer has gone no
/// further than the queue.
TEST(ReadAhead, MayBeLeftAtAnyTime) {
    for (int pulls = 0; pulls < 20; ++pulls) {
        Counter counter(1'000'000);
        {
            ReadAhead<int> ahead(counter, 10, 3);
            std::vector<int> out(4);
            for (int i = 0; i < pulls; ++i) EXPECT_GT(ahead.pull(out), 0u);
        }
        EXPECT_LE(counter.reached(), 4 * pulls + 10 * (3 + 2));
    }
}

}  // namespace
}  // namespace kadr::read_ahead_test
