/// Everything that GJK tells while it runs. A complete list of events replays, draws and checks a run without the shapes.
///
/// Text in events uses the report's letters for the simplex that is being processed, the one of the last VertexAdded:
/// A is its newest vertex, O the origin, X×Y×Z is (X×Y)×Z, and ABn, ABCn are the normals of Eqs. 10, 11 and 14.
#pragma once

#include <concepts>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "result.hpp"

namespace gjk {

template <class S>
struct SearchStarted {
  int iteration = 0;
  Vec3<S> direction;
  std::string why;
  friend bool operator==(const SearchStarted&, const SearchStarted&) = default;
};

/// Eqs. 5-8 were asked for the farthest vertex of the difference.
template <class S>
struct SupportFound {
  int iteration = 0;
  Vec3<S> direction;
  Vertex<S> vertex;
  bool is_new = true;  ///< no earlier vertex of this run lies at the same place
  friend bool operator==(const SupportFound&, const SupportFound&) = default;
};

enum class Crossing { crossed, not_crossed, first_point, switched_off };

/// Eq. 9 for the vertex just found.
template <class S>
struct CrossingTested {
  int iteration = 0;
  std::optional<S> value;  ///< w·d; empty exactly where the test was not applied
  Crossing verdict = Crossing::crossed;
  friend bool operator==(const CrossingTested&, const CrossingTested&) = default;
};

template <class S>
struct VertexAdded {
  int iteration = 0;
  Simplex<S> simplex;  ///< the vertex added is the newest
  friend bool operator==(const VertexAdded&, const VertexAdded&) = default;
};

/// What the value of a region test was compared with. A scalar is compared with 0, a vector with the zero vector.
enum class Relation { positive, negative, zero, not_zero, not_negative };

enum class Verdict { chosen, rejected, skipped, possible };

/// One region of Algorithms 2-5. `chosen` means that the value stands in `relation` to zero, `rejected` that it does not;
/// `possible` that it does and that this alone does not decide: only the complete rules (complete.hpp) say so.
/// Regions that the algorithm does not reach, because it has chosen one before, are not told.
template <class S>
struct RegionTested {
  int iteration = 0;
  int simplex_size = 0;
  std::string feature;                 ///< "A", "AB", "ABC", "ABCD", ...
  std::string label = {};              ///< the report's "R1" ... "R7", "R3 or R4"; empty where the report gives none
  std::string face = {};               ///< the face whose edge is tested (Algorithm 5); else empty
  std::string expression = {};         ///< "ABn·AO"; empty where nothing had to be computed
  std::string formula = {};            ///< how the normal in `expression` was made: "AB×ABCn"; else empty
  std::optional<Vec3<S>> normal = {};  ///< the value of `formula`
  std::variant<std::monostate, S, Vec3<S>> value = {};  ///< the value of `expression`
  Relation relation = Relation::positive;
  Verdict verdict = Verdict::skipped;
  std::string reason;  ///< skipped: why it need not be asked; else what the verdict means
  friend bool operator==(const RegionTested&, const RegionTested&) = default;
};

template <class S>
struct SimplexReduced {
  int iteration = 0;
  Simplex<S> before, after;
  std::string kept;     ///< roles in `before`, oldest first: "CA"
  std::string dropped;  ///< roles in `before`; empty where only the order changed
  std::string why;      ///< why these vertices, and why in this order
  friend bool operator==(const SimplexReduced&, const SimplexReduced&) = default;
};

template <class S>
struct DirectionChosen {
  int iteration = 0;
  std::string expression;  ///< "AO", "AB×AO×AB", "ABCn", "−ABCn"
  Vec3<S> direction;
  friend bool operator==(const DirectionChosen&, const DirectionChosen&) = default;
};

template <class S>
struct Finished {
  int iteration = 0;
  Result<S> result;
  friend bool operator==(const Finished&, const Finished&) = default;
};

template <class S>
using Event = std::variant<SearchStarted<S>, SupportFound<S>, CrossingTested<S>, VertexAdded<S>, RegionTested<S>,
                           SimplexReduced<S>, DirectionChosen<S>, Finished<S>>;

/// An observer is called with each event as it happens. Anything that takes an Event will do.
template <class T, class S>
concept Observer = std::invocable<T&, SearchStarted<S>> && std::invocable<T&, SupportFound<S>> &&
    std::invocable<T&, CrossingTested<S>> && std::invocable<T&, VertexAdded<S>> &&
    std::invocable<T&, RegionTested<S>> && std::invocable<T&, SimplexReduced<S>> &&
    std::invocable<T&, DirectionChosen<S>> && std::invocable<T&, Finished<S>>;

/// The default observer. Events meant for it are never made.
struct NobodyListens {
  template <class E>
  void operator()(const E&) const {}
};

/// The observer that keeps everything.
template <class S>
struct Trace {
  std::vector<Event<S>> events;
  template <class E>
  void operator()(E&& event) {
    events.emplace_back(std::forward<E>(event));
  }
};

}  // namespace gjk
