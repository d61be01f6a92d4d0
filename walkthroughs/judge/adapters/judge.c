/* Lets `gjkstep judge` ask a collision test that is written in C99. Write this function in a file of yours:
 *
 *     int collide(const double (*a)[3], int na, const double (*b)[3], int nb);
 *
 * It gets the points of two convex hulls. It returns 1 where the hulls have a point in common, 0 where they have none.
 * It returns -1 where it cannot tell. Then:
 *
 *     cc -O2 judge.c mine.c -lm -o mine && gjkstep judge -- ./mine
 *
 * If your search calls this at the end of each iteration, its steps are judged, too:
 *
 *     void judge_step(const double searched_along[3], const double (*simplex)[3], int n);
 *
 * The simplex is the reduced one, points a - b, the newest last (or always first).
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef double Point[3];

int collide(const double (*a)[3], int na, const double (*b)[3], int nb);
void judge_step(const double searched_along[3], const double (*simplex)[3], int n);

void judge_step(const double searched_along[3], const double (*simplex)[3], int n) {
  const double* d = searched_along;
  if (getenv("JUDGE_STEPS") == NULL) return;
  printf("{\"direction\":[%.17g,%.17g,%.17g],\"simplex\":[", d[0], d[1], d[2]);
  for (int i = 0; i < n; ++i)
    printf("%s[%.17g,%.17g,%.17g]", i == 0 ? "" : ",", simplex[i][0], simplex[i][1], simplex[i][2]);
  puts("]}");
}

static void* enough(void* memory, size_t size) {
  if ((memory = realloc(memory, size)) != NULL) return memory;
  fputs("judge.c: out of memory\n", stderr);
  exit(1);
}

/* Returns: the next line without blanks, which the caller frees, or NULL at the end of the input. */
static char* read_line(void) {
  size_t length = 0, room = 256;
  char* line = enough(NULL, room);
  int c;
  while ((c = getchar()) != EOF && c != '\n') {
    if (length + 1 == room) line = enough(line, room *= 2);
    if (c != ' ' && c != '\t' && c != '\r') line[length++] = (char)c;
  }
  line[length] = '\0';
  if (c == '\n' || length > 0) return line;
  free(line);
  return NULL;
}

/* Returns: the points [[x,y,z],...] that follow `key`, *n of them, which the caller frees. */
static Point* points_after(const char* key, char* line, int* n) {
  Point* points = NULL;
  size_t room = 0;
  char* at = strstr(line, key);
  if (at == NULL) {
    fputs("judge.c: a line is no pair of sets of points\n", stderr);
    exit(2);
  }
  for (at += strlen(key), *n = 0; *at == '['; ++*n) {
    if ((size_t)*n == room) points = enough(points, (room = 2 * room + 16) * sizeof *points);
    for (int i = 0; i < 3; ++i) points[*n][i] = *at == '[' || *at == ',' ? strtod(at + 1, &at) : 0;
    if (*at == ']') ++at;
    if (*at == ',') ++at;
  }
  return points;
}

int main(void) {
  for (char* line; (line = read_line()) != NULL; free(line)) {
    int na, nb;
    Point* a = points_after("\"a\":{\"points\":[", line, &na);
    Point* b = points_after("\"b\":{\"points\":[", line, &nb);
    const int answer = collide((const Point*)a, na, (const Point*)b, nb);
    puts(answer < 0 ? "undecided" : answer ? "yes" : "no");
    fflush(stdout);
    free(a);
    free(b);
  }
  return 0;
}
