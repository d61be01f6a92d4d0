#include "render/worker.hpp"

#include <atomic>
#include <memory>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/kit/catch.hpp"

using render::Worker;

namespace {

/// A door that jobs stop at until it is opened.
class Door {
 public:
  void open() {
    open_ = true;
    open_.notify_all();
  }
  void pass() { open_.wait(false); }

 private:
  std::atomic<bool> open_ = false;
};

std::string error_of(const std::function<void()>& call) {
  try {
    call();
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("a worker runs all jobs, in the order in which they came, on another thread") {
  std::vector<int> ran;
  std::vector<int> expected(200);
  std::iota(expected.begin(), expected.end(), 0);
  std::thread::id thread;
  Worker worker(3);
  for (const int i : expected)
    worker.post([&, i] {
      ran.push_back(i);
      thread = std::this_thread::get_id();
    });
  worker.finish();
  REQUIRE(ran == expected);
  REQUIRE(thread != std::this_thread::get_id());
}

TEST_CASE("no more jobs wait than the worker was told") {
  Door door;
  std::atomic<int> handed_over = 0;
  Worker worker(2);
  std::thread giver([&] {
    for (int i = 0; i < 6; ++i) {
      worker.post([&] { door.pass(); });
      ++handed_over;
    }
  });
  // One runs and two wait; the fourth is not taken before the door opens. Nothing can be seen of a thread that waits, so
  // this only fails when it is wrong and not every time: but often enough.
  while (handed_over < 3) std::this_thread::yield();
  for (int i = 0; i < 50; ++i) std::this_thread::yield();
  REQUIRE(handed_over == 3);
  door.open();
  giver.join();
  worker.finish();
  REQUIRE(handed_over == 6);
}

TEST_CASE("what a job throws reaches the thread that hands over jobs, and no later job runs") {
  bool later = false;
  Worker worker(8);
  Door door;
  worker.post([&] { door.pass(); });
  worker.post([] { throw std::runtime_error("disk full"); });
  worker.post([&] { later = true; });
  door.open();
  REQUIRE(error_of([&] { worker.finish(); }) == "disk full");
  REQUIRE(error_of([&] { worker.post([&] { later = true; }); }) == "disk full");
  REQUIRE(error_of([&] { worker.finish(); }) == "disk full");
  REQUIRE_FALSE(later);
}

TEST_CASE("who waits for room hears of an error") {
  Worker worker(1);
  Door door;
  worker.post([&] {
    door.pass();
    throw std::runtime_error("disk full");
  });
  std::string error;
  std::thread giver([&] {
    for (int i = 0; i < 5 && error.empty(); ++i) error = error_of([&] { worker.post([] {}); });
  });
  door.open();
  giver.join();
  REQUIRE(error_of([&] { worker.finish(); }) == "disk full");
}

TEST_CASE("a worker that has finished or goes away has run what it was given and keeps nothing, and may go on before") {
  const auto held = std::make_shared<int>(0);
  {
    Worker worker(4);
    for (int round = 1; round <= 2; ++round) {
      worker.post([held] { ++*held; });
      worker.finish();
      REQUIRE(*held == round);
      REQUIRE(held.use_count() == 1);
    }
    for (int i = 0; i < 4; ++i) worker.post([held] { ++*held; });
  }
  REQUIRE(*held == 6);
  REQUIRE(held.use_count() == 1);
}

TEST_CASE("work is done side by side, and what remains in the order in which it came") {
  std::vector<int> order;
  std::atomic<int> working = 0, most = 0;
  Door both;
  Worker worker(20, 2);
  for (int i = 0; i < 20; ++i)
    worker.prepare([&, i]() -> Worker::Job {
      const int here = ++working;
      if (here == 2) both.open();
      if (i < 2) both.pass();  // the first two wait for each other: one thread alone would never end
      int seen = most;
      while (seen < here && !most.compare_exchange_weak(seen, here)) {
      }
      --working;
      return [&order, i] { order.push_back(i); };
    });
  worker.finish();
  std::vector<int> expected(20);
  std::iota(expected.begin(), expected.end(), 0);
  REQUIRE(order == expected);
  REQUIRE(most == 2);
}

TEST_CASE("work that throws is told in its turn: what came before it is done, what came after is not") {
  std::vector<int> order;
  Worker worker(10, 3);
  REQUIRE(error_of([&] {
            for (int i = 0; i < 6; ++i)  // who hands over the last ones may be told already
              worker.prepare([&order, i]() -> Worker::Job {
                if (i == 3) throw std::runtime_error("three");
                return [&order, i] { order.push_back(i); };
              });
            worker.finish();
          }) == "three");
  REQUIRE(error_of([&] { worker.post([&order] { order.push_back(9); }); }) == "three");
  REQUIRE(order == std::vector<int>{0, 1, 2});
}

TEST_CASE("work that waits is done before a worker of several threads is gone") {
  std::atomic<int> done = 0;
  {
    Worker worker(8, 4);
    for (int i = 0; i < 8; ++i) worker.prepare([&done]() -> Worker::Job { return [&done] { ++done; }; });
  }
  REQUIRE(done == 8);
}
