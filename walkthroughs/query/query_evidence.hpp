/// Answers of queries as JSON. Written by hand: a tree of JSON in between would take longer than the query.
#pragma once

#include <cmath>
#include <concepts>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

#include "core/gjk.hpp"
#include "walkthroughs/model/number_text.hpp"
#include "walkthroughs/model/words_of.hpp"

namespace walkthroughs::query {

template <std::floating_point S>
void write(const S& x, std::string& out) {
  if (!std::isfinite(x)) {
    out += std::isnan(x) ? "\"nan\"" : x > 0 ? "\"inf\"" : "\"-inf\"";
    return;
  }
  // Many readers of JSON would stop at such a number.
  const bool beyond_double = static_cast<long double>(std::fabs(x)) > std::numeric_limits<double>::max();
  if (beyond_double) out += '"';
  append_number(x, out);
  if (beyond_double) out += '"';
  if (x == 0 && std::signbit(x)) out += ".0";  // readers take "-0" for a whole number, which has no sign
}

template <class S>
requires(!std::floating_point<S>) void write(const S& fraction, std::string& out) {
  out += '"';
  out += fraction.str();
  out += '"';
}

/// Appends "[…,…]", each as `write_one` appends it.
template <class List, class WriteOne>
void write_list(const List& list, std::string& out, WriteOne&& write_one) {
  const char* before = "[";
  for (const auto& one : list) {
    out += before;
    write_one(one);
    before = ",";
  }
  out += ']';
}

template <class Numbers>
void write_numbers(const Numbers& list, std::string& out) {
  write_list(list, out, [&out](const auto& number) { write(number, out); });
}

template <class S>
void write_sources(const gjk::Vertex<S>& vertex, std::string& out) {
  const auto write_index = [&](std::string_view key, const std::optional<int>& index) {
    if (index) out.append(key).append(std::to_string(*index));
  };
  write_numbers(vertex.a.point, out += "\"a\":");
  write_numbers(vertex.b.point, out += ",\"b\":");
  write_index(",\"a_index\":", vertex.a.index);
  write_index(",\"b_index\":", vertex.b.index);
}

template <class S>
void write(const gjk::Simplex<S>& simplex, std::string& out) {
  write_list(simplex, out, [&out](const gjk::Vertex<S>& vertex) {
    write_numbers(vertex.w, out += "{\"w\":");
    write_sources(vertex, out += ',');
    out += '}';
  });
}

/// Appends what all answers begin with.
template <class Result>
void write_status(const Result& result, std::string& out) {
  out.append("{\"status\":\"").append(words_of::of(result.status));
  out.append("\",\"iterations\":").append(std::to_string(result.iterations));
}

template <class S>
void write_answer(const gjk::Result<S>& result, std::string& out) {
  write_status(result, out);
  out.append(",\"reason\":\"").append(words_of::of(result.reason)).append("\",\"evidence\":{");
  if (const auto& proof = result.separation) {
    write_numbers(proof->direction, out += "\"direction\":");
    write(proof->support_value, out += ",\"support_value\":");
    write_sources(proof->vertex, out += ',');
  } else {
    write(result.simplex, out += "\"simplex\":");
  }
  out += "}}\n";
}

}  // namespace walkthroughs::query
