#include <array>
#include <set>

#include "tests/kit/catch.hpp"
#include "tests/study/pairs/pairs.hpp"

namespace study {
namespace dice_test {

TEST_CASE("Dice: the published values of FNV-1a", "[dice]") {
  REQUIRE(hash("") == 0xcbf29ce484222325);
  REQUIRE(hash("a") == 0xaf63dc4c8601ec8c);
  REQUIRE(hash("foobar") == 0x85944171f73967e8);
}

TEST_CASE("Dice: the same numbers on every machine", "[dice]") {
  Dice dice(1, "triangles", 0);
  const std::array<std::uint64_t, 2> first{dice.bits(), dice.bits()};
  REQUIRE(first == std::array<std::uint64_t, 2>{0xabb20f065ed6d40a, 0xdc5111d1a96a4f6d});
}

TEST_CASE("Dice: seed, name and index each give other numbers", "[dice]") {
  std::set<std::uint64_t> first;
  for (const std::uint64_t seed : {0, 1, 2})
    for (const char* name : {"", "a", "b"})
      for (std::uint64_t index = 0; index < 100; ++index) first.insert(Dice(seed, name, index).bits());
  REQUIRE(first.size() == 900);
}

TEST_CASE("Dice: unit() is at least 0 and below 1, and spread evenly", "[dice]") {
  Dice dice(1, "unit", 0);
  std::array<int, 10> tenths{};
  for (int i = 0; i < 100000; ++i) {
    const double x = dice.unit();
    REQUIRE((x >= 0 && x < 1));
    ++tenths[static_cast<std::size_t>(10 * x)];
  }
  for (const int count : tenths) REQUIRE(std::abs(count - 10000) < 500);  // more than five standard deviations
}

TEST_CASE("Dice: whole() reaches both ends and nothing beyond, all alike", "[dice]") {
  Dice dice(1, "whole", 0);
  std::array<int, 7> counts{};
  for (int i = 0; i < 70000; ++i) ++counts.at(static_cast<std::size_t>(dice.whole(-3, 3) + 3));
  for (const int count : counts) REQUIRE(std::abs(count - 10000) < 500);
  REQUIRE(dice.whole(5, 5) == 5);
}

TEST_CASE("Dice: directions have length 1 and no side is preferred", "[dice]") {
  Dice dice(1, "direction", 0);
  Vec sum = Vec::Zero();
  for (int i = 0; i < 10000; ++i) {
    const Vec d = dice.direction();
    REQUIRE(std::abs(d.norm() - 1) < 1e-15);
    sum += d;
  }
  REQUIRE(sum.norm() < 500);
}

TEST_CASE("Dice: a shuffled list has the same members, in each order alike", "[dice]") {
  Dice dice(1, "shuffle", 0);
  std::array<int, 3> where_0_went{};
  for (int i = 0; i < 30000; ++i) {
    std::vector<int> list{0, 1, 2};
    dice.shuffle(list);
    REQUIRE(std::multiset<int>(list.begin(), list.end()) == std::multiset<int>{0, 1, 2});
    for (std::size_t k = 0; k < 3; ++k)
      if (list[k] == 0) ++where_0_went[k];
  }
  for (const int count : where_0_went) REQUIRE(std::abs(count - 10000) < 500);
}

}  // namespace dice_test
}  // namespace study
