// The lists of fields: they have every member of their structs, and the schema of traces names the same keys and words.
#include "walkthroughs/model/event_fields.hpp"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>

#include "tests/kit/catch.hpp"
#include "walkthroughs/model/any_shape.hpp"
#include "walkthroughs/model/words_of.hpp"
#include "walkthroughs/trace/trace_json.hpp"

using namespace walkthroughs;
using Json = nlohmann::json;
using Words = std::set<std::string>;

namespace {

// -- Members ----------------------------------------------------------------------------------------------------------

template <class R, class T>
std::tuple<T> members_of(const Field<R, T>&);
template <class R, class T>
std::tuple<T> members_of(const Spoken<R, T>&);
template <class R, class T>
std::tuple<T> members_of(const Inlined<R, T>&);
template <class R>
std::tuple<> members_of(const Derived<R>&);

template <class R, class... Members>
constexpr bool has_just(std::type_identity<std::tuple<Members...>>) {
  constexpr bool has_these = requires { R{std::declval<Members>()...}; };
  constexpr bool has_more = requires { R{std::declval<Members>()..., {}}; };
  return has_these && !has_more;
}

/// Whether the members of R are those `before` and those listed, in this order, and no more.
template <class R, class... Before, class... Listed>
constexpr bool lists_every_member(const std::tuple<Listed...>&) {
  using Members = decltype(std::tuple_cat(std::declval<std::tuple<Before...>>(), members_of(std::declval<Listed>())...));
  return has_just<R>(std::type_identity<Members>());
}

template <class... Events>
constexpr bool list_every_member(std::type_identity<std::variant<Events...>>) {
  return (lists_every_member<Events, int>(FieldsOf<Events>::list) && ...);  // int: the iteration
}

static_assert(list_every_member(std::type_identity<gjk::Event<double>>{}));
static_assert(lists_every_member<gjk::Result<double>>(FieldsOf<gjk::Result<double>>::list));
static_assert(lists_every_member<gjk::Separation<double>>(FieldsOf<gjk::Separation<double>>::list));

struct Grown {
  int listed, forgotten;
};
static_assert(!lists_every_member<Grown>(std::tuple(Field("listed", &Grown::listed))));

// -- Schema -----------------------------------------------------------------------------------------------------------

Json definitions() { return Json::parse(trace_schema()).at("$defs"); }

/// Returns: the words that the schema allows at that key.
Words words_at(const Json& properties, const std::string& key) {
  const Json& value = properties.value(key, Json::object());
  return value.contains("const") ? Words{value["const"].get<std::string>()} : value.value("enum", Words{});
}

/// What the lists of fields say of a key.
struct Listed {
  std::string key;
  bool may_be_missing;
  std::optional<Words> words;  ///< of those that have some to choose from
};

template <class R>
std::vector<Listed> fields_of() {
  std::vector<Listed> list;
  const R record{};
  for_each_field(record, [&](const auto& field, const auto& value) {
    list.push_back({std::string(field.key), field.may_be_missing(), {}});
    if constexpr (std::is_enum_v<std::remove_cvref_t<decltype(value)>>) {
      const auto& known = words_of::all(value);
      list.back().words.emplace(known.begin(), known.end());
    }
  });
  return list;
}

/// Checks that the `objects` of the schema together have these fields, those that cannot be missing in each.
void check_same_fields(const std::vector<Json>& objects, const std::vector<Listed>& fields, const Words& besides = {}) {
  REQUIRE(!objects.empty());
  Words in_list = besides, in_schema;
  for (const Json& object : objects)
    for (const auto& [key, value] : object.at("properties").items()) in_schema.insert(key);
  for (const Listed& field : fields) {
    in_list.insert(field.key);
    INFO(field.key);
    Words words;
    bool is_required = true;
    for (const Json& object : objects) {
      is_required = is_required && object.at("required").get<Words>().count(field.key) == 1;
      if (field.words) words.merge(words_at(object.at("properties"), field.key));
    }
    CHECK(is_required != field.may_be_missing);
    if (field.words) CHECK(words == *field.words);
  }
  CHECK(in_schema == in_list);
}

template <class... Events>
void check_same_events(std::type_identity<std::variant<Events...>>) {
  std::map<std::string, std::vector<Json>> lines;
  for (const Json& each : definitions())
    for (const std::string& event : words_at(each.value("properties", Json::object()), "event"))
      lines[event].push_back(each);
  CHECK(lines.size() == sizeof...(Events));
  (check_same_fields(lines[std::string(FieldsOf<Events>::event)], fields_of<Events>(), {"scene", "iteration", "event"}),
   ...);
}

}  // namespace

TEST_CASE("The schema of traces has the fields and words of each event, and requires those that are always told") {
  check_same_events(std::type_identity<gjk::Event<double>>{});
}

TEST_CASE("The schema of traces has the fields of what events are made of") {
  const Json defs = definitions();
  check_same_fields({defs.at("support")}, fields_of<gjk::SupportPoint<double>>());
  check_same_fields({defs.at("vertex")}, fields_of<gjk::Vertex<double>>());
  check_same_fields({defs.at("finished-separated").at("properties").at("separation")},
                    fields_of<gjk::Separation<double>>());
}

TEST_CASE("The schema of traces has each shape, and the fields of those that have some") {
  const Json defs = definitions();
  Words keys;
  for_each_kind([&]<class Shape>(std::type_identity<Shape>) {
    const std::string key(ShapeRow<Shape>::key);
    keys.insert(key);
    Words fields, in_schema;
    Shape shape;
    ShapeRow<Shape>::fields(
        [&](const auto& field, const auto&) {
          if constexpr (requires { field.name; }) fields.insert(std::string(field.name));
        },
        shape);
    if (defs.contains(key))
      for (const auto& [name, value] : defs.at(key).at("properties").items()) in_schema.insert(name);
    INFO(key);
    CHECK(in_schema == fields);
  });
  Words in_schema;
  for (const auto& [name, value] : defs.at("shape").at("properties").items()) in_schema.insert(name);
  CHECK(in_schema == keys);
  CHECK(defs.at("shape").at("oneOf").size() == keys.size());
}
