#include "walkthroughs/trace/trace_event.hpp"

#include <algorithm>
#include <limits>

#include "walkthroughs/model/event_fields.hpp"
#include "walkthroughs/model/words_of.hpp"
#include "walkthroughs/text/printable.hpp"
#include "walkthroughs/trace/trace_values.hpp"

namespace walkthroughs {
namespace {

using namespace reading;

// -- Values, by the type of the field that takes them -----------------------------------------------------------------

void read(const Value& value, Meaning, double& number) {
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

void read(const Value& value, Meaning, Point& vector) {
  expect(value, Kind::list, "a vector [x, y, z]");
  const std::vector<Value> numbers = value.children();
  if (numbers.size() != 3) value.fail("expected a vector [x, y, z], found a list of " + std::to_string(numbers.size()));
  for (std::size_t i = 0; i < 3; ++i) read(numbers[i], Meaning::plain, vector[static_cast<int>(i)]);
}

void read(const Value& value, Meaning, std::variant<std::monostate, double, Point>& of_expression) {
  if (value.is(Kind::list))
    read(value, Meaning::plain, of_expression.emplace<Point>());
  else
    read(value, Meaning::plain, of_expression.emplace<double>());
}

void read(const Value& value, Meaning meaning, int& count) {
  switch (meaning) {
    case Meaning::simplex_size: count = whole_number(value, 1, 4); break;
    case Meaning::sign: count = whole_number(value, -1, 1); break;
    case Meaning::power: count = whole_number(value, -trace_limits::power, trace_limits::power); break;
    case Meaning::position: count = whole_number(value, 0, static_cast<int>(scene_limits::points) - 1); break;
    default: count = iteration(value);
  }
}

void read(const Value& value, Meaning meaning, std::string& text) {
  expect(value, Kind::string, "a string");
  text = meaning == Meaning::sentence ? sentence(value) : value.text();
}

void read(const Value& value, Meaning, gjk::Roles& roles) {
  expect(value, Kind::string, "a string");
  const auto named = gjk::Roles::named(value.text());
  if (!named) value.fail(in_quotes(value.text()) + " names no vertices: write letters from A to D, each once");
  roles = *named;
}

void read(const Value& value, Meaning, gjk::Expression& expression) {
  expect(value, Kind::string, "a string");
  const auto named = gjk::Expression::named(value.text());
  if (!named || named->empty())
    value.fail(in_quotes(value.text()) + " is no expression, such as 'AB×AO×AB' or 'ABn·AO'");
  expression = *named;
}

void read(const Value& value, Meaning, bool& is_true) {
  expect(value, Kind::boolean, "true or false");
  is_true = value.is_true();
}

template <class E>
requires std::is_enum_v<E>
void read(const Value& value, Meaning, E& enumerator) {
  enumerator = static_cast<E>(choice(value, words_of::all(E{})));
}

template <Record R>
void read(const Value& value, Meaning, R& record);

void read(const Value& value, Meaning, gjk::Simplex<double>& simplex) {
  expect(value, Kind::list, "a list of vertices");
  const std::vector<Value> vertices = value.children();
  if (vertices.size() > 4) value.fail("has " + std::to_string(vertices.size()) + " vertices; a simplex has at most 4");
  for (const Value& each : vertices) {
    gjk::Vertex<double> vertex;
    read(each, Meaning::plain, vertex);
    simplex.add(vertex);
  }
}

void read(const Value& value, Meaning, std::vector<gjk::ProofNumber>& numbers) {
  expect(value, Kind::list, "a list of numbers with their expressions");
  for (const Value& each : value.children()) {
    if (numbers.size() == 4) each.fail("is a fifth number; a proof has at most four");
    read(each, Meaning::plain, numbers.emplace_back());
  }
}

void read(const Value& value, Meaning, gjk::IndexPairs& pairs) {
  expect(value, Kind::list, "a list of pairs of indices [i, j]");
  for (const Value& each : value.children()) {
    if (pairs.size() == 4) each.fail("is a fifth pair; a simplex has at most four vertices");
    expect(each, Kind::list, "a pair of indices [i, j]");
    const std::vector<Value> both = each.children();
    if (both.size() != 2)
      each.fail("expected a pair of indices [i, j], found a list of " + std::to_string(both.size()));
    gjk::IndexPair pair;
    read(both[0], Meaning::position, pair.a);
    read(both[1], Meaning::position, pair.b);
    pairs.add(pair);
  }
}

void read(const Value& value, Meaning, gjk::Certificate& certificate) {
  expect_object(value, {"direction", "nearest", "simplex"}, "an object with 'direction', 'nearest' or 'simplex'");
  if (value.children().size() != 1) value.fail("is to have one of 'direction', 'nearest' and 'simplex'");
  if (const auto direction = value.member("direction"))
    read(*direction, Meaning::plain, certificate.emplace<gjk::SeparatingDirection>().d);
  else if (const auto nearest = value.member("nearest"))
    read(*nearest, Meaning::plain, certificate.emplace<gjk::SeparatingFeature>().of);
  else
    read(member(value, "simplex"), Meaning::plain, certificate.emplace<gjk::CommonSimplex>().of);
}

template <class T>
void read(const Value& value, Meaning meaning, std::optional<T>& optional) {
  read(value, meaning, optional.emplace());
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
std::vector<gjk::FirstDirection> candidates(gjk::FirstDirection) { return all_of(gjk::FirstDirection::as_told); }
std::vector<gjk::ReductionReason> candidates(gjk::ReductionReason) { return all_of(gjk::ReductionReason::as_told); }
/// Those of the report's rules first, of which nearly all events are.
const std::vector<gjk::Finding>& candidates(const gjk::Finding&) {
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
std::vector<gjk::Roles> candidates(const gjk::Roles&) { return {"ABC", "ABD", "ACD"}; }

/// The words that the program has for a field are looked up; there are no others.
template <class R>
void understand(const Value& value, const auto& field, R& record) {
  expect(value, Kind::string, "a string");
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
void read_fields(const Value& object, R& record) {
  for_each_field(record, [&](const auto& field, auto& into) {
    const bool is_there = object.member(field.key).has_value();
    if (!field.beside.empty() && is_there != object.member(field.beside).has_value())
      object.fail("'" + std::string(field.beside) + "' and '" + std::string(field.key) + "' belong together");
    if (!is_there && field.may_be_missing()) return;
    if constexpr (requires { field.meaning; }) {
      read(member(object, field.key), field.meaning, into);
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
void read(const Value& value, Meaning, R& record) {
  const RecordKeys keys = keys_of(record);
  expect_object(value, keys.all, "an object with " + list_of(keys.needed, "and"));
  read_fields(value, record);
}

// -- Events -----------------------------------------------------------------------------------------------------------

template <class E>
gjk::Event<double> read_as(const Value& line) {
  E event;
  std::vector<std::string> known = keys_of(event).all;
  known.insert(known.end(), {"scene", "iteration", "event"});
  for (const Value& each : line.children())
    if (std::ranges::count(known, each.key()) == 0) each.fail("is not a key of " + in_quotes(FieldsOf<E>::event));
  read_fields(line, event);
  event.iteration = iteration(member(line, "iteration"));
  return event;
}

}  // namespace

gjk::Event<double> read_event(const Value& line) {
  const auto read_one_of = [&]<class... Events>(std::type_identity<std::variant<Events...>>) {
    constexpr std::array readers{read_as<Events>...};
    return readers[choice(member(line, "event"), event_names)](line);
  };
  return read_one_of(std::type_identity<gjk::Event<double>>{});
}

}  // namespace walkthroughs
