#include "render/compare.hpp"

#include <algorithm>
#include <cstdlib>

namespace render {
namespace {

constexpr int channels = 3;

/// Groups of pixels that hang together by an edge or a corner, found row by row: a pixel is of the group of those beside and
/// above it, and groups that meet become one (union-find).
class Groups {
 public:
  explicit Groups(int width) : above_(static_cast<std::size_t>(width) + 2), row_(above_) {}

  /// The pixel `x` of the current row is off. Pixels come from left to right.
  void add(int x) {
    const auto at = static_cast<std::size_t>(x) + 1;
    std::size_t group = none;
    for (const std::size_t near : {row_[at - 1], above_[at - 1], above_[at], above_[at + 1]})
      if (near != none) group = join(group, root(near));
    if (group == none) {
      group = parents_.size();
      parents_.push_back(group);
      sizes_.push_back(0);
    }
    row_[at] = group;
    largest_ = std::max(largest_, ++sizes_[group]);
  }

  void end_row() {
    above_.swap(row_);
    std::ranges::fill(row_, none);
  }

  std::int64_t largest() const { return largest_; }

 private:
  static constexpr std::size_t none = 0;

  std::size_t root(std::size_t group) {
    while (parents_[group] != group) group = parents_[group] = parents_[parents_[group]];
    return group;
  }

  /// Requires: roots; the first may be none. Returns: the root of both.
  std::size_t join(std::size_t one, std::size_t other) {
    if (one == other || one == none) return other;
    if (sizes_[one] < sizes_[other]) std::swap(one, other);
    parents_[other] = one;
    sizes_[one] += sizes_[other];
    return one;
  }

  std::vector<std::size_t> above_, row_;  // the group of each pixel, and none before the first and after the last
  std::vector<std::size_t> parents_{none};
  std::vector<std::int64_t> sizes_{0};  // of the groups that are their own parents
  std::int64_t largest_ = 0;
};

int pixel_difference(const std::uint8_t* one, const std::uint8_t* other) {
  int most = 0;
  for (int channel = 0; channel < channels; ++channel) most = std::max(most, std::abs(one[channel] - other[channel]));
  return most;
}

/// Counts the pixels of one row: histogram, off and box of `found`, and its groups.
void compare_row(const Image& expected, const Image& actual, int y, Groups& groups, Comparison& found) {
  const std::uint8_t *e = expected.row(y), *a = actual.row(y);
  for (int x = 0; x < expected.size().width; ++x) {
    const int most = pixel_difference(e + channels * x, a + channels * x);
    ++found.histogram[static_cast<std::size_t>(most)];
    if (most <= tolerance::channel) continue;
    groups.add(x);
    if (found.off++ == 0) found.box = {x, y, x, y};
    found.box = {std::min(found.box.min_x, x), found.box.min_y, std::max(found.box.max_x, x), y};
  }
  groups.end_row();
}

Verdict verdict_of(const Comparison& found) {
  if (found.largest_difference() == 0) return Verdict::same;
  const bool within = found.off <= found.allowed && found.largest_group <= tolerance::group;
  return within ? Verdict::within_tolerance : Verdict::different;
}

std::string in_words(Size size) { return std::to_string(size.width) + "x" + std::to_string(size.height); }

std::string pixels(std::int64_t count) { return std::to_string(count) + (count == 1 ? " pixel" : " pixels"); }

}  // namespace

std::int64_t tolerance::allowed(Size size) { return std::int64_t{size.width} * size.height / one_in; }

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

Comparison compare(const Image& expected, const Image& actual) {
  Comparison found{.expected = expected.size(), .actual = actual.size()};
  if (found.expected != found.actual) {
    found.verdict = Verdict::other_size;
    return found;
  }
  found.allowed = tolerance::allowed(found.expected);
  Groups groups(found.expected.width);
  for (int y = 0; y < found.expected.height; ++y) compare_row(expected, actual, y, groups, found);
  found.largest_group = groups.largest();
  found.verdict = verdict_of(found);
  return found;
}

std::string in_words(const Comparison& c) {
  if (c.verdict == Verdict::other_size)
    return "expected " + in_words(c.expected) + " pixels, actual " + in_words(c.actual);
  if (c.verdict == Verdict::same) return "all pixels are equal";
  const auto limit = [](std::int64_t most) { return " (allowed: " + std::to_string(most) + ")"; };
  if (c.off == 0)
    return "no pixel is off; channels differ by up to " + std::to_string(c.largest_difference()) +
           limit(tolerance::channel);
  return pixels(c.off) + (c.off == 1 ? " is off" : " are off") + limit(c.allowed) +
         "; the largest connected group is " + pixels(c.largest_group) + limit(tolerance::group) + "; all within " +
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
