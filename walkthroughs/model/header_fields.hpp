/// What the first line of a trace holds: the scenes, and how they are presented, listed as events are (event_fields.hpp).
#pragma once

#include "walkthroughs/model/event_fields.hpp"
#include "walkthroughs/model/walkthrough.hpp"

namespace walkthroughs::model {

/// A field that is there, and this word, exactly where its member is true.
template <class R>
struct Word : Told<Word<R>> {
  constexpr Word(std::string_view key, std::string_view word, bool R::*member)
      : Told<Word>{key, true}, word(word), member(member) {}
  std::string_view word;
  bool R::*member;
};

template <>
struct FieldsOf<Pose> {
  using R = Pose;
  static constexpr std::tuple list{Field("rotation", &R::rotation), Field("translation", &R::translation)};
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
                                   Field("mistake", &R::mistake).where_not_empty()};
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

}  // namespace walkthroughs::model
