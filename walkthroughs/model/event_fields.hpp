/// What each event holds, listed once: the keys that its fields have in a trace, in their order, and where they are. And so what
/// the first line of a trace holds: the scenes, and how they are presented.
/// Writer, reader, schema and widening visit these lists. A field or an event that is added is added to its struct and here.
///
/// Every event also has its `iteration`, which no list names.
#pragma once

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <variant>

#include "core/event_words.hpp"
#include "walkthroughs/model/walkthrough.hpp"

namespace walkthroughs::model {

/// What a text, a whole number or a vector says, where its type does not tell.
enum class Meaning { plain, name, title, sentence, direction, simplex_size, iterations, position, sign, power, limit };

/// What is said of every field F.
template <class F>
struct Told {
  std::string_view key;
  bool is_left_out_where_empty = false;
  std::string_view beside = {};  ///< the key that this one belongs with; empty: it stands alone

  constexpr bool may_be_missing() const { return is_left_out_where_empty || !beside.empty(); }

  /// Returns: the same field, which is told only where there is something in it.
  constexpr F where_not_empty() const {
    F field = static_cast<const F&>(*this);
    field.is_left_out_where_empty = true;
    return field;
  }
  /// Returns: the same field, which is told exactly where `other`, which comes before it, is told.
  constexpr F only_beside(std::string_view other) const {
    F field = static_cast<const F&>(*this);
    field.beside = other;
    return field;
  }
};

/// One field of a record R.
template <class R, class T>
struct Field : Told<Field<R, T>> {
  constexpr Field(std::string_view key, T R::*member, Meaning meaning = Meaning::plain)
      : Told<Field>{key}, member(member), meaning(meaning) {}
  T R::*member;
  Meaning meaning;
};

/// A field that is told in words: those that `say` makes of its member and of the fields before it.
template <class R, class T>
struct Spoken : Told<Spoken<R, T>> {
  constexpr Spoken(std::string_view key, T R::*member, std::string (*say)(const R&))
      : Told<Spoken>{key}, member(member), say(say) {}
  T R::*member;
  std::string (*say)(const R&);
};

/// What is told, too, though it follows from the other fields.
template <class R>
struct Derived : Told<Derived<R>> {
  constexpr Derived(std::string_view key, std::string (*say)(const R&)) : Told<Derived>{key}, say(say) {}
  std::string (*say)(const R&);
};

/// A field that is there, and this word, exactly where its member is true.
template <class R>
struct Word : Told<Word<R>> {
  constexpr Word(std::string_view key, std::string_view word, bool R::*member)
      : Told<Word>{key, true}, word(word), member(member) {}
  std::string_view word;
  bool R::*member;
};

/// A record whose fields stand among those of R, without a key of its own.
template <class R, class T>
struct Inlined {
  explicit constexpr Inlined(T R::*member) : member(member) {}
  T R::*member;
};

// -- Events -----------------------------------------------------------------------------------------------------------

/// `list`: the fields of a record. `event`: its name, where the record is an event.
template <class R>
struct FieldsOf;

template <class R>
concept Record = requires {
  FieldsOf<R>::list;
};

template <class S>
struct FieldsOf<gjk::SupportPoint<S>> {
  using R = gjk::SupportPoint<S>;
  static constexpr std::tuple list{Field("point", &R::point),
                                   Field("index", &R::index, Meaning::position).where_not_empty()};
};

template <class S>
struct FieldsOf<gjk::Vertex<S>> {
  using R = gjk::Vertex<S>;
  static constexpr std::tuple list{Field("w", &R::w), Field("a", &R::a), Field("b", &R::b)};
};

template <class S>
struct FieldsOf<gjk::Separation<S>> {
  using R = gjk::Separation<S>;
  static constexpr std::tuple list{Field("direction", &R::direction), Field("vertex", &R::vertex),
                                   Field("support_value", &R::support_value)};
};

template <class S>
struct FieldsOf<gjk::Result<S>> {
  using R = gjk::Result<S>;
  static constexpr std::tuple list{Field("status", &R::status),
                                   Field("reason", &R::reason),
                                   Field("iterations", &R::iterations, Meaning::iterations),
                                   Field("simplex", &R::simplex),
                                   Field("separation", &R::separation).where_not_empty(),
                                   Field("cycle_start", &R::cycle_start, Meaning::iterations).where_not_empty()};
};

template <class S>
struct FieldsOf<gjk::SearchStarted<S>> {
  using R = gjk::SearchStarted<S>;
  static constexpr std::string_view event = "search-started";
  static constexpr std::tuple list{Field("direction", &R::direction),
                                   Spoken(
                                       "why", &R::why, +[](const R& e) { return std::string(gjk::to_string(e.why)); })};
};

template <class S>
struct FieldsOf<gjk::SupportFound<S>> {
  using R = gjk::SupportFound<S>;
  static constexpr std::string_view event = "support-found";
  static constexpr std::tuple list{Field("direction", &R::direction), Inlined(&R::vertex), Field("new", &R::is_new)};
};

template <class S>
struct FieldsOf<gjk::CrossingTested<S>> {
  using R = gjk::CrossingTested<S>;
  static constexpr std::string_view event = "crossing-tested";
  static constexpr std::tuple list{Field("value", &R::value).where_not_empty(), Field("verdict", &R::verdict)};
};

template <class S>
struct FieldsOf<gjk::VertexAdded<S>> {
  using R = gjk::VertexAdded<S>;
  static constexpr std::string_view event = "vertex-added";
  static constexpr std::tuple list{Field("simplex", &R::simplex)};
};

template <class S>
struct FieldsOf<gjk::RegionTested<S>> {
  using R = gjk::RegionTested<S>;
  static constexpr std::string_view event = "region-tested";
  static constexpr std::tuple list{
      Field("simplex_size", &R::simplex_size, Meaning::simplex_size),
      Field("feature", &R::feature),
      Derived<R>("region", [](const R& e) { return std::string(to_string(label_of(e))); }).where_not_empty(),
      Field("face", &R::face).where_not_empty(),
      Field("expression", &R::expression).where_not_empty(),
      Field("formula", &R::formula).where_not_empty(),
      Field("normal", &R::normal).only_beside("formula"),
      Field("value", &R::value).only_beside("expression"),
      Field("relation", &R::relation).only_beside("expression"),
      Field("verdict", &R::verdict),
      Spoken(
          "reason", &R::reason, +[](const R& e) { return reason_in_words(e); })};
};

template <class S>
struct FieldsOf<gjk::SimplexReduced<S>> {
  using R = gjk::SimplexReduced<S>;
  static constexpr std::string_view event = "simplex-reduced";
  static constexpr std::tuple list{Field("before", &R::before), Field("after", &R::after), Field("kept", &R::kept),
                                   Derived<R>("dropped", [](const R& e) { return to_string(e.dropped()); }),
                                   Spoken(
                                       "why", &R::why, +[](const R& e) { return std::string(gjk::to_string(e.why)); })};
};

template <class S>
struct FieldsOf<gjk::DirectionChosen<S>> {
  using R = gjk::DirectionChosen<S>;
  static constexpr std::string_view event = "direction-chosen";
  static constexpr std::tuple list{Field("expression", &R::expression), Field("direction", &R::direction)};
};

template <class S>
struct FieldsOf<gjk::Finished<S>> {
  using R = gjk::Finished<S>;
  static constexpr std::string_view event = "finished";
  static constexpr std::tuple list{Inlined(&R::result)};
};

template <>
struct FieldsOf<gjk::FilterValue> {
  using R = gjk::FilterValue;
  static constexpr std::tuple list{Field("expression", &R::expression), Field("value", &R::value)};
};

template <class S>
struct FieldsOf<gjk::FilterTried<S>> {
  using R = gjk::FilterTried<S>;
  static constexpr std::string_view event = "proof-tried";
  static constexpr std::tuple list{Field("proof", &R::proof), Field("numbers", &R::numbers), Field("bound", &R::bound),
                                   Field("holds", &R::holds)};
};

template <class S>
struct FieldsOf<gjk::SignTaken<S>> {
  using R = gjk::SignTaken<S>;
  static constexpr std::string_view event = "sign-taken";
  static constexpr std::tuple list{Field("expression", &R::expression),
                                   Spoken(
                                       "formula", &R::face, +[](const R& e) { return formula_of(e); })
                                       .where_not_empty(),
                                   Field("vertex", &R::vertex).where_not_empty(),
                                   Field("value", &R::value),
                                   Field("error", &R::error),
                                   Field("power", &R::power, Meaning::power).where_not_empty(),
                                   Field("exact", &R::exact).where_not_empty(),
                                   Field("sign", &R::sign, Meaning::sign)};
};

template <class S>
struct FieldsOf<gjk::FeatureKept<S>> {
  using R = gjk::FeatureKept<S>;
  static constexpr std::string_view event = "feature-kept";
  static constexpr std::tuple list{Field("before", &R::before), Field("after", &R::after), Field("kept", &R::kept),
                                   Derived<R>("dropped", [](const R& e) { return to_string(e.dropped()); }),
                                   Field("contains_origin", &R::contains_origin)};
};

template <>
struct FieldsOf<gjk::CertifiedResult> {
  using R = gjk::CertifiedResult;
  static constexpr std::tuple list{Field("status", &R::status), Field("certificate", &R::certificate),
                                   Field("proof", &R::proof), Field("iterations", &R::iterations, Meaning::iterations),
                                   Field("second_iterations", &R::fallback_iterations, Meaning::iterations)};
};

template <class S>
struct FieldsOf<gjk::Certified<S>> {
  using R = gjk::Certified<S>;
  static constexpr std::string_view event = "certified";
  static constexpr std::tuple list{Inlined(&R::result)};
};

// -- The first line ---------------------------------------------------------------------------------------------------

template <>
struct FieldsOf<gjk::Quaternion> {
  using R = gjk::Quaternion;
  static constexpr std::tuple list{Field("w", &R::w), Field("x", &R::x), Field("y", &R::y), Field("z", &R::z)};
};

template <>
struct FieldsOf<Pose> {
  using R = Pose;
  static constexpr std::tuple list{Field("rotation", &R::rotation), Field("translation", &R::translation),
                                   Field("quaternion", &R::quaternion).where_not_empty(),
                                   Word("matrix", "as_written", &R::matrix_as_written)};
};

template <>
struct FieldsOf<gjk::Options<double>> {
  using R = gjk::Options<double>;
  static constexpr std::tuple list{Field("first_direction", &R::first_direction, Meaning::direction),
                                   Field("iteration_limit", &R::iteration_limit, Meaning::limit),
                                   Field("crossing_test", &R::crossing_test)};
};

template <>
struct FieldsOf<Scene> {
  using R = Scene;
  static constexpr std::tuple list{Field("name", &R::name, Meaning::name),
                                   Field("dimension", &R::dimension),
                                   Field("a", &R::a),
                                   Field("b", &R::b),
                                   Inlined(&R::options),
                                   Field("rules", &R::rules),
                                   Field("zero_test", &R::zero_test).where_not_empty(),
                                   Field("scalar", &R::scalar).where_not_empty(),
                                   Field("certified", &R::certified).where_not_empty(),
                                   Field("mistake", &R::mistake).where_not_empty(),
                                   Field("a_as_read", &R::a_as_read).where_not_empty(),
                                   Field("b_as_read", &R::b_as_read).where_not_empty(),
                                   Word("truth", "left-out", &R::leaves_truth_out)};
};

template <>
struct FieldsOf<Remark> {
  using R = Remark;
  static constexpr std::tuple list{Field("at", &R::at),
                                   Field("iteration", &R::iteration, Meaning::iterations),
                                   Field("text", &R::text, Meaning::sentence),
                                   Field("only_for", &R::only_for, Meaning::sentence).where_not_empty(),
                                   Field("fact", &R::fact, Meaning::sentence).where_not_empty(),
                                   Field("contradicts", &R::contradicts).where_not_empty()};
};

template <>
struct FieldsOf<CloseUp> {
  using R = CloseUp;
  static constexpr std::tuple list{
      Field("iteration", &R::iteration, Meaning::iterations), Field("direction", &R::direction, Meaning::sentence),
      Field("support", &R::support, Meaning::sentence), Field("crossing", &R::crossing, Meaning::sentence)};
};

/// How it is presented; its name and scenes stand beside that.
template <>
struct FieldsOf<Walkthrough> {
  using R = Walkthrough;
  static constexpr std::tuple list{Field("title", &R::title, Meaning::title),
                                   Field("source", &R::source, Meaning::sentence),
                                   Field("summary", &R::summary, Meaning::sentence),
                                   Field("layout", &R::layout),
                                   Field("panels", &R::panels),
                                   Field("naming", &R::naming),
                                   Word("begins", "with-the-guess", &R::begins_with_the_guess),
                                   Field("remarks", &R::remarks).where_not_empty(),
                                   Field("close_up", &R::close_up).where_not_empty()};
};

// -- Visiting them ----------------------------------------------------------------------------------------------------

/// Calls visit(field, value) for each field of `record`, in order; for those of an inlined record in its place. Of what is told in
/// words these are the value, or of a record that can be changed the record itself.
template <class R, class Visit>
requires Record<std::remove_const_t<R>>
void for_each_field(R& record, const Visit& visit) {
  const auto visit_one = [&](const auto& field) {
    if constexpr (requires { field.say; } && std::is_const_v<R>)
      visit(field, field.say(record));
    else if constexpr (requires { field.say; })
      visit(field, record);
    else if constexpr (requires { field.key; })
      visit(field, record.*field.member);
    else
      for_each_field(record.*field.member, visit);
  };
  std::apply([&](const auto&... fields) { (visit_one(fields), ...); }, FieldsOf<std::remove_const_t<R>>::list);
}

/// Returns: whether there is nothing in the value of a field that may be missing: it is what it is without being told.
template <class T>
bool is_empty(const T& value) {
  if constexpr (requires { value.empty(); })
    return value.empty();
  else if constexpr (requires { value.has_value(); })
    return !value.has_value();
  else if constexpr (std::is_enum_v<T> || std::same_as<T, bool>)
    return value == T{};
  else
    return false;
}
template <class... Other>
bool is_empty(const std::variant<std::monostate, Other...>& value) {
  return value.index() == 0;
}

// -- All events -------------------------------------------------------------------------------------------------------

/// The names of events, in the order of gjk::Event.
inline constexpr auto event_names = []<class... Events>(std::type_identity<std::variant<Events...>>) {
  return std::array{FieldsOf<Events>::event...};
}(std::type_identity<gjk::Event<double>>{});

/// The place of an event in gjk::Event and in event_names.
template <template <class> class E>
inline constexpr auto event_index =
    static_cast<std::size_t>(std::ranges::find(event_names, FieldsOf<E<double>>::event) - event_names.begin());

}  // namespace walkthroughs::model
