// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#include "benchmark/job_pool.hpp"

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <thread>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace lanefuse {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

OrderedJobs jobs(std::size_t count, std::size_t workers, std::vector<std::string>& taken) {
  OrderedJobs pool;
  pool.count = count;
  pool.workers = workers;
  pool.run = [](std::size_t job, const auto& progress) {
    progress(0.5);
    // The first jobs take longest: those that are done early must wait for them.
    std::this_thread::sleep_for(std::chrono::milliseconds(job < 3 ? 20 - 5 * job : 0));
    return std::to_string(job);
  };
  pool.take = [&taken](std::size_t, const std::string& text) { taken.push_back(text); };
  pool.progress = [](double) {};
  return pool;
}

TEST(JobPool, HandsOverInOrderWhateverTheNumberOfWorkers) {
  std::vector<std::string> alone;
  run_jobs(jobs(20, 1, alone));
  EXPECT_EQ(alone.size(), 20U);
  for (const std::size_t workers : {2U, 5U, 64U}) {
    std::vector<std::string> taken;
    run_jobs(jobs(20, workers, taken));
    EXPECT_EQ(taken, alone) << workers;
  }
}

TEST(JobPool, NothingToDoIsDone) {
  std::vector<std::string> taken;
  run_jobs(jobs(0, 4, taken));
  EXPECT_THAT(taken, IsEmpty());
}

TEST(JobPool, TellsProgressUpToTheEnd) {
  std::vector<std::string> taken;
  OrderedJobs pool = jobs(6, 2, taken);
  double last = 0;
  pool.progress = [&](double done) {
    EXPECT_LE(done, 6);
    last = done;
  };
  run_jobs(pool);
  EXPECT_EQ(last, 6);
}

TEST(JobPool, TheFirstFailureEndsItAfterWhatCameBefore) {
  for (const std::size_t workers : {1U, 3U}) {
    std::vector<std::string> taken;
    OrderedJobs pool = jobs(5000, workers, taken);
    std::atomic<int> begun{0};
    pool.run = [&](std::size_t job, const auto&) {
      ++begun;
      if (job == 2) throw std::runtime_error("job 2");
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
      return std::to_string(job);
    };
    EXPECT_THROW(run_jobs(pool), std::runtime_error);
    EXPECT_THAT(taken, ElementsAre("0", "1"));
    EXPECT_LT(begun, 5000);
  }
}

TEST(JobPool, WhoCannotTakeEndsItToo) {
  std::vector<std::string> taken;
  OrderedJobs pool = jobs(5000, 2, taken);
  std::atomic<int> begun{0};
  pool.run = [&](std::size_t, const auto&) {
    ++begun;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    return std::string();
  };
  pool.take = [](std::size_t, const std::string&) { throw std::runtime_error("full"); };
  EXPECT_THROW(run_jobs(pool), std::runtime_error);
  EXPECT_LT(begun, 5000);
}

}  // namespace
}  // namespace lanefuse
