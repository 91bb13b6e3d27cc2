// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "benchmark/job_pool.hpp"

#include <algorithm>
#include <atomic>
#include <cassert>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <numeric>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

namespace lanefuse {
namespace {

struct Outcome {
  std::string text;
  std::exception_ptr failure;
};

/// What the workers and the caller share.
class Board {
 public:
  Board(std::size_t jobs, std::size_t workers) : jobs_(jobs), progress_(workers) {}

  std::optional<std::size_t> begin() {
    const std::lock_guard lock(mutex_);
    if (stopped_ || next_ == jobs_) return std::nullopt;
    return next_++;
  }
  void stop() {
    const std::lock_guard lock(mutex_);
    stopped_ = true;
  }
  void tell(std::size_t worker, double fraction) { progress_[worker] = fraction; }
  void end(std::size_t worker, std::size_t job, Outcome outcome) {
    const std::lock_guard lock(mutex_);
    progress_[worker] = 0;
    ++done_;
    stopped_ = stopped_ || outcome.failure != nullptr;
    outcomes_.resize(std::max(outcomes_.size(), job + 1));
    outcomes_[job] = std::move(outcome);
    changed_.notify_one();
  }

  /// What came of that job, or nothing if it is not done within `patience`.
  std::optional<Outcome> wait(std::size_t job, std::chrono::milliseconds patience) {
    std::unique_lock lock(mutex_);
    const auto there = [&] { return job < outcomes_.size() && outcomes_[job].has_value(); };
    if (!changed_.wait_for(lock, patience, there)) return std::nullopt;
    return std::exchange(outcomes_[job], Outcome{});
  }
  double done() {
    const std::lock_guard lock(mutex_);
    return std::accumulate(progress_.begin(), progress_.end(), static_cast<double>(done_));
  }

 private:
  const std::size_t jobs_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<std::optional<Outcome>> outcomes_;
  std::vector<std::atomic<double>> progress_;
  std::size_t next_ = 0;
  std::size_t done_ = 0;
  bool stopped_ = false;
};

void work(const OrderedJobs& jobs, Board& board, std::size_t worker) {
  while (const auto job = board.begin()) {
    Outcome outcome;
    try {
      outcome.text = jobs.run(*job, [&](double fraction) { board.tell(worker, fraction); });
    } catch (...) {
      outcome.failure = std::current_exception();
    }
    board.end(worker, *job, std::move(outcome));
  }
}

void take_all(const OrderedJobs& jobs, Board& board) {
  constexpr std::chrono::milliseconds kBetweenLooks(200);
  for (std::size_t job = 0; job < jobs.count;) {
    const auto outcome = board.wait(job, kBetweenLooks);
    jobs.progress(board.done());
    if (!outcome) continue;
    if (outcome->failure) std::rethrow_exception(outcome->failure);
    jobs.take(job++, outcome->text);
  }
}

}  // namespace

void run_jobs(const OrderedJobs& jobs) {
  assert(jobs.workers > 0);
  const std::size_t workers = std::min(jobs.workers, jobs.count);
  Board board(jobs.count, workers);
  std::vector<std::jthread> threads;
  for (std::size_t i = 0; i < workers; ++i) {
    threads.emplace_back([&jobs, &board, i] { work(jobs, board, i); });
  }
  try {
    take_all(jobs, board);
  } catch (...) {
    board.stop();
    throw;
  }
}

}  // namespace lanefuse
