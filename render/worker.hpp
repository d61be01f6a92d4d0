/// Further threads that work off jobs, and finish them in the order in which they came.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace render {

/// One thread hands over jobs, others run them. After a job has thrown, no later one runs; the exception reaches whoever
/// hands over the next job, or finishes.
class Worker {
 public:
  /// Runs alone, after all that were handed over before it.
  using Job = std::function<void()>;
  /// Runs beside others, in any order. Returns: the job that remains to be done in its turn.
  using Work = std::function<Job()>;

  /// At most `waiting` jobs wait, those included that are being prepared, so that what they hold does not pile up. Fewer
  /// threads where the system does not give so many. Requires: waiting >= 1, threads >= 1.
  /// Errors: std::system_error where it gives none.
  explicit Worker(std::size_t waiting, std::size_t threads = 1);
  /// Runs the jobs that wait; what they throw is lost. Call finish() to see it.
  ~Worker();
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  /// Hands over a job; waits while there are too many. Errors: what an earlier job has thrown; then `job` does not run.
  void post(Job job);
  /// Hands over a job of which most can be done beside others.
  void prepare(Work work);
  /// Returns when all jobs have run. Errors: what one of them has thrown.
  void finish();

 private:
  struct Entry {
    Work work;  ///< until it is begun
    Job job;
    bool ready;
  };

  void hand_over(Entry entry);
  void run();
  void run_front(std::unique_lock<std::mutex>& lock);
  void run_work(Entry& entry, std::unique_lock<std::mutex>& lock);
  bool front_is_ready() const { return !busy_ && !entries_.empty() && entries_.front().ready; }
  Entry* next_work();
  void rethrow();

  const std::size_t most_waiting_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Entry> entries_;
  std::exception_ptr error_;
  bool busy_ = false, closing_ = false;
  std::vector<std::thread> threads_;  // last: everything they use is there before they start
};

}  // namespace render
