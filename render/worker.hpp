/// A second thread that works off jobs in the order in which they came.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>

namespace render {

/// One thread hands over jobs, one other thread runs them. After a job has thrown, no later one runs; the exception
/// reaches whoever hands over the next job, or finishes.
class Worker {
 public:
  using Job = std::function<void()>;

  /// At most `waiting` jobs wait, so that what they hold does not pile up. Requires: waiting >= 1.
  explicit Worker(std::size_t waiting);
  /// Runs the jobs that wait; what they throw is lost. Call finish() to see it.
  ~Worker();
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  /// Hands over a job; waits while there are too many. Errors: what an earlier job has thrown; then `job` does not run.
  void post(Job job);
  /// Returns when all jobs have run. Errors: what one of them has thrown.
  void finish();

 private:
  void run();
  void rethrow();

  const std::size_t most_waiting_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Job> jobs_;
  std::exception_ptr error_;
  bool busy_ = false, closing_ = false;
  std::thread thread_;  // last: everything it uses is there before it starts
};

}  // namespace render
