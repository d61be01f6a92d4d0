/// Catch2, version 2 (Debian 12) or 3 (Debian 13), by the names that tests use.
#pragma once

#include <string>

#if __has_include(<catch2/catch_all.hpp>)
#include <catch2/catch_all.hpp>
using Catch::Approx;
#else
#include <catch2/catch.hpp>
#endif

namespace kit {

/// Matchers of texts, whose names the versions do not share: REQUIRE_THAT(text, contains("part")).
inline auto contains(const std::string& part) {
#if __has_include(<catch2/catch_all.hpp>)
  return Catch::Matchers::ContainsSubstring(part);
#else
  return Catch::Matchers::Contains(part);
#endif
}
inline auto starts_with(const std::string& beginning) { return Catch::Matchers::StartsWith(beginning); }

/// Says that a case cannot be tried here, and why: one that looks at nothing would fail.
inline void skip(const std::string& why) {
  WARN("skipped: " << why);
  SUCCEED("skipped");
}

}  // namespace kit
