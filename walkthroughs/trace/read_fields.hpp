/// Reads what field lists name (event_fields.hpp, header_fields.hpp): a function read() for each type of field.
/// What is not as expected is complained about, as in scene_values.hpp.
#pragma once

#include <algorithm>
#include <array>
#include <limits>

#include "walkthroughs/model/event_fields.hpp"
#include "walkthroughs/model/words_of.hpp"
#include "walkthroughs/text/printable.hpp"
#include "walkthroughs/trace/trace_values.hpp"

namespace walkthroughs::reading {

/// How the value of a field is read. `space`: of what belongs to a scene, where it lies; of events, whose numbers need not be finite,
/// none.
struct How {
  Meaning meaning = Meaning::plain;
  const Space* space = nullptr;
};

// -- Values, by the type of the field that takes them -----------------------------------------------------------------

inline void read(const Value& value, const How&, double& number) {
  if (value.is(Kind::number)) {
    number = value.number();
    return;
  }
  expect(value, Kind::string, "a number, \"inf\", \"-inf\" or \"nan\"");
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (value.text() == "nan")
    number = std::numeric_limits<double>::quiet_NaN();
  else if (value.text() == "inf" || value.text() == "-inf")
    number = value.text() == "inf" ? infinity : -infinity;
  else
    value.fail(in_quotes(value.text()) +
               " is not a number; those that are not finite are \"inf\", \"-inf\" and \"nan\"");
}

inline void read(const Value& value, const How& how, Point& vector) {
  if (how.space) {
    vector = how.meaning == Meaning::direction ? how.space->first_direction(value) : how.space->point(value);
    return;
  }
  if (!expect(value, Kind::list, "a vector [x, y, z]")) return;
  const std::vector<Value> numbers = value.children();
  if (numbers.size() != 3)
    return value.fail("expected a vector [x, y, z], found a list of " + std::to_string(numbers.size()));
  for (std::size_t i = 0; i < 3; ++i) read(numbers[i], {}, vector[static_cast<int>(i)]);
}

inline void read(const Value& value, const How&, std::variant<std::monostate, double, Point>& of_expression) {
  if (value.is(Kind::list))
    read(value, {}, of_expression.emplace<Point>());
  else
    read(value, {}, of_expression.emplace<double>());
}

inline void read(const Value& value, const How& how, int& count) {
  switch (how.meaning) {
    case Meaning::simplex_size: count = whole_number(value, 1, 4); break;
    case Meaning::sign: count = whole_number(value, -1, 1); break;
    case Meaning::power: count = whole_number(value, -trace_limits::power, trace_limits::power); break;
    case Meaning::position: count = whole_number(value, 0, static_cast<int>(scene_limits::points) - 1); break;
    case Meaning::limit: count = whole_number(value, 1, scene_limits::iterations); break;
    default: count = iteration(value);
  }
}

inline void read(const Value& value, const How& how, std::string& text) {
  expect(value, Kind::string, "a string");
  switch (how.meaning) {
    case Meaning::name: text = words(value, scene_limits::name); break;
    case Meaning::title: text = words(value, scene_limits::title); break;
    case Meaning::sentence: text = sentence(value); break;
    default: text = value.text();
  }
}

inline void read(const Value& value, const How&, gjk::Roles& roles) {
  expect(value, Kind::string, "a string");
  const auto named = gjk::Roles::named(value.text());
  if (!named) return value.fail(in_quotes(value.text()) + " names no vertices: write letters from A to D, each once");
  roles = *named;
}

inline void read(const Value& value, const How&, gjk::Expression& expression) {
  expect(value, Kind::string, "a string");
  const auto named = gjk::Expression::named(value.text());
  if (!named || named->empty())
    return value.fail(in_quotes(value.text()) + " is no expression, such as 'AB×AO×AB' or 'ABn·AO'");
  expression = *named;
}

inline void read(const Value& value, const How&, bool& is_true) {
  expect(value, Kind::boolean, "true or false");
  is_true = value.is_true();
}

template <class E>
requires std::is_enum_v<E>
void read(const Value& value, const How&, E& enumerator) {
  enumerator = static_cast<E>(choice(value, words_of::all(E{})));
}

template <Record R>
void read(const Value& value, const How& how, R& record);

inline void read(const Value& value, const How&, gjk::Simplex<double>& simplex) {
  expect(value, Kind::list, "a list of vertices");
  const std::vector<Value> vertices = value.children();
  if (vertices.size() > 4)
    return value.fail("has " + std::to_string(vertices.size()) + " vertices; a simplex has at most 4");
  for (const Value& each : vertices) {
    gjk::Vertex<double> vertex;
    read(each, {}, vertex);
    simplex.add(vertex);
  }
}

inline void read(const Value& value, const How&, std::vector<gjk::FilterValue>& numbers) {
  expect(value, Kind::list, "a list of numbers with their expressions");
  for (const Value& each : value.children()) {
    if (numbers.size() == 4) return each.fail("is a fifth number; a proof has at most four");
    read(each, {}, numbers.emplace_back());
  }
}

inline void read(const Value& value, const How&, gjk::IndexPairs& pairs) {
  expect(value, Kind::list, "a list of pairs of indices [i, j]");
  for (const Value& each : value.children()) {
    if (pairs.size() == 4) return each.fail("is a fifth pair; a simplex has at most four vertices");
    expect(each, Kind::list, "a pair of indices [i, j]");
    const std::vector<Value> both = each.children();
    if (both.size() != 2)
      return each.fail("expected a pair of indices [i, j], found a list of " + std::to_string(both.size()));
    gjk::IndexPair pair;
    read(both[0], {Meaning::position}, pair.a);
    read(both[1], {Meaning::position}, pair.b);
    pairs.add(pair);
  }
}

inline void read(const Value& value, const How&, gjk::Certificate& certificate) {
  expect_object(value, {"direction", "nearest", "simplex"}, "an object with 'direction', 'nearest' or 'simplex'");
  if (value.children().size() != 1) value.fail("is to have one of 'direction', 'nearest' and 'simplex'");
  if (const auto direction = value.member("direction"))
    read(*direction, {}, certificate.emplace<gjk::SeparatingDirection>().d);
  else if (const auto nearest = value.member("nearest"))
    read(*nearest, {}, certificate.emplace<gjk::SeparatingFeature>().of);
  else
    read(member(value, "simplex"), {}, certificate.emplace<gjk::CommonSimplex>().of);
}

template <class T>
void read(const Value& value, const How& how, std::optional<T>& optional) {
  read(value, how, optional.emplace());
}

// -- Records ----------------------------------------------------------------------------------------------------------

struct RecordKeys {
  std::vector<std::string> all, needed;
};

template <Record R>
RecordKeys keys_of(const R& record) {
  RecordKeys keys;
  for_each_field(record, [&](const auto& field, const auto&) {
    keys.all.emplace_back(field.key);
    if (!field.may_be_missing()) keys.needed.emplace_back(field.key);
  });
  return keys;
}

// What a field that is told in words may hold.

template <class E>
requires std::is_enum_v<E> std::vector<E> all_of(E last) {
  std::vector<E> all;
  for (int i = 0; i <= static_cast<int>(last); ++i) all.push_back(static_cast<E>(i));
  return all;
}
inline std::vector<gjk::FirstDirection> candidates(gjk::FirstDirection) { return all_of(gjk::FirstDirection::as_told); }
inline std::vector<gjk::ReductionReason> candidates(gjk::ReductionReason) {
  return all_of(gjk::ReductionReason::as_told);
}
/// Those of the report's rules first, of which nearly all events are.
inline const std::vector<gjk::Finding>& candidates(const gjk::Finding&) {
  static const std::vector<gjk::Finding> findings = [] {
    const auto reasons = all_of(gjk::RegionReason::no_face_sees_origin);
    std::vector<gjk::Finding> all;
    for (const gjk::RegionReason is : reasons) all.push_back({is});
    for (const gjk::RegionReason is : reasons)
      for (const gjk::RegionReason as_if : reasons) all.push_back({is, as_if});
    return all;
  }();
  return findings;
}
inline std::vector<gjk::Roles> candidates(const gjk::Roles&) { return {"ABC", "ABD", "ACD"}; }

/// The words that the program has for a field are looked up; there are no others.
template <class R>
void understand(const Value& value, const auto& field, R& record) {
  const std::string text = sentence(value);
  for (const auto& candidate : candidates(record.*field.member)) {
    record.*field.member = candidate;
    if (field.say(record) == text) return;
  }
  value.fail("is " + in_quotes(text) + ", which no search says there; " + trace_advice);
}

template <class R>
void require_derived(const Value& object, const auto& field, const R& record) {
  const std::string said = field.say(record);
  const std::optional<Value> value = object.member(field.key);
  if (!value && field.may_be_missing() && said.empty()) return;
  const Value given = member(object, field.key);
  expect(given, Kind::string, "a string");
  if (given.text() != said)
    given.fail("is " + in_quotes(given.text()) + ", but the other fields say " + in_quotes(said) + "; " + trace_advice);
}

template <Record R>
void read_fields(const Value& object, const How& how, R& record) {
  for_each_field(record, [&](const auto& field, auto& into) {
    const bool is_there = object.member(field.key).has_value();
    if (!field.beside.empty() && is_there != object.member(field.beside).has_value())
      object.fail("'" + std::string(field.beside) + "' and '" + std::string(field.key) + "' belong together");
    if (!is_there && field.may_be_missing()) return;
    if constexpr (requires { field.word; }) {
      choice(member(object, field.key), std::array{field.word});
      into = true;
    } else if constexpr (requires { field.meaning; }) {
      read(member(object, field.key), How{field.meaning, how.space}, into);
    } else if constexpr (requires { field.member; }) {
      understand(member(object, field.key), field, into);
    }
  });
  for_each_field(record, [&](const auto& field, auto& whole) {
    if constexpr (
        requires { field.say; } && !requires { field.member; })
      require_derived(object, field, whole);
  });
}

template <Record R>
void read_record(const Value& value, const How& how, R& record) {
  const RecordKeys keys = keys_of(record);
  expect_object(value, keys.all, "an object with " + list_of(keys.needed, "and"));
  read_fields(value, how, record);
}

template <Record R>
void read(const Value& value, const How& how, R& record) {
  read_record(value, how, record);
}

}  // namespace walkthroughs::reading
