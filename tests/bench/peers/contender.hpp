/// A library's collision test, as the benchmark asks it: shapes are made beforehand, and only the query is timed.
#pragma once

#include <exception>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "tests/study/pairs/pairs.hpp"

namespace peers {

enum class Answer : char {
  separated,
  intersecting,
  undecided,  ///< the library says that it does not know
  threw,      ///< an exception
  crashed,    ///< a signal ended the process
  timed_out,
  not_asked,  ///< it has no such call, or too many pairs crashed or timed out
};

/// Queries ready to be asked, one for each pair.
class Batch {
 public:
  Batch() = default;
  Batch(const Batch&) = delete;
  Batch& operator=(const Batch&) = delete;
  virtual ~Batch() = default;

  virtual Answer ask(std::size_t pair) = 0;
  /// Asks about `pairs`, in their order, with no virtual call between: this is what is timed.
  virtual void ask_all(std::span<const std::size_t> pairs, std::span<Answer> answers) = 0;
};

struct Contender {
  std::string name;  ///< "libccd GJK"
  std::string how;   ///< version, call and settings, for the table's foot
  std::unique_ptr<Batch> (*prepare)(const std::vector<study::Pair>& pairs);
  bool is_peer = true;      ///< somebody else's
  bool borrows = false;     ///< a peer that is given our support function
  std::string proves = {};  ///< the name of the contender that guesses what this one proves; empty: it proves nothing
};

/// The name of the peer that is always right about what it can be asked.
inline constexpr const char* exact_peer = "CGAL exact";

/// A batch of queries of one kind: Query is made from a pair and called without arguments. Where it cannot be made,
/// because the library refuses a shape, its answer is `threw`.
template <class Query>
class BatchOf final : public Batch {
 public:
  explicit BatchOf(const std::vector<study::Pair>& pairs) {
    for (const study::Pair& pair : pairs) {
      try {
        queries_.emplace_back(std::in_place, pair);
      } catch (const std::exception&) {
        queries_.emplace_back();
      }
    }
  }

  Answer ask(std::size_t pair) override {
    try {
      return queries_[pair] ? (*queries_[pair])() : Answer::threw;
    } catch (const std::exception&) {
      return Answer::threw;
    }
  }
  void ask_all(std::span<const std::size_t> pairs, std::span<Answer> answers) override {
    for (const std::size_t pair : pairs) answers[pair] = (*queries_[pair])();
  }

 private:
  std::vector<std::optional<Query>> queries_;
};

template <class Query>
std::unique_ptr<Batch> batch_of(const std::vector<study::Pair>& pairs) {
  return std::make_unique<BatchOf<Query>>(pairs);
}

/// Every contender of this build, the plain call first.
std::vector<Contender> contenders();

}  // namespace peers
