// The program in a page answers as the same code does that is compiled for this system: each request goes to both.
//   node same_answers.mjs ANSWERS FOLDER   (ANSWERS: answers.cpp; FOLDER: of both programs for pages)
import {execFileSync} from 'node:child_process';
import fs from 'node:fs';

const [answers, folder] = process.argv.slice(2);
const encoder = new TextEncoder(), decoder = new TextDecoder();
const run = (words, input) =>
  execFileSync(answers, words, {input, maxBuffer: 1 << 30, encoding: 'utf8'}).split('\n').slice(0, -1);

function programIn(file) {
  const module = new WebAssembly.Module(fs.readFileSync(file)), imports = {};
  for (const {module: from, name} of WebAssembly.Module.imports(module)) (imports[from] ??= {})[name] = () => 0;
  let running = null;
  const memory = (from, count) => new Uint8Array(running.memory.buffer, from, count);
  imports.page = {thrown(at) { throw Error(decoder.decode(memory(at).slice(0, memory(at).indexOf(0)))); }};
  running = new WebAssembly.Instance(module, imports).exports;
  running._initialize();
  return request => {
    const bytes = encoder.encode(request);
    memory(running.room_for(bytes.length), bytes.length).set(bytes);
    const count = running.answer();
    return decoder.decode(memory(running.text(), count));
  };
}

// Sines and cosines of two libraries may differ in the last digit, one in some hundreds, and a place of a picture by a hundredth of a
// page unit then. Where more answers are only near, something else rounds otherwise.
const most_near = 10;
const number = /-?\d+(?:\.\d+)?(?:e[-+]?\d+)?/g;
function isNear(one, other) {
  if (one.replace(number, '#') !== other.replace(number, '#')) return false;
  const [ours, theirs] = [one, other].map(text => text.match(number).map(Number));
  return ours.every((x, i) => x === theirs[i] || Math.abs(x - theirs[i]) <= Math.max(0.0101, 1e-12 * Math.abs(x)));
}

const requests = run(['requests']), expected = run([], requests.join('\n') + '\n');
let failures = 0;

// Shows the first difference.
function complain(searches, request, found, here) {
  if (++failures > (process.env.ALL ?? 5)) return;
  const at = [...found].findIndex((letter, k) => letter !== here[k]);
  const around = text => text.slice(Math.max(0, at - 60), at + 100);
  console.log(`${searches}: ${request.slice(0, 300)}\n  page: …${around(found)}\n  here: …${around(here)}`);
}

// What draws is the same in both programs: of the smaller one few pictures are asked.
const isAsked = (searches, request, i) => searches === 'all' || !request.startsWith('{"draw"') || i % 8 === 0;

for (const searches of ['all', 'few']) {
  const ask = programIn(`${folder}/${searches}-searches.wasm`);
  let same = 0, near = 0, more = 0, errors = 0, isTold = true;
  requests.forEach((request, i) => {
    const isTelling = request.startsWith('{"tell"');
    if (!isAsked(searches, request, i) || !isTelling && !isTold) return;  // of a story that it did not tell
    const isLikeUntold = !isTold && request.includes('"like"');
    const found = ask(request);
    if (isTelling) isTold = found !== '{"more":true}';
    if (found.startsWith('{"error"')) ++errors;
    if (!isTold) ++more;
    else if (isLikeUntold) return;  // a step like one of a story that it did not tell
    else if (found === expected[i]) ++same;
    else if (isNear(found, expected[i])) ++near;
    else complain(searches, request, found, expected[i]);
  });
  console.log(`${searches}: ${same} the same, ${errors} of them errors; ${near} near, ${more} for the other program; ${failures} fail`);
  if (near > most_near) ++failures;
  if (searches === 'few' ? !more : more) ++failures;
}
process.exit(failures ? 1 : 0);
