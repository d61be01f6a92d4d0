// Lets `gjkstep judge` ask a collision test that is written in JavaScript. Write it in a file of yours, say mine.mjs:
//
//     export function collide(a, b) { ... }
//
// It gets the points [x, y, z] of two convex hulls. It returns true where the hulls have a point in common, else false.
// It returns null where it cannot tell. It may return the distance instead, as a number: 0 where they meet. Then:
//
//     gjkstep judge -- node judge.mjs ./mine.mjs
//
// If your search calls judgeStep(searchedAlong, simplex) at the end of each iteration, its steps are judged, too. The
// simplex is the reduced one, points a - b, the newest last (or always first).
import { resolve } from "node:path";
import { createInterface } from "node:readline";
import { pathToFileURL } from "node:url";

globalThis.judgeStep = (direction, simplex) => {
  if ("JUDGE_STEPS" in process.env) process.stdout.write(JSON.stringify({ direction, simplex }) + "\n");
};

function pointsOf(shape) {
  if (!shape.points) {
    console.error("judge.mjs: a line is no pair of sets of points");
    process.exit(2);
  }
  return shape.points.map(([x, y, z = 0]) => [x, y, z]);  // a point [x, y] means [x, y, 0]
}

function inWords(answer) {
  if (answer === null) return "undecided";
  if (typeof answer === "boolean") return answer ? "yes" : "no";
  return typeof answer === "number" ? `distance ${answer}` : String(answer);  // what is no answer is shown as it is
}

if (process.argv.length !== 3) {
  console.error("usage: node judge.mjs FILE");
  process.exit(1);
}
const { collide } = await import(pathToFileURL(resolve(process.argv[2])));

for await (const line of createInterface({ input: process.stdin })) {
  const { a, b } = JSON.parse(line);
  process.stdout.write(inWords(await collide(pointsOf(a), pointsOf(b))) + "\n");
}
