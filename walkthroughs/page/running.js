'use strict';
// The program itself, which runs in this page. What it is asked and what it answers is JSON; nothing here knows what it means.

const runsPrograms = () => Boolean(window.WebAssembly && window.DecompressionStream);

// `load(i)`: promises base64 of the first program, or of the one that has all searches, deflated.
// Returns: ask(request), which returns the answer, and asked(request), which promises one of the other program where the first has none.
async function programFrom(load) {
  const encoder = new TextEncoder(), decoder = new TextDecoder();
  const compiled = async i => {
    const bytes = Uint8Array.from(atob(await load(i)), letter => letter.charCodeAt(0));
    const unpacked = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate'));
    return WebAssembly.compile(await new Response(unpacked).arrayBuffer());
  };
  let module = await compiled(0), running = null, told = null;
  const memory = (from, count) => new Uint8Array(running.memory.buffer, from, count);

  // What it asks of a system: there is none. What was told last is told again.
  function start() {
    const imports = {};
    for (const {module: from, name} of WebAssembly.Module.imports(module)) (imports[from] ??= {})[name] = () => 0;
    imports.page = {thrown(at) {
      const rest = memory(at);
      throw Error(decoder.decode(rest.slice(0, rest.indexOf(0))));
    }};
    running = new WebAssembly.Instance(module, imports).exports;
    running._initialize();
    const again = told;
    told = null;
    if (again) ask(again);
  }

  // What fails there leaves it in no known state: another is started.
  function ask(request) {
    const bytes = encoder.encode(JSON.stringify(request));
    try {
      memory(running.room_for(bytes.length), bytes.length).set(bytes);
      const count = running.answer();
      const answer = JSON.parse(decoder.decode(memory(running.text(), count)));
      if (request.tell && !answer.error && !answer.more) told = request;
      return answer;
    } catch (error) {
      start();
      return {error: {line: 0, key: '', reason: error.message, text: `the program failed: ${error.message}`}};
    }
  }
  async function asked(request) {
    const answer = ask(request);
    if (!answer.more) return answer;
    module = await compiled(1);
    start();
    return ask(request);
  }
  start();
  return {ask, asked};
}
