/// Objects and pairs as gjkstep query reads them.
#pragma once

#include <string>

namespace walkthroughs::test {

inline constexpr const char* ball = R"({"sphere":{"center":[0,0,0],"radius":1}})";
inline constexpr const char* ball_ten_away = R"({"sphere":{"center":[10,0,0],"radius":1}})";
inline constexpr const char* dot = R"({"points":[[0,0,0]]})";

inline std::string pair_of(const std::string& a, const std::string& b) { return R"({"a":)" + a + R"(,"b":)" + b + "}"; }

}  // namespace walkthroughs::test
