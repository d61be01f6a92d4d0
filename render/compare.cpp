#include "render/compare.hpp"

#include <algorithm>
#include <cstdlib>
#include <stdexcept>
#include <vector>

namespace render {
namespace {

constexpr int channels = 3;

/// Groups of pixels that hang together by an edge or a corner, found row by row. Runs of neighbours in a row are joined
/// to the runs of the row above that they touch; groups that meet become one (union-find).
class Groups {
 public:
  /// The pixels `from`, …, `to` of the current row are off. Runs come from left to right and do not touch.
  void add_run(int from, int to) {
    std::size_t group = sizes_.size();
    parents_.push_back(group);
    sizes_.push_back(to - from + 1);
    while (passed_ < above_.size() && above_[passed_].to + 1 < from) ++passed_;
    for (std::size_t i = passed_; i < above_.size() && above_[i].from <= to + 1; ++i)
      group = join(group, above_[i].group);
    largest_ = std::max(largest_, sizes_[group]);
    row_.push_back({from, to, group});
  }

  void end_row() {
    above_.swap(row_);
    row_.clear();
    passed_ = 0;
  }

  std::int64_t largest() const { return largest_; }

 private:
  struct Run {
    int from, to;
    std::size_t group;
  };

  std::size_t root(std::size_t group) {
    while (parents_[group] != group) group = parents_[group] = parents_[parents_[group]];
    return group;
  }

  /// Requires: `one` is a root. Returns: the root of both.
  std::size_t join(std::size_t one, std::size_t other) {
    other = root(other);
    if (one == other) return one;
    if (sizes_[one] < sizes_[other]) std::swap(one, other);
    parents_[other] = one;
    sizes_[one] += sizes_[other];
    return one;
  }

  std::vector<std::size_t> parents_;
  std::vector<std::int64_t> sizes_;  // of the groups that are their own parents
  std::vector<Run> above_, row_;
  std::size_t passed_ = 0;  // runs above that end left of the current run, and of all that come
  std::int64_t largest_ = 0;
};

void enclose(PixelBox& box, int from_x, int to_x, int y, bool first) {
  if (first) box = {from_x, y, to_x, y};
  box.min_x = std::min(box.min_x, from_x);
  box.max_x = std::max(box.max_x, to_x);
  box.max_y = y;
}

int pixel_difference(const std::uint8_t* one, const std::uint8_t* other) {
  int most = 0;
  for (int channel = 0; channel < channels; ++channel) most = std::max(most, std::abs(one[channel] - other[channel]));
  return most;
}

/// Counts the pixels of one row: histogram, off and box of `found`, and its groups.
void compare_row(const Image& expected, const Image& actual, int y, Groups& groups, Comparison& found) {
  const std::uint8_t *e = expected.row(y), *a = actual.row(y);
  const int width = expected.size().width;
  int run = 0;  // pixels that are off, just left of x
  for (int x = 0; x <= width; ++x) {
    const int most = x < width ? pixel_difference(e + channels * x, a + channels * x) : 0;
    if (x < width) ++found.histogram[static_cast<std::size_t>(most)];
    if (most > found.tolerance.channel) {
      ++run;
    } else if (run > 0) {
      groups.add_run(x - run, x - 1);
      enclose(found.box, x - run, x - 1, y, found.off == 0);
      found.off += run;
      run = 0;
    }
  }
  groups.end_row();
}

Verdict verdict_of(const Comparison& found) {
  if (found.largest_difference() == 0) return Verdict::same;
  const bool within = found.off <= found.allowed && found.largest_group <= found.tolerance.group;
  return within ? Verdict::within_tolerance : Verdict::different;
}

std::string in_words(Size size) { return std::to_string(size.width) + "x" + std::to_string(size.height); }

std::string pixels(std::int64_t count) { return std::to_string(count) + (count == 1 ? " pixel" : " pixels"); }

}  // namespace

std::int64_t Tolerance::allowed(Size size) const {
  const std::int64_t all = std::int64_t{size.width} * size.height;
  return std::min(std::max(few, all / one_in), all / small_one_in);
}

const char* name(Verdict verdict) {
  switch (verdict) {
    case Verdict::same: return "same";
    case Verdict::within_tolerance: return "within the tolerance";
    case Verdict::different: return "different";
    case Verdict::other_size: return "another size";
    case Verdict::missing: return "missing";
    case Verdict::extra: return "extra";
    case Verdict::unreadable: return "unreadable";
  }
  return "";
}

int Comparison::largest_difference() const {
  const auto last = std::find_if(histogram.rbegin(), histogram.rend(), [](std::int64_t count) { return count > 0; });
  return std::max(0, static_cast<int>(histogram.rend() - last) - 1);
}

Comparison compare(const Image& expected, const Image& actual, const Tolerance& tolerance) {
  if (tolerance != Tolerance{} && tolerance.reason.empty())
    throw std::invalid_argument("compare: a tolerance of its own needs a reason");
  Comparison found{.tolerance = tolerance, .expected = expected.size(), .actual = actual.size()};
  if (found.expected != found.actual) {
    found.verdict = Verdict::other_size;
    return found;
  }
  found.allowed = tolerance.allowed(found.expected);
  Groups groups;
  for (int y = 0; y < found.expected.height; ++y) compare_row(expected, actual, y, groups, found);
  found.largest_group = groups.largest();
  found.verdict = verdict_of(found);
  return found;
}

std::string in_words(const Comparison& c) {
  if (c.verdict == Verdict::other_size)
    return "expected " + in_words(c.expected) + " pixels, actual " + in_words(c.actual);
  if (c.verdict == Verdict::same) return "all pixels are equal";
  const auto limit = [](std::int64_t most) { return " (" + std::to_string(most) + " may be)"; };
  if (c.off == 0)
    return "no pixel is off; channels differ by up to " + std::to_string(c.largest_difference()) +
           limit(c.tolerance.channel);
  return pixels(c.off) + (c.off == 1 ? " is off" : " are off") + limit(c.allowed) + "; the largest group is " +
         pixels(c.largest_group) + limit(c.tolerance.group) + "; all within " +
         in_words(Size{c.box.width(), c.box.height()}) + " at (" + std::to_string(c.box.min_x) + ", " +
         std::to_string(c.box.min_y) + ")";
}

Image difference(const Image& expected, const Image& actual) {
  Image result(expected.size());
  const std::size_t length = static_cast<std::size_t>(expected.size().width) * channels;
  for (int y = 0; y < expected.size().height; ++y) {
    const std::uint8_t *e = expected.row(y), *a = actual.row(y);
    std::uint8_t* to = result.row(y);
    for (std::size_t i = 0; i < length; ++i)
      to[i] = static_cast<std::uint8_t>(std::min(255, difference_gain * std::abs(e[i] - a[i])));
  }
  return result;
}

}  // namespace render
