#include "render/worker.hpp"

#include <algorithm>
#include <system_error>
#include <utility>

namespace render {

Worker::Worker(std::size_t waiting, std::size_t threads) : most_waiting_(waiting) {
  threads_.emplace_back([this] { run(); });
  try {
    while (threads_.size() < threads) threads_.emplace_back([this] { run(); });
  } catch (const std::system_error&) {  // one is enough
  }
}

Worker::~Worker() {
  {
    const std::lock_guard lock(mutex_);
    closing_ = true;
  }
  changed_.notify_all();
  for (std::thread& thread : threads_) thread.join();
}

void Worker::post(Job job) { hand_over({nullptr, std::move(job), true}); }

void Worker::prepare(Work work) { hand_over({std::move(work), nullptr, false}); }

void Worker::hand_over(Entry entry) {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [&] { return entries_.size() < most_waiting_ || error_ != nullptr; });
  rethrow();
  entries_.push_back(std::move(entry));
  changed_.notify_all();
}

void Worker::finish() {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [&] { return (entries_.empty() && !busy_) || error_ != nullptr; });
  rethrow();
}

void Worker::rethrow() {
  if (error_ != nullptr) std::rethrow_exception(error_);
}

Worker::Entry* Worker::next_work() {
  const auto found = std::ranges::find_if(entries_, [](const Entry& entry) { return entry.work != nullptr; });
  return found == entries_.end() ? nullptr : &*found;
}

void Worker::run() {
  std::unique_lock lock(mutex_);
  while (true) {
    changed_.wait(lock, [&] { return front_is_ready() || next_work() || (closing_ && entries_.empty()); });
    if (front_is_ready())
      run_front(lock);
    else if (Entry* const entry = next_work())
      run_work(*entry, lock);
    else
      return;
  }
}

/// What has failed is told in its turn: whatever came before it is done.
void Worker::run_work(Entry& entry, std::unique_lock<std::mutex>& lock) {
  Work work = std::exchange(entry.work, nullptr);
  Job job;
  if (error_ == nullptr) {
    lock.unlock();
    try {
      job = work();
    } catch (...) {
      job = [error = std::current_exception()] { std::rethrow_exception(error); };
    }
    work = nullptr;  // gives back what it holds before anybody is told that it is done
    lock.lock();
  }
  entry.job = std::move(job);
  entry.ready = true;
  changed_.notify_all();
}

void Worker::run_front(std::unique_lock<std::mutex>& lock) {
  Job job = std::move(entries_.front().job);
  entries_.pop_front();
  changed_.notify_all();
  if (error_ != nullptr) return;
  busy_ = true;
  lock.unlock();
  std::exception_ptr error;
  try {
    job();
  } catch (...) {
    error = std::current_exception();
  }
  job = nullptr;
  lock.lock();
  error_ = error;
  busy_ = false;
  changed_.notify_all();
}

}  // namespace render
