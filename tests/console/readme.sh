# What the README's commands need beside them: run where they are run, before the first one.
mkdir -p build walkthroughs expected actual
ln -s "$(command -v gjkstep)" build/gjkstep
# As the true one says it, which installs and builds first, and draws all, larger.
cat >walkthroughs/run.sh <<'.'
#!/bin/sh
echo 'installing cmake g++ ninja-build libeigen3-dev'
echo 'built build'
build/gjkstep render figure-1 figure-2 figure-4-left --size 32x18
echo 'open out/index.html'
.
chmod +x walkthroughs/run.sh
picture 1280x720 255,255,255 >white.png
for i in $(seq -w 0 17); do ln white.png expected/0$i.png; ln white.png actual/0$i.png; done
rm actual/000.png
picture 1280x720 255,255,255 300x200+39+25 200,90,0 40x30+1000+600 0,0,0 >actual/000.png
# A collision test of somebody's own: whether boxes overlap, which is not enough.
cat >mine.c <<'.'
static int overlap(const double (*a)[3], int na, const double (*b)[3], int nb, int axis) {
  double low = b[0][axis], high = low;
  for (int i = 1; i < nb; ++i) {
    if (b[i][axis] < low) low = b[i][axis];
    if (b[i][axis] > high) high = b[i][axis];
  }
  int above = 1, below = 1;
  for (int i = 0; i < na; ++i) {
    above = above && a[i][axis] > high;
    below = below && a[i][axis] < low;
  }
  return !above && !below;
}
int collide(const double (*a)[3], int na, const double (*b)[3], int nb) {
  for (int axis = 0; axis < 3; ++axis)
    if (!overlap(a, na, b, nb, axis)) return 0;
  return 1;
}
.
