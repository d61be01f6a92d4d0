#include "walkthroughs/program/listing.hpp"

#include <sstream>

#include "tests/kit/catch.hpp"
#include "tests/walkthroughs/support.hpp"

using namespace walkthroughs;
using namespace walkthroughs::test;

namespace {

Walkthrough named(const std::string& from, const std::string& name, const std::string& summary) {
  Walkthrough w = walkthrough(from);
  w.name = name;
  w.summary = summary;
  return w;
}

Walkthrough region(const std::string& from, const std::string& name, const RegionCase& which) {
  Walkthrough w = named(from, name, "not shown");
  w.region_case = which;
  return w;
}

std::string table(const std::vector<const Walkthrough*>& walkthroughs) {
  std::ostringstream out;
  write_table(out, walkthroughs);
  return out.str();
}

}  // namespace

TEST_CASE("A list goes folder by folder, each with its own column, in the order in which they first appear") {
  std::ostringstream out;
  write_list(out, {named("figure-5", "one", "first"), named("figure-5", "regions/a", "second"),
                   named("figure-5", "eleven", "third"), named("figure-5", "regions/a-long-name", "fourth")});
  CHECK(out.str() ==
        "one     first\n"
        "eleven  third\n"
        "\n"
        "regions/a            second\n"
        "regions/a-long-name  fourth\n");
}

TEST_CASE("A table has a header and a row for each case, columns aligned whatever the letters, numbers to the right") {
  const Walkthrough hit = region("figure-4-left", "regions/r10", {"R10: beyond ABC_n", "3.2.3"});
  const Walkthrough miss = region("figure-4-right", "regions/r2", {"R2: AB×AO = 0", "3.2.1"});
  CHECK(table({&hit, &miss}) ==
        "name         case              section  status        frames\n"
        "regions/r10  R10: beyond ABCn  3.2.3    intersecting      18\n"
        "regions/r2   R2: AB×AO = 0     3.2.1    separated          6\n");
}

TEST_CASE("A walkthrough that is no case is told by its summary, and every one of its scenes by how it ends") {
  const Walkthrough both = named("figure-5", "both", "two sets");
  CHECK(table({&both}) == "name  case      section" + std::string(both.source.size() - 7, ' ') +
                              "  status                   frames\n"
                              "both  two sets  " +
                              both.source + "  intersecting, separated       3\n");
}
