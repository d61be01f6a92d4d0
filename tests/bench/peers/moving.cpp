/// Pairs that move little from one question to the next, as engines ask: what does it save to try first what answered the last one?
///
///     build/gjkstep-moving > moving.csv    moving_report.py makes a table of it
#include "core/certified/moving.hpp"

#include <BulletCollision/CollisionShapes/btConvexHullShape.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpa2.h>
#include <fcl/geometry/shape/convex.h>
#include <fcl/narrowphase/detail/convexity_based_algorithm/gjk.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>
#include <memory>

#include "core/moving.hpp"
#include "tests/bench/peers/gjkstep_call.hpp"
#include "tests/bench/peers/match.hpp"
#include "tests/bench/peers/shapes.hpp"

namespace peers {
namespace {

constexpr std::uint64_t seed = 7474;
constexpr int frames = 1000, pairs = 12, turns = 9;

using Pose = gjk::Pose<double>;

/// B is turned around an axis, and carried to and fro through A and beyond. Each frame goes so far, in radians and in sizes of B.
std::vector<Pose> motion(study::Dice& dice, const study::Points& b, double step) {
  study::Vec middle = study::Vec::Zero();
  for (const study::Vec& p : b) middle += p / static_cast<double>(b.size());
  double size = 0;
  for (const study::Vec& p : b) size = std::max(size, (p - middle).norm());
  const study::Vec axis = dice.direction(), way = dice.direction(), aside = 0.3 * size * dice.direction();
  const double begin = dice.between(0, 6.28);
  std::vector<Pose> poses;
  for (int i = 0; i < frames; ++i) {
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(step * i, axis).toRotationMatrix();
    const study::Vec place = aside + 2.5 * size * std::sin(begin + step * i / 2.5) * way;
    poses.push_back({turn, place - turn * middle});
  }
  return poses;
}

struct Track {
  study::Points a, b;
  std::vector<Pose> poses;  ///< of b
};

/// One contender about one track. Its shapes are made before the clock starts; where B lies it is told in each frame.
using Ask = std::function<Answer(std::size_t frame)>;
struct Mover {
  std::string name, how;
  std::function<Ask(const Track&)> prepare;
  bool is_peer = false;
};

// -- gjkstep -----------------------------------------------------------------------------------------------------------

template <bool remembers>
Ask plain(const Track& track) {
  struct State {
    PointSet a;
    gjk::Posed<double, PointSet> b;
    gjk::LastFound<double> last = {};
  };
  const auto state = std::make_shared<State>(State{PointSet(track.a), {PointSet(track.b), Pose()}});
  return [state, &track](std::size_t i) {
    state->b.move_to(track.poses[i]);
    if constexpr (remembers) return answer_of(gjk::collision(state->a, state->b, state->last).status);
    return answer_of(gjk::collision(state->a, state->b).status);
  };
}

/// Of points, which are moved before they are asked about; that counts.
template <bool remembers>
Ask certified(const Track& track) {
  const auto a = std::make_shared<PointSet>(track.a);
  const auto last = std::make_shared<gjk::LastFound<double>>();
  return [a, last, &track](std::size_t i) {
    study::Points points;
    points.reserve(track.b.size());
    for (const study::Vec& p : track.b) points.push_back(track.poses[i](p));
    const PointSet b(std::move(points));
    if constexpr (remembers) return answer_of(gjk::certified_collision(*a, b, *last).status);
    return answer_of(gjk::certified_collision(*a, b).status);
  };
}

// -- FCL ---------------------------------------------------------------------------------------------------------------

using Convex = fcl::Convex<double>;

/// As in GJKSolver_indep::shapeIntersect, with and without enable_cached_guess.
template <bool remembers>
Ask fcl_gjk(const Track& track) {
  const auto convex = [](const study::Points& points) {
    return Convex(std::make_shared<const std::vector<study::Vec>>(points), 0, std::make_shared<std::vector<int>>());
  };
  struct State {
    Convex a, b;
    study::Vec guess = {1, 0, 0};
  };
  const auto state = std::make_shared<State>(State{convex(track.a), convex(track.b)});
  return [state, &track](std::size_t i) {
    fcl::detail::MinkowskiDiff<double> difference;
    difference.shapes[0] = &state->a;
    difference.shapes[1] = &state->b;
    fcl::Transform3<double> place = fcl::Transform3<double>::Identity();
    place.linear() = track.poses[i].rotation;
    place.translation() = track.poses[i].translation;
    difference.toshape1.noalias() = place.linear().transpose();
    difference.toshape0 = place;
    fcl::detail::GJK<double> gjk(128, fcl::constants<double>::gjk_default_tolerance());
    const auto status = gjk.evaluate(difference, remembers ? study::Vec(-state->guess) : study::Vec(-1, 0, 0));
    if (remembers) state->guess = gjk.getGuessFromSimplex();
    using Gjk = fcl::detail::GJK<double>;
    return status == Gjk::Inside ? Answer::intersecting : status == Gjk::Valid ? Answer::separated : Answer::undecided;
  };
}

// -- Bullet ------------------------------------------------------------------------------------------------------------

/// GJK alone, with and without the normal of the frame before as its guess.
template <bool remembers>
Ask bullet_gjk(const Track& track) {
  const auto hull = [](const study::Points& points) {
    auto made = std::make_unique<btConvexHullShape>();
    for (const study::Vec& p : points) made->addPoint({p.x(), p.y(), p.z()}, false);
    made->recalcLocalAabb();
    made->setMargin(0);
    return made;
  };
  struct State {
    std::unique_ptr<btConvexHullShape> a, b;
    btVector3 guess = {1, 0, 0};
  };
  const auto state = std::make_shared<State>(State{hull(track.a), hull(track.b)});
  return [state, &track](std::size_t i) {
    const auto& [m, t] = track.poses[i];
    const btTransform place(
        btMatrix3x3(m(0, 0), m(0, 1), m(0, 2), m(1, 0), m(1, 1), m(1, 2), m(2, 0), m(2, 1), m(2, 2)),
        {t.x(), t.y(), t.z()});
    btGjkEpaSolver2::sResults results;
    const bool apart = btGjkEpaSolver2::Distance(state->a.get(), btTransform::getIdentity(), state->b.get(), place,
                                                 remembers ? state->guess : btVector3(1, 0, 0), results);
    if (remembers && apart && results.normal.length2() > 0) state->guess = results.normal;
    if (apart) return results.distance > 0 ? Answer::separated : Answer::intersecting;
    return results.status == btGjkEpaSolver2::sResults::Penetrating ? Answer::intersecting : Answer::undecided;
  };
}

std::vector<Mover> movers() {
  const std::string fcl = "FCL " GJKSTEP_FCL_VERSION ", `detail::GJK::evaluate` as `GJKSolver_indep` calls it",
                    bullet = "Bullet " GJKSTEP_BULLET_VERSION " in double, `btGjkEpaSolver2::Distance`";
  return {
      {"gjkstep", "`gjk::collision(a, b)`, B a `gjk::Posed`", plain<false>},
      {"gjkstep, last found", "`gjk::collision(a, b, last)`", plain<true>},
      {"certified", "`gjk::certified_collision(a, b)`, the points of B moved before; that counts", certified<false>},
      {"certified, last found", "`gjk::certified_collision(a, b, last)`, the points moved before", certified<true>},
      {"FCL GJK", fcl, fcl_gjk<false>, true},
      {"FCL GJK, cached guess", fcl + " with `enable_cached_guess`", fcl_gjk<true>, true},
      {"Bullet GJK", bullet + ", guess +x", bullet_gjk<false>, true},
      {"Bullet GJK, last normal", bullet + ", its last normal as the guess", bullet_gjk<true>, true}};
}

// -- The race ----------------------------------------------------------------------------------------------------------

/// Of one mover.
struct Race {
  std::vector<double> nanoseconds = {};  ///< a query, one of each turn
  std::size_t otherwise = 0;             ///< answers that are not the certified one
};

std::vector<Track> tracks_of(const study::Family& family, double step) {
  std::vector<Track> tracks;
  for (std::uint64_t i = 0; i < pairs; ++i) {
    const study::Pair pair = family.make(seed, i);
    study::Dice dice(seed, family.name + " moves", i);
    const auto &a = std::get<study::Points>(pair.a), &b = std::get<study::Points>(pair.b);
    study::Points centered = a;
    for (study::Vec& p : centered) p -= center(pair.a);
    tracks.push_back({std::move(centered), b, motion(dice, b, step)});
  }
  return tracks;
}

/// Answers first: all of them are compared before anything is timed.
void play(const study::Family& family, const std::string& pace, double step) {
  const std::vector<Track> tracks = tracks_of(family, step);
  const std::vector<Mover> all = movers();
  std::vector<Race> scores(all.size());
  std::size_t together = 0;
  for (const Track& track : tracks) {
    std::vector<Answer> truth;
    for (std::size_t m = 2; m < 2 + all.size(); ++m) {  // the certified one first
      const Ask ask = all[m % all.size()].prepare(track);
      for (std::size_t i = 0; i < track.poses.size(); ++i) {
        const Answer answer = ask(i);
        if (m == 2) truth.push_back(answer);
        scores[m % all.size()].otherwise += answer != truth[i];
      }
    }
    together += static_cast<std::size_t>(std::ranges::count(truth, Answer::intersecting));
  }
  volatile int used = 0;
  for (int turn = 0; turn < turns; ++turn)
    for (std::size_t m = 0; m < all.size(); ++m) {
      double spent = 0;
      for (const Track& track : tracks) {
        const Ask ask = all[m].prepare(track);
        const double start = processor_time();
        for (std::size_t i = 0; i < track.poses.size(); ++i) used = used + static_cast<int>(ask(i));
        spent += processor_time() - start;
      }
      scores[m].nanoseconds.push_back(spent / (pairs * frames));
    }
  for (std::size_t m = 0; m < all.size(); ++m)
    std::cout << family.name << ',' << pace << ',' << step << ',' << together << ",\"" << all[m].name << "\","
              << all[m].is_peer << ',' << median(scores[m].nanoseconds) << ',' << scores[m].otherwise << '\n';
}

}  // namespace

int run() {
  std::cout << "# made by: `build/gjkstep-moving`\n# seed " << seed << "; of each family " << pairs << " pairs, "
            << frames << " frames each; turns: " << turns << "\n# compiler: " << GJKSTEP_COMPILER << ", flags `"
            << GJKSTEP_FLAGS << "` (the peers' own code as Debian compiled it)\n";
  for (const Mover& mover : movers()) std::cout << "# " << mover.name << ": " << mover.how << '\n';
  std::cout << "family,pace,step,together,contender,is_peer,ns,otherwise\n";
  for (const study::Family& family : everyday_families()) {
    play(family, "slow", 0.002);
    play(family, "fast", 0.1);
  }
  return std::cout.flush() ? 0 : 1;
}

}  // namespace peers

int main() try { return peers::run(); } catch (const std::exception& error) {
  std::cerr << "gjkstep-moving: " << error.what() << '\n';
  return 1;
}
