// SPDX-FileCopyrightText: 2026 The Lanefuse Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <string>

namespace lanefuse {

/// Independent jobs, each of which makes a text.
struct OrderedJobs {
  std::size_t count = 0;
  std::size_t workers = 1;  ///< threads; at least 1

  /// Does one job, in a thread of its own; tells now and then how far it is, in [0, 1].
  std::function<std::string(std::size_t job, const std::function<void(double)>& progress)> run;
  /// Takes what came of it: on the calling thread, in the order of the jobs, each as soon as it and all
  /// before it are done.
  std::function<void(std::size_t job, const std::string& text)> take;
  /// Hears a few times a second, on the calling thread, how many jobs are done; parts of jobs count.
  std::function<void(double done)> progress;
};

/// Runs them all. What comes out does not depend on the number of workers. The first job, in their order,
/// that throws ends the run: what was begun is finished, all before it is taken, and its exception is thrown.
void run_jobs(const OrderedJobs& jobs);

}  // namespace lanefuse
