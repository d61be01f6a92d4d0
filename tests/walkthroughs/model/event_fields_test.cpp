#include "walkthroughs/model/event_fields.hpp"

#include "tests/kit/catch.hpp"

namespace event_fields_test {

using namespace walkthroughs::program;

namespace {

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
  using Members =
      decltype(std::tuple_cat(std::declval<std::tuple<Before...>>(), members_of(std::declval<Listed>())...));
  return has_just<R>(std::type_identity<Members>());
}

template <class... Events>
constexpr bool list_every_member(std::type_identity<std::variant<Events...>>) {
  return (lists_every_member<Events, int>(FieldsOf<Events>::list) && ...);  // int: the iteration
}

struct Grown {
  int listed, forgotten;
};

}  // namespace

TEST_CASE("The lists of fields have every member of their structs") {
  STATIC_REQUIRE(list_every_member(std::type_identity<gjk::Event<double>>{}));
  STATIC_REQUIRE(lists_every_member<gjk::Result<double>>(FieldsOf<gjk::Result<double>>::list));
  STATIC_REQUIRE(lists_every_member<gjk::Separation<double>>(FieldsOf<gjk::Separation<double>>::list));
  STATIC_REQUIRE(lists_every_member<Remark>(FieldsOf<Remark>::list));
  STATIC_REQUIRE(lists_every_member<CloseUp>(FieldsOf<CloseUp>::list));
  STATIC_REQUIRE(!lists_every_member<Grown>(std::tuple(Field("listed", &Grown::listed))));
}

}  // namespace event_fields_test
