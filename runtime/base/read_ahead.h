// read_ahead.h — a stream whose producer works in a thread of its own.
//
// Batches wait in a queue of a few: the producer stops when it is full, so memory does not grow,
// and the consumer gets the items in their order, whatever the threads do. Everything upstream runs
// in the producer's thread from the first pull on; nobody else may touch it until the stream has
// ended or is gone. Whoever leaves early ends the producer: it finishes its batch, no more.
//
//     ReadAhead<Setpoint> ahead(sampler);
//     while (const std::size_t n = ahead.pull(batch)) …
#pragma once

#include <algorithm>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <span>
#include <thread>
#include <utility>
#include <vector>

#include "base/stream.h"

namespace kadr {

template <typename T>
class ReadAhead final : public Stream<T> {
  public:
    /// `from` outlives this.
    ///
    /// batch  items that the producer asks for in one go, at least 1
    /// depth  batches that may wait, at least 1
    explicit ReadAhead(Stream<T>& from, std::size_t batch = kBatch, std::size_t depth = 4)
        : from_(from), batch_(batch), depth_(depth) {}
    ReadAhead(const ReadAhead&) = delete;
    ReadAhead& operator=(const ReadAhead&) = delete;
    ~ReadAhead() override { end(); }

    std::size_t pull(std::span<T> out) override {
        if (!producer_.joinable() && !has_ended_) producer_ = std::thread([this] { produce(); });
        if (at_ == current_.size() && !next_batch()) return 0;
        const std::size_t count = std::min(out.size(), current_.size() - at_);
        for (std::size_t i = 0; i < count; ++i) out[i] = std::move(current_[at_ + i]);
        at_ += count;
        return count;
    }

  private:
    /// Takes the oldest batch that waits; false at the end, when the thread is gone.
    bool next_batch() {
        if (has_ended_) return false;
        {
            std::unique_lock lock(mutex_);
            changed_.wait(lock, [this] { return !waiting_.empty() || is_drained_; });
            if (!waiting_.empty()) {
                spare_.push_back(std::exchange(current_, std::move(waiting_.front())));
                waiting_.pop_front();
                at_ = 0;
                changed_.notify_all();
                return true;
            }
        }
        end();
        return false;
    }

    void produce() {
        while (true) {
            std::vector<T> batch = room();
            const std::size_t count = from_.pull(batch);
            batch.resize(count);
            std::unique_lock lock(mutex_);
            changed_.wait(lock, [this] { return waiting_.size() < depth_ || is_left_; });
            if (count > 0) waiting_.push_back(std::move(batch));
            is_drained_ = count == 0 || is_left_;
            changed_.notify_all();
            if (is_drained_) return;
        }
    }

    /// A batch to fill; one that was read before, if there is one.
    std::vector<T> room() {
        std::vector<T> batch;
        {
            const std::scoped_lock lock(mutex_);
            if (!spare_.empty()) {
                batch = std::move(spare_.back());
                spare_.pop_back();
            }
        }
        batch.resize(batch_);
        return batch;
    }

    void end() {
        {
            const std::scoped_lock lock(mutex_);
            is_left_ = true;
            changed_.notify_all();
        }
        if (producer_.joinable()) producer_.join();
        has_ended_ = true;
    }

    Stream<T>& from_;
    std::size_t batch_;
    std::size_t depth_;

    // The consumer's.
    std::thread producer_;
    std::vector<T> current_;
    std::size_t at_ = 0;
    bool has_ended_ = false;

    // Of both, under the mutex.
    std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<std::vector<T>> waiting_;
    std::vector<std::vector<T>> spare_;  // read, to be filled again
    bool is_drained_ = false;            // the producer puts nothing in any more
    bool is_left_ = false;               // the consumer wants nothing any more
};

}  // namespace kadr
