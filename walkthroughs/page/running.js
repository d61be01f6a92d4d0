'use strict';
// The program itself, which runs in this page. What it is asked and what it answers is JSON; nothing here knows what it means.

const runsPrograms = () => Boolean(window.WebAssembly && window.DecompressionStream);

// Returns: ask(request), which returns the answer. `packed`: base64 of the program, deflated.
async function programFrom(packed) {
  const unpacked = bytes => new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate')));
  const bytes = Uint8Array.from(atob(packed), letter => letter.charCodeAt(0));
  const module = await WebAssembly.compile(await unpacked(bytes).arrayBuffer());
  const encoder = new TextEncoder(), decoder = new TextDecoder();
  let running = null;
  const memory = (from, count) => new Uint8Array(running.memory.buffer, from, count);

  // What it asks of a system: there is none.
  function start() {
    const imports = {};
    for (const {module: from, name} of WebAssembly.Module.imports(module)) (imports[from] ??= {})[name] = () => 0;
    imports.page = {thrown(at) {
      const rest = memory(at);
      throw Error(decoder.decode(rest.slice(0, rest.indexOf(0))));
    }};
    running = new WebAssembly.Instance(module, imports).exports;
    running._initialize();
  }

  // What fails there leaves it in no known state: another is started, and asked again for what the last one was told.
  let told = null;
  function ask(request) {
    const bytes = encoder.encode(JSON.stringify(request));
    try {
      memory(running.room_for(bytes.length), bytes.length).set(bytes);
      const count = running.answer();
      const answer = JSON.parse(decoder.decode(memory(running.text(), count)));
      if (request.tell && !answer.error) told = request;
      return answer;
    } catch (error) {
      start();
      if (told && request !== told) ask(told);
      return {error: {line: 0, key: '', reason: error.message, text: `the program failed: ${error.message}`}};
    }
  }
  start();
  return ask;
}
