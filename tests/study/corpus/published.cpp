#include "tests/study/corpus/published.hpp"

namespace study {
namespace {

const char* const github = "https://github.com/";

NamedPair published(const std::string& name, const std::string& thread, Points a, Points b) {
  return {name, "published", {std::move(a), std::move(b)}, github + thread};
}

/// A box along the axes.
Points box(const Vec& center, const Vec& size) {
  Points corners;
  for (unsigned i = 0; i < 8; ++i)
    corners.push_back(center +
                      0.5 * size.cwiseProduct(Vec(i & 1 ? 1.0 : -1.0, i & 2 ? 1.0 : -1.0, i & 4 ? 1.0 : -1.0)));
  return corners;
}

/// Turned and moved by a matrix of three rows, its corners rounded.
struct Pose {
  Vec x, y, z;  ///< rows
  Vec by;

  Points operator()(Points points) const {
    for (Vec& p : points) p = Vec(x.dot(p), y.dot(p), z.dot(p)) + by;
    return points;
  }
};

Points cube_of_fcl_493(const Vec& by) {
  const double size = 0.25;
  return Pose{{0.94096063217417758029, 0.29296840037289501035, 0.16959541586174811667},
              {-0.23569836841299879326, 0.92661523595848427348, -0.29296840037289506586},
              {-0.2429801799032638987, 0.23569836841299884878, 0.94096063217417758029},
              by}(box(Vec::Zero(), {size, size, size}));
}

std::vector<NamedPair> of_planar_triangles() {
  const std::string thread = "kroitor/gjk.c/";
  return {published("gjk.c-5", thread + "pull/5",
                    {{4.000009, 11.000008, 0}, {5.000006, 4.999989, 0}, {9.000001, 8.999997, 0}},
                    {{4.000003, 11.000010, 0}, {4.999989, 4.999999, 0}, {8.999997, 8.999998, 0}}),
          published("gjk.c-6-first", thread + "issues/6",
                    {{4.000010, 11.000005, 0}, {4.999991, 4.999999, 0}, {8.999989, 8.999995, 0}},
                    {{3.999999, 10.999990, 0}, {5.000005, 4.999998, 0}, {9.000001, 8.999989, 0}}),
          published("gjk.c-6-second", thread + "issues/6",
                    {{3.999993, 11.000011, 0}, {4.999998, 5.000003, 0}, {8.999994, 9.000011, 0}},
                    {{3.999994, 10.999999, 0}, {5.000001, 4.999989, 0}, {9.000001, 9.000003, 0}})};
}

std::vector<NamedPair> of_boxes() {
  const Points fcl_399_a = Pose{{-0.099432387353076273628, 0.99504432079443971837, 0},
                                {-0.99504432079443971837, -0.099432387353076273628, 0},
                                {0, 0, 1},
                                {0.29526406526565551758, -0.013230856508016586304, 0}}(
      box(Vec::Zero(), {0.23768037557601928711, 0.15702305734157562256, 0.25}));
  const Points fcl_399_b = Pose{{0.99506598442099225554, 0.099215354901756730444, 0},
                                {-0.099215354901756730444, 0.99506598442099225554, 0},
                                {0, 0, 1},
                                {0.22759585694545214629, 0.14974093549228112421, 0}}(
      box(Vec::Zero(), {0.010000000000000000208, 0.78165709972381591797, 0.25}));
  const std::string fcl = "flexible-collision-library/fcl/issues/";
  return {
      published("libccd-25", "danfis/libccd/issues/25", box({0, 0, 0}, {2, 2, 2}), box({0, 0, 1.9}, {2, 2, 2})),
      published("fcl-399", fcl + "399", fcl_399_a, fcl_399_b),
      published("fcl-493", fcl + "493",
                cube_of_fcl_493({0.073242100093223821977, 0.2316538089896212349, 1.3089245921032497399}),
                cube_of_fcl_493({0, 0, 1.25})),
      published("fcl-508", fcl + "508", box({0, 4, 0}, {1, 1, 1}), box({0, 0, 0}, {1, 1, 1})),
      published("parry-315", "dimforge/parry/issues/315", box({0.5, 0.5, 0.5}, {1, 1, 1}),
                box({1.5, 0.5, 0.5}, {1, 1, 1})),
  };
}

/// Of -77.5 … -68.75 by -35 … -31.8914 by 54.6073 … 55.
Points box_of_meshes_809() {
  Points corners;
  for (unsigned i = 0; i < 8; ++i)
    corners.emplace_back(i & 1 ? -68.75 : -77.5, i & 2 ? -31.8914 : -35.0, i & 4 ? 55.0 : 54.6073);
  return corners;
}

}  // namespace

std::vector<NamedPair> published_failures() {
  std::vector<NamedPair> all = of_planar_triangles();
  for (NamedPair& each : of_boxes()) all.push_back(std::move(each));
  all.push_back(published("meshes.jl-809", "JuliaGeometry/Meshes.jl/issues/809",
                          {{-60, -35, 55}, {-68.75, -33.43333, 54.90143}, {-68.75, -35, 55}}, box_of_meshes_809()));
  all.push_back(published(
      "opengjk-3", "MattiaMontanari/openGJK/issues/3",
      {{0.795121, -0.727851, 0}, {-0.178424, -0.989183, 0}, {-0.412644, -0.770664, 0}, {0.566564, 0.548772, 0}},
      {{-0.211223, -0.511346, 0}, {-0.347973, 0.45872, 0}, {0.277308, 0.969689, 0}}));
  all.push_back(published("dolfinx-3653", "FEniCS/dolfinx/issues/3653", {{44.2919, 39.7508, 18.8208}},
                          {{46.0659, 38.6251, 16.3637},
                           {44.2764, 42.3867, 18.239},
                           {50.0397, 38.4649, 19.9843},
                           {47.1963, 40.4563, 19.1057},
                           {48.0266, 38.5593, 18.2475},
                           {45.1735, 40.495, 17.3336},
                           {48.0415, 40.4456, 18.1963}}));
  all.push_back(published("distance3d-27", "AlexanderFabisch/distance3d/issues/27",
                          {{1.9408982677575293, 1.7555630101186028, 0.18558370457138618},
                           {0.8325772811802072, 0.07348739881751665, 1.7363835855830982},
                           {0.4647979626331866, 0.7802364656205514, 0.7683352436509485},
                           {1.8147849498111688, 0.1710650007346617, 1.802196858095821},
                           {0.05742372721610556, 1.6599005060005285, 0.014474511746654706},
                           {1.5270861966500002, 0.4945624540164677, 0.7162419894551117}},
                          {{0.13746727993941066, 0.20129636190312772, 0.34482818309629215},
                           {0.5315223185064999, 0.859293459032485, 0.6275795914219559},
                           {0.5810087058274663, 0.42871589938255994, 0.6201313431197037},
                           {0.48395328848552066, 0.35710287272501984, 0.27586601014041534},
                           {0.1586377710691551, 0.6421620047252284, 0.6487788989727401},
                           {0.5185197562895357, 0.058044153658207476, 0.4020269780737239}}));
  return all;
}

}  // namespace study
