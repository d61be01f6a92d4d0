#include <gjkstep/gjk.hpp>

int main() {
  const gjk::PointSet<double> a({{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}});
  const gjk::Sphere<double> near({0, 0, 0}, 1), far({3, 3, 3}, 1);
  const bool right = gjk::collision(a, near).status == gjk::Status::intersecting &&
                     gjk::collision(a, far).status == gjk::Status::separated;
  return right ? 0 : 1;
}
