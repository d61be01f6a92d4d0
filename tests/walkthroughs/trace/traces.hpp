/// Traces as texts, for the tests of their reader.
#pragma once

#include <sstream>

#include "tests/kit/json.hpp"
#include "tests/walkthroughs/support.hpp"
#include "walkthroughs/catalogue/catalogue.hpp"
#include "walkthroughs/trace/trace_file.hpp"
#include "walkthroughs/trace/trace_json.hpp"

namespace walkthroughs::test {

using namespace program;

using OrderedJson = kit::Json;
using kit::json_lines, kit::text_of;

inline std::string trace_text(const Walkthrough& w) {
  std::ostringstream out;
  write_traces(out, w);
  return out.str();
}

/// Returns: what the reader says about it; "read" where it has no complaint.
inline std::string complaint_about_trace(const std::string& text) {
  try {
    parse_trace(text, "bad.jsonl");
  } catch (const InputError& error) {
    return error.what();
  }
  return "read";
}

/// Returns: the walkthroughs of the catalogue that have a search.
inline std::vector<const Walkthrough*> searches() {
  std::vector<const Walkthrough*> list;
  for (const Walkthrough& w : whole_catalogue())
    if (w.layout != Layout::diagrams) list.push_back(&w);
  return list;
}

}  // namespace walkthroughs::test
