/// WebAssembly's usual instructions know no pairs of doubles, which Eigen adds up on other processors: without them it sums in
/// another order, and the last bits differ. With these pairs it takes the same order everywhere. Each is two doubles, one after
/// the other. Included first in each file that is compiled for pages.
#pragma once

#define EIGEN_VECTORIZE  // else Eigen takes no pairs
#include <Eigen/Core>
#include <cmath>

namespace Eigen::internal {

struct PairOfDoubles {
  double first, second;
};

template <>
struct packet_traits<double> : default_packet_traits {
  using type = PairOfDoubles;
  using half = PairOfDoubles;
  enum { Vectorizable = 1, AlignedOnScalar = 1, size = 2, HasHalfPacket = 0, HasDiv = 1, HasSqrt = 1 };
};

template <>
struct unpacket_traits<PairOfDoubles> {
  using type = double;
  using half = PairOfDoubles;
  enum {
    size = 2,
    alignment = Aligned16,
    vectorizable = true,
    masked_load_available = false,
    masked_store_available = false
  };
};

/// What a division counts for where Eigen weighs whether to unroll a loop, as beside pairs of a processor.
template <>
struct scalar_div_cost<double, true> {
  enum { value = 8 };
};

// -- Made of doubles, and back ------------------------------------------------------------------------------------------

template <>
inline PairOfDoubles pset1<PairOfDoubles>(const double& x) {
  return {x, x};
}
template <>
inline PairOfDoubles plset<PairOfDoubles>(const double& x) {
  return {x, x + 1};
}
template <>
inline PairOfDoubles ploadu<PairOfDoubles>(const double* from) {
  return {from[0], from[1]};
}
template <>
inline PairOfDoubles pload<PairOfDoubles>(const double* from) {
  return ploadu<PairOfDoubles>(from);
}
template <>
inline PairOfDoubles ploaddup<PairOfDoubles>(const double* from) {
  return {*from, *from};
}
template <>
inline PairOfDoubles pgather<double, PairOfDoubles>(const double* from, Index stride) {
  return {from[0], from[stride]};
}
template <>
inline void pstoreu<double>(double* to, const PairOfDoubles& pair) {
  to[0] = pair.first;
  to[1] = pair.second;
}
template <>
inline void pstore<double>(double* to, const PairOfDoubles& pair) {
  pstoreu(to, pair);
}
template <>
inline void pscatter<double, PairOfDoubles>(double* to, const PairOfDoubles& pair, Index stride) {
  to[0] = pair.first;
  to[stride] = pair.second;
}
template <>
inline double pfirst<PairOfDoubles>(const PairOfDoubles& pair) {
  return pair.first;
}
template <>
inline PairOfDoubles preverse(const PairOfDoubles& pair) {
  return {pair.second, pair.first};
}

// -- Of each by itself --------------------------------------------------------------------------------------------------

template <>
inline PairOfDoubles padd<PairOfDoubles>(const PairOfDoubles& a, const PairOfDoubles& b) {
  return {a.first + b.first, a.second + b.second};
}
template <>
inline PairOfDoubles psub<PairOfDoubles>(const PairOfDoubles& a, const PairOfDoubles& b) {
  return {a.first - b.first, a.second - b.second};
}
template <>
inline PairOfDoubles pmul<PairOfDoubles>(const PairOfDoubles& a, const PairOfDoubles& b) {
  return {a.first * b.first, a.second * b.second};
}
template <>
inline PairOfDoubles pdiv<PairOfDoubles>(const PairOfDoubles& a, const PairOfDoubles& b) {
  return {a.first / b.first, a.second / b.second};
}
template <>
inline PairOfDoubles pmadd(const PairOfDoubles& a, const PairOfDoubles& b, const PairOfDoubles& c) {
  return padd(pmul(a, b), c);
}
template <>
inline PairOfDoubles pnegate(const PairOfDoubles& a) {
  return {-a.first, -a.second};
}
template <>
inline PairOfDoubles pconj(const PairOfDoubles& a) {
  return a;
}
template <>
inline PairOfDoubles pabs(const PairOfDoubles& a) {
  return {std::fabs(a.first), std::fabs(a.second)};
}
template <>
inline PairOfDoubles psqrt<PairOfDoubles>(const PairOfDoubles& a) {
  return {std::sqrt(a.first), std::sqrt(a.second)};
}
template <>
inline PairOfDoubles pmin<PairOfDoubles>(const PairOfDoubles& a, const PairOfDoubles& b) {
  return {b.first < a.first ? b.first : a.first, b.second < a.second ? b.second : a.second};
}
template <>
inline PairOfDoubles pmax<PairOfDoubles>(const PairOfDoubles& a, const PairOfDoubles& b) {
  return {b.first > a.first ? b.first : a.first, b.second > a.second ? b.second : a.second};
}

// -- Of both together ---------------------------------------------------------------------------------------------------

template <>
inline double predux<PairOfDoubles>(const PairOfDoubles& pair) {
  return pair.first + pair.second;
}
template <>
inline double predux_mul<PairOfDoubles>(const PairOfDoubles& pair) {
  return pair.first * pair.second;
}
template <>
inline double predux_min<PairOfDoubles>(const PairOfDoubles& pair) {
  return pair.first < pair.second ? pair.first : pair.second;
}
template <>
inline double predux_max<PairOfDoubles>(const PairOfDoubles& pair) {
  return pair.first > pair.second ? pair.first : pair.second;
}
inline void ptranspose(PacketBlock<PairOfDoubles, 2>& rows) { std::swap(rows.packet[0].second, rows.packet[1].first); }

}  // namespace Eigen::internal
