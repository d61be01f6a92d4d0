'use strict';
// A picture that the program draws when it is asked, what can be taken hold of in it, and what came of that: undo, files, links.

// `ask`, `asked`: of running.js. `told`: the answer to its first request. `host`: {frame() that is shown, changed(told) when another story
// is told, say(text) aloud, looks() what the program is to be told of text and theme, live: the first request}.
function stageOf({ask, asked}, told, host) {
  const stage = $('stage'), isInSpace = () => told.in_space, still = {turn: 0, rise: 0, zoom: 1};
  // What is shown: a scene, or where it is none that can be changed {request} by which it is told.
  let original = told.scene ?? {request: host.live}, ownFile = host.file;
  let view = {...still}, scene = original, past = [], future = [], shown = null, asking = null;
  // Keys in any order say the same.
  const sorted = value => Array.isArray(value) || !value || typeof value !== 'object' ? value
    : Object.fromEntries(Object.keys(value).sort().map(key => [key, sorted(value[key])]));
  const isSame = (one, other) => JSON.stringify(sorted(one)) === JSON.stringify(sorted(other));

  // -- The picture ----------------------------------------------------------------------------------------------------

  // Pictures are as high as there is room for, and on a narrow screen have larger letters.
  const narrow = matchMedia('(max-width: 899px), (max-height: 560px)'), stacks = matchMedia('(max-width: 640px)');
  const isStacked = () => stacks.matches && Boolean(told.story.frames.find(Boolean).iterations);  // diagrams are not
  let height = 448;
  function heightFor({width, height: now, objects}) {
    const page = now - height, box = $('fit');  // what is around panels, and where all of it stands
    const wanted = isStacked() ? 1.3 * width : narrow.matches ? width / (objects ? 2 : 1) : objects ? 0 : width * box.clientHeight / Math.max(1, box.clientWidth);
    return Math.round(Math.max(400, Math.min(900, (wanted || 448) - page)));
  }
  const drawn = i => ask({draw: {frame: i, height, ...view, ...host.looks(), ...asking ? {asks: asking.what} : {}, ...isStacked() ? {stacked: true, text: 1.2} : narrow.matches ? {text: 1.5} : {}}});
  function draw() {
    shown = drawn(host.frame());
    const fitting = drag ? height : heightFor(shown);  // which asks for a layout
    if (Math.abs(fitting - height) > 8) {
      height = fitting;
      shown = drawn(host.frame());
    }
    const {objects} = shown;
    fill($('picture'), shown);
    fillAims(shown);
    $('objects').hidden = !objects;
    if (objects) fill($('objects'), objects);
    const aspect = shown.width / shown.height, isWide = Boolean(objects) && aspect > 2.2;  // then the objects stand below, else beside
    $('fit').classList.toggle('column', isWide);
    $('fit').style.setProperty('--total', aspect + (objects && !isWide ? objects.width / objects.height + .02 : 0));
  }

  // Letters, lines and areas come as one text, which the program has written; grips lie over them.
  function fill(box, {picture, width, height, grips}) {
    box.querySelector('.drawn').replaceChildren(elementOf(picture));
    box.style.setProperty('--aspect', width / height);
    box.style.setProperty('--units', width);
    const focused = document.activeElement?.closest?.('.grip')?.dataset.name;
    const handles = box.querySelector('.grips'), old = new Map([...handles.children].map(each => [each.dataset.name, each]));
    for (const grip of grips) {
      const handle = old.get(grip.name) ?? handles.appendChild(make('button', {type: 'button', className: 'grip'}));
      old.delete(grip.name);
      handle.dataset.name ??= grip.name;
      handle.classList.toggle('whole', grip.paths.length > 1 || !grip.name.includes('.'));
      set(handle, {ariaLabel: `${grip.says}: ${valueOf(grip)}`, title: grip.says});
      const [left, top] = [grip.at[0] / width, grip.at[1] / height].map(share => `${100 * share}%`);
      if (handle.place !== left + top) Object.assign(handle.style, {left, top});
      Object.assign(handle, {grip, place: left + top});
    }
    for (const handle of old.values()) handle.remove();
    if (old.has(focused)) $('slider').focus({preventScroll: true});
    if (focused) handles.querySelector(`[data-name="${CSS.escape(focused)}"]`)?.focus({preventScroll: true});
  }

  // -- Answers in the picture: what is pressed, or drawn as an arrow ----------------------------------------------------

  const aims = $('picture').querySelector('.aims');
  const placed = (element, [x, y]) => {
    Object.assign(element.style, {left: `${100 * x / shown.width}%`, top: `${100 * y / shown.height}%`});
    return element;
  };
  function fillAims({aims: all = []}) {
    if (aims.what === JSON.stringify([all, shown.width, shown.height])) return;
    aims.what = JSON.stringify([all, shown.width, shown.height]);
    aims.classList.toggle('drawing', Boolean(all[0]?.by));
    aims.replaceChildren(...all[0]?.by ? arrowFrom(all) : all.map(({choice, name, at}) => {
      const button = make('button', {type: 'button', className: 'aim'}, ...marked(name));
      button.addEventListener('click', () => asking?.answer(choice));
      return placed(button, at);
    }));
  }

  // One arrow, which leads where one points; arrow keys turn it.
  let arrow = null;
  function arrowFrom(all) {
    const tip = placed(make('i', {className: 'arrow'}), all[0].from);
    const start = placed(make('button', {type: 'button', className: 'from', ariaLabel: 'Direction: arrow keys turn it, Enter draws it'}), all[0].from);
    arrow = {tip, start, all, angle: 0};
    start.addEventListener('keydown', event => {
      const by = {ArrowLeft: 15, ArrowUp: 15, ArrowRight: -15, ArrowDown: -15}[event.key];
      if (event.key === 'Enter') draws();
      else if (by) point(arrow.angle + by), host.say(`${arrow.angle} degrees from the right, upwards`);
      else return;
      event.preventDefault();
      event.stopPropagation();
    });
    return [tip, start];
  }
  function point(angle, length = 90) {
    arrow.angle = (Math.round(angle) + 540) % 360 - 180;
    Object.assign(arrow.tip.style, {width: `${length}px`, transform: `rotate(${-angle}deg)`});
  }
  const nearEnough = Math.cos(25 * Math.PI / 180);
  function draws() {
    const angle = arrow.angle * Math.PI / 180;
    const cosine = ({by: [x, y]}) => (x * Math.cos(angle) - y * Math.sin(angle)) / Math.hypot(x, y);
    const best = arrow.all.reduce((one, other) => cosine(other) > cosine(one) ? other : one);
    asking?.answer(cosine(best) > nearEnough ? best.choice : null);
  }
  function followArrow(event) {
    const {left, top} = arrow.start.getBoundingClientRect(), half = arrow.start.offsetWidth / 2;
    const x = event.clientX - left - half, y = event.clientY - top - half;
    if (Math.hypot(x, y) > 12) point(Math.atan2(-y, x) * 180 / Math.PI, Math.hypot(x, y));
    return Math.hypot(x, y) > 12;
  }
  aims.addEventListener('pointerdown', event => {
    if (!aims.matches('.drawing') || event.button !== 0) return;
    event.stopPropagation();
    aims.setPointerCapture(event.pointerId);
    aims.follows = true;
  });
  aims.addEventListener('pointermove', event => { if (aims.follows) followArrow(event); });
  aims.addEventListener('pointerup', event => { if (aims.follows && followArrow(event)) draws(); aims.follows = false; });
  aims.addEventListener('pointercancel', () => { aims.follows = false; });

  // `what`: a question, or "direction"; null: nothing any more. `answer`: told the choice; null where an arrow leads to none.
  // Returns: whether it can be answered in the picture.
  function askFor(what, answer) {
    if (what === null && !asking) return false;
    asking = what === null ? null : {what, answer};
    draw();
    return Boolean(shown.aims?.length);
  }

  // -- Values of the scene, at paths ----------------------------------------------------------------------------------

  const numbers = () => scene.dimension;
  const at = (scene, path) => path.reduce((value, key) => value?.[key], scene) ?? Array(numbers()).fill(0);
  const words = values => `(${values.map(x => Number(x.toPrecision(6))).join(', ')})`;
  const valueOf = grip => grip.paths.length === 1 ? words(at(scene, grip.paths[0])) : `${grip.paths.length} points`;

  function put(scene, path, value) {
    let place = scene;
    for (const key of path.slice(0, -1)) place = place[key] ??= {};
    place[path.at(-1)] = value;
  }

  // A step of the grid: 1, 2 or 5 times a power of ten, at least so many page units.
  function stepOf(grip, units) {
    const wanted = units * Math.hypot(...grip.right), power = 10 ** Math.floor(Math.log10(wanted));
    return power * [1, 2, 5, 10].find(each => each * power >= wanted * 0.999);
  }
  const rounded = (x, step) => Number((Math.round(x / step) * step).toPrecision(12));

  const dot = (p, q) => p.reduce((sum, each, i) => sum + each * q[i], 0);
  const cross = (p, q) => p.map((_, i) => p[(i + 1) % 3] * q[(i + 2) % 3] - p[(i + 2) % 3] * q[(i + 1) % 3]);
  const times = (x, p) => p.map(each => x * each), plus = (p, q) => p.map((each, i) => each + q[i]);
  const unit = p => times(1 / Math.hypot(...p), p);

  // A direction, which keeps its length: in the plane turned so many degrees, in space toward where the arrow of the key points.
  function turned(from, grip, [x, y], degrees) {
    const own = at(from, grip.paths[0]), v = own.some(Boolean) ? [...own, 0].slice(0, 3) : grip.value;
    const right = unit(grip.right), up = unit(grip.up);
    const [first, second] = isInSpace() ? [cross(right, up), x ? right : up] : [right, up];
    const way = isInSpace() ? x || -y : -x || -y, within = [dot(v, first), dot(v, second)];
    const angle = Math.atan2(within[1], within[0]) + way * degrees * Math.PI / 180, size = Math.hypot(...within);
    const rest = plus(v, plus(times(-within[0], first), times(-within[1], second)));
    const next = structuredClone(from), value = plus(rest, times(size, plus(times(Math.cos(angle), first), times(Math.sin(angle), second))));
    put(next, grip.paths[0], value.slice(0, numbers()).map(each => rounded(each, Math.hypot(...v) / 1e4)));
    return next;
  }

  // Where a grip leads that is moved by page units from where `from` has it. What moves as a whole keeps its shape.
  function moved(from, grip, x, y, snaps) {
    const next = structuredClone(from), step = stepOf(grip, snaps ? 8 : 0.02);
    const by = grip.right.map((right, i) => right * x - grip.up[i] * y);
    const isWhole = grip.paths.length > 1;
    for (const path of grip.paths) {
      const start = grip.value ? grip.value.slice(0, numbers()) : at(from, path);
      const value = start.map((old, i) => isWhole ? Number((old + rounded(by[i], step)).toPrecision(12))
        : by[i] || grip.value ? rounded(old + by[i], step) : old);
      if (grip.value && value.every(each => each === 0)) return from;  // a direction leads somewhere
      put(next, path, value);
    }
    return next;
  }

  // -- From one scene to another --------------------------------------------------------------------------------------

  function showAnswers(next) {
    const {answers} = next, before = told.answers;
    told = next;
    $('answers').hidden = !answers;
    if (!answers) return;
    const {whose, mistake, parting, search, truth, is_wrong: isWrong} = answers;
    if (isSame(before, answers) && $('answers').hasChildNodes()) return;  // so that it is not said again
    $('answers').replaceChildren(`${whose}: `, make('b', {textContent: search}),
      ...truth ? [' · Proven: ', make('b', {textContent: truth})] : [],
      ...isWrong ? [' · ', make('strong', {className: 'no', textContent: 'the search is wrong'})] : [],
      ...mistake ? [make('i', {className: 'unseen', textContent: '. '}), make('span', {className: 'small', textContent: `The mistake: ${mistake}; ${parting}`})] : []);
    if (before?.search === search && before?.truth === truth) return;
    $('answers').classList.remove('turned');
    void $('answers').offsetWidth;  // so that it is seen again
    $('answers').classList.add('turned');
  }

  // `like`: the frame whose like is to be shown.
  const requestFor = (next, like, isBrief = false) => ({tell: {...host.beside(), like, ...next.request
    ?? {scene: JSON.stringify(next), file: host.file, brief: isBrief}}});

  // Shows what the program has told of a scene. Returns: whether it was one.
  function show(answer, next) {
    complain(answer.error?.text ?? '');
    if (answer.error) return false;
    scene = answer.scene ?? next;  // as the program says it, with what is usual left out
    showAnswers(answer);
    if (!answer.story.is_brief) fillSwitches();
    host.changed(answer);
    return true;
  }
  const complain = text => { $('complaint').textContent = text; $('complaint').hidden = !text; };

  // Another scene to begin with: the answer of the program about it.
  function begin(answer) {
    scene = original = answer.scene;
    past = [];
    future = [];
    view = {...still};
    show(answer, scene);
    kept();
  }

  // A change that can be undone. Returns: whether it is one, and could be told.
  async function change(next) {
    const before = scene;
    if (isSame(next, scene) || !show(await asked(requestFor(next, host.frame())), next)) return false;
    past.push(before);
    future = [];
    kept();
    return true;
  }
  function kept() {
    $('undo').disabled = !past.length;
    $('redo').disabled = !future.length;
    offerReset();
    $('taking').hidden = Boolean(scene.request) && !past.length && !future.length;
    for (const id of ['save-scene', 'copy-command']) $(id).disabled = Boolean(scene.request);
    if (document.activeElement?.disabled) $('snap').focus();  // from where Tab goes on
    host.kept(isChanged() ? scene : null, host.file !== ownFile);
  }
  const offerReset = () => { $('reset').disabled = !isChanged() && isSame(view, still); };
  async function back(from, to, word) {
    if (!from.length) return;
    const before = scene, next = from.pop();
    if (show(await asked(requestFor(next, host.frame())), next)) to.push(before);
    kept();
    announce(word);
  }
  const undo = () => back(past, future, 'undone'), redo = () => back(future, past, 'redone');
  // For who does not see it.
  const announce = what => host.say(`${what}. ${$('answers').matches('.untold, [hidden]') ? '' : $('answers').textContent}`);

  // -- Dragging -------------------------------------------------------------------------------------------------------

  let drag = null, wanted = 0;
  const unitsOf = box => box.style.getPropertyValue('--units') / box.clientWidth;

  // Grips may lie over each other: the one that was meant is the nearest.
  function nearestGrip(box, {clientX, clientY, target}) {
    if (!target.closest('.grip')) return null;
    const distance = handle => {
      const {left, top, width, height} = handle.getBoundingClientRect();
      return Math.hypot(left + width / 2 - clientX, top + height / 2 - clientY);
    };
    return [...box.querySelectorAll('.grip')].reduce((one, other) => distance(other) < distance(one) ? other : one);
  }

  stage.addEventListener('pointerdown', event => {
    const box = event.target.closest('.box'), handle = box && nearestGrip(box, event);
    if (!box || event.button !== 0 || drag || event.target.closest('.aim')) return;
    drag = {x: event.clientX, y: event.clientY, box, units: unitsOf(box), view: {...view}, like: host.frame(),
            before: scene, grip: handle?.grip, moves: false};
    if (handle) {
      host.pause();
      handle.focus({preventScroll: true});
      ask({hold: true});
      event.preventDefault();
    }
    stage.setPointerCapture(event.pointerId);
  });
  stage.addEventListener('pointermove', event => {
    if (!drag) return;
    [drag.toX, drag.toY, drag.free] = [event.clientX, event.clientY, event.altKey];
    if (!wanted) wanted = requestAnimationFrame(follow);
  });
  function follow() {
    wanted = 0;
    if (!drag) return;
    const box = drag.box.getBoundingClientRect(), within = (x, low, high) => Math.max(low, Math.min(high, x));
    const x = (within(drag.toX, box.left, box.right) - drag.x) * drag.units;
    const y = (within(drag.toY, box.top, box.bottom) - drag.y) * drag.units;
    if (drag.grip) {
      const next = moved(drag.before, drag.grip, x, y, $('snap').checked !== drag.free);
      if (!isSame(next, scene)) drag.moves = show(ask(requestFor(next, drag.like, true)), next) || drag.moves;
    } else if (isInSpace()) {
      lookFrom({turn: drag.view.turn - x / 3, rise: Math.max(-80, Math.min(80, drag.view.rise + y / 3))});
    }
  }
  function letGo(isMeant = true) {
    if (!drag) return;
    cancelAnimationFrame(wanted);
    if (wanted && isMeant) follow();
    wanted = 0;
    const {grip, moves, before} = drag;
    drag = null;
    if (!grip) return;
    ask({hold: false});
    if (!moves) return;
    const next = isMeant ? scene : before;
    show(ask(requestFor(next, host.frame())), next);
    if (isSame(before, next)) return kept();
    past.push(before);
    future = [];
    kept();
    const now = gripCalled(grip.name);
    announce(now ? `${now.says}: ${valueOf(now)}` : 'moved');
    document.activeElement?.blur?.();  // so that arrow keys step again
  }
  for (const end of ['pointerup', 'pointercancel']) stage.addEventListener(end, () => letGo());
  stage.addEventListener('wheel', event => {
    if (!event.target.closest('.box') || (!isInSpace() && !event.ctrlKey)) return;
    event.preventDefault();
    zoomBy(Math.exp(-event.deltaY / 500));
  }, {passive: false});
  function lookFrom(way) {
    view = {...view, ...way};
    draw();
    offerReset();
  }
  const zoomBy = factor => lookFrom({zoom: Math.max(0.25, Math.min(20, view.zoom * factor))});
  const turnBy = degrees => lookFrom({turn: view.turn + degrees});

  // Two fingers.
  let apart = 0;
  stage.addEventListener('touchstart', event => event.touches.length === 2 && event.preventDefault(), {passive: false});
  stage.addEventListener('touchmove', event => {
    const [one, other] = event.touches, before = apart;
    apart = other ? Math.hypot(one.clientX - other.clientX, one.clientY - other.clientY) : 0;
    if (!other) return;
    event.preventDefault();
    letGo();
    if (before) zoomBy(apart / before);
  }, {passive: false});

  // -- Keys -----------------------------------------------------------------------------------------------------------

  const ways = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1]};
  stage.addEventListener('keydown', event => {
    const grip = event.target.closest('.grip')?.grip, way = ways[event.key];
    if (!grip || event.ctrlKey || event.metaKey) return;
    const act = way ? () => moveBy(grip, way, event)
      : event.key === 'Delete' || event.key === 'Backspace' ? () => removeCorner(grip)
      : event.key === 'Insert' || event.key === '+' ? () => addCorner(grip) : null;
    if (!act) return;
    event.preventDefault();
    event.stopPropagation();
    act();
  });
  async function moveBy(grip, way, {altKey, shiftKey}) {
    const snaps = $('snap').checked !== altKey, step = stepOf(grip, snaps ? 8 : 0.5) / Math.hypot(...grip.right);
    const steps = shiftKey ? 10 : 1, [x, y] = way.map(each => each * step * steps), {search} = told.answers;
    await change(grip.value ? turned(scene, grip, way, (snaps ? 5 : 0.5) * steps) : moved(scene, grip, x, y, snaps));
    const now = gripCalled(grip.name);
    const turns = told.answers.search === search ? '' : `. ${told.answers.whose} now says: ${told.answers.search}`;
    if (now) host.say(`${now.says}: ${valueOf(now)}${turns}`);
  }
  const gripCalled = name => shown.grips.concat(shown.objects?.grips ?? []).find(each => each.name === name);
  // Escape: as it was before the drag; closes what is open.
  document.addEventListener('keydown', event => {
    if (event.key === 'Escape') {
      const open = $('taking').querySelector('details[open]');
      if (drag) letGo(false);
      else if (open) open.open = false, open.querySelector('summary').focus();
      return;
    }
    if (!(event.ctrlKey || event.metaKey)) return;
    const key = event.key.toLowerCase();
    if (key !== 'z' && key !== 'y') return;
    event.preventDefault();
    if (key === 'y' || event.shiftKey) redo(); else undo();
  });

  // -- Corners come and go --------------------------------------------------------------------------------------------

  const cornerOf = grip => grip?.paths.length === 1 && typeof grip.paths[0].at(-1) === 'number' ? grip.paths[0] : null;
  const selected = () => stage.querySelector('.grip.selected')?.grip;
  stage.addEventListener('focusin', event => {
    const handle = event.target.closest('.grip');
    if (!handle) return;
    stage.querySelectorAll('.selected').forEach(each => each.classList.remove('selected'));
    handle.classList.add('selected');
    $('add').disabled = $('remove').disabled = !cornerOf(handle.grip);
  });
  // `edit`: returns the place of the corner that one then has hold of.
  async function editCorners(grip, what, edit) {
    const path = cornerOf(grip);
    if (!path) return;
    const next = structuredClone(scene), points = at(next, path.slice(0, -1)), place = edit(points, path.at(-1));
    if (!await change(next)) return;
    const name = grip.name.replace(/\[\d+\]$/, `[${Math.min(place, points.length - 1)}]`), now = gripCalled(name);
    stage.querySelector(`.grip[data-name="${CSS.escape(name)}"]`)?.focus({preventScroll: true});
    announce(`${what}${now ? `, now at ${now.says}: ${valueOf(now)}` : ''}`);
  }
  const addCorner = grip => editCorners(grip, 'corner added', (points, i) => {
    const step = 5 * stepOf(grip, 8), by = grip.right.map((right, k) => (right + grip.up[k]) / Math.hypot(...grip.right) * step);
    points.splice(i + 1, 0, points[i].map((x, k) => rounded(x + by[k], step / 5)));
    return i + 1;
  });
  const removeCorner = grip => editCorners(grip, 'corner removed', (points, i) => {
    if (points.length > 1) points.splice(i, 1);
    else host.say('an object has at least one corner');
    return i;
  });

  // -- Switches -------------------------------------------------------------------------------------------------------

  function fillSwitches() {
    $('switches').hidden = !told.switches?.length;
    const old = new Map([...$('switches').children].map(each => [each.dataset.key, each]));
    for (const [place, {key, label, chosen, choices}] of (told.switches ?? []).entries()) {
      let row = old.get(key);
      if (!row) {
        row = make('label', {}, `${label} `, make('select', {ariaLabel: label}));
        row.dataset.key = key;
        row.querySelector('select').addEventListener('change', event => choose(key, event.target));
      }
      if ($('switches').children[place] !== row) $('switches').insertBefore(row, $('switches').children[place]);
      const select = row.querySelector('select');
      select.replaceChildren(...choices.map(({text, value}) => Object.assign(make('option', {textContent: text}), {json: value})));
      select.selectedIndex = chosen;
      old.delete(key);
    }
    for (const row of old.values()) row.remove();
  }
  async function choose(key, select) {
    const {json, textContent} = select.selectedOptions[0], next = {...scene, [key]: json};
    if (json === null) delete next[key];
    if (await change(next)) announce(`${select.ariaLabel}: ${textContent}`);
    else fillSwitches();  // as they were
  }

  // -- Taking along ---------------------------------------------------------------------------------------------------

  function save(name, content, type) {
    const link = make('a', {download: name, href: URL.createObjectURL(new Blob([content], {type}))});
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 1000);
    $('copied').textContent = `${name} saved`;
  }
  const fileName = () => `${host.name.replace(/[^\w-]+/g, '-')}`;
  function standalone() {
    const {picture, width, height} = shown, paper = getComputedStyle(document.body).backgroundColor;
    return picture.replace('<svg ', `<svg width='${width}' height='${height}' `)
      .replace('>', `><rect x='-10000' y='-10000' width='20000' height='20000' fill='${paper}'/>`);
  }
  async function savePng() {
    const {width, height} = shown, scale = 2, image = new Image();
    image.src = `data:image/svg+xml;charset=utf-8,${encodeURIComponent(standalone())}`;
    await image.decode();
    const canvas = make('canvas', {width: width * scale, height: height * scale});
    canvas.getContext('2d').drawImage(image, 0, 0, canvas.width, canvas.height);
    canvas.toBlob(blob => save(`${fileName()}-${host.frame() + 1}.png`, blob, 'image/png'));
  }
  const isChanged = () => !isSame(scene, original);
  const command = () => `gjkstep render ${isChanged() ? `${fileName()}.json` : host.known} --frames ${host.frame() + 1}`;
  async function copy(text, what) {
    try {
      await navigator.clipboard.writeText(text);
      $('copied').textContent = `${what} copied: ${text.length > 90 ? `${text.slice(0, 90)}…` : text}`;
    } catch {
      $('copied').textContent = text;
    }
  }
  const needs = () => isChanged() ? `, which draws ${fileName()}.json, the scene file above,` : '';
  const address = async () => `${location.href.split('#')[0]}#scene=${await packed(scene)}&step=${host.frame() + 1}`;
  const fromDisk = () => location.protocol === 'file:' ? ', to this disk: for others open the page where it is on the web, and copy there,' : '';
  const acts = {
    undo, redo, add: () => addCorner(selected()), remove: () => removeCorner(selected()),
    async reset() {
      await change(original);
      lookFrom(still);
      announce('as it was');
    },
    'save-scene': () => save(`${fileName()}.json`, `${JSON.stringify(scene, null, 1)}\n`, 'application/json'),
    'save-svg': () => save(`${fileName()}-${host.frame() + 1}.svg`, standalone(), 'image/svg+xml'),
    'save-png': savePng,
    'copy-command': () => copy(command(), `Command${needs()}`),
    'copy-link': async () => copy(await address(), `Link${fromDisk()}`),
    'copy-frame': async () => copy(`<iframe src="${await address()}" width="1000" height="600" title="${host.name}"></iframe>`, `Frame${fromDisk()}`),
  };
  for (const [id, act] of Object.entries(acts)) $(id).addEventListener('click', act);

  // A scene or a trace that somebody drops or chooses: data, never run.
  const most = 4 << 20;
  async function take(file) {
    if (!file) return;
    if (file.size > most) return complain(`${file.name}: has ${file.size} bytes, more than ${most}; draw it with the program`);
    const text = await file.text(), isTrace = text.startsWith('{"schema":"gjkstep-trace"');
    const answer = await asked({tell: isTrace ? {trace: text} : {scene: text, file: file.name}});
    if (answer.error) return complain(`${file.name}:${answer.error.line}: ${answer.error.text}`);
    past.push(scene);
    future = [];
    host.name = file.name.replace(/\.[^.]*$/, '');
    host.file = file.name;
    view = {...still};
    host.opened();
    show(answer, answer.scene ?? {request: {trace: text}});
    kept();
    announce(`${file.name} opened`);
  }
  addEventListener('dragover', event => { if (event.dataTransfer.types.includes('Files')) event.preventDefault(); });
  addEventListener('drop', event => { event.preventDefault(); take(event.dataTransfer.files[0]); });
  $('open-file').addEventListener('change', ({target}) => {
    take(target.files[0]);
    target.value = '';  // so that the same file may be chosen again
  });

  const menus = [...$('taking').querySelectorAll('details')];
  for (const menu of menus)
    menu.addEventListener('toggle', () => { if (menu.open) for (const other of menus) other.open &&= other === menu; });
  addEventListener('resize', draw);
  stage.hidden = false;
  document.documentElement.classList.add('live');
  showAnswers(told);
  fillSwitches();
  kept();
  window.gjkstep.drawn = i => ask({draw: {frame: i}});  // for tests, and who looks closer
  const close = () => { for (const open of $('taking').querySelectorAll('details[open]')) open.open = false; };
  return {draw, turnBy, close, isInSpace, isChanged, complain, begin, ask: askFor,
          restore: async next => { if (await change(next ?? original)) announce('the scene of the address'); },
          drawn: i => elementOf(ask({draw: {frame: i, height, ...view, theme: 'report', text: host.looks().text}}).picture)};
}

// As HTML, which browsers parse faster than XML.
const elementOf = svg => document.adoptNode(new DOMParser().parseFromString(svg, 'text/html').body.firstElementChild);

// -- A scene in an address: JSON, deflated, in letters that addresses may have ------------------------------------------

async function packed(value) {
  const stream = new Blob([JSON.stringify(value)]).stream().pipeThrough(new CompressionStream('deflate-raw'));
  const bytes = new Uint8Array(await new Response(stream).arrayBuffer());
  return btoa(Array.from(bytes, byte => String.fromCharCode(byte)).join('')).replaceAll('+', '-').replaceAll('/', '_').replaceAll('=', '');
}
async function unpacked(text) {
  const most = 4 << 20, bytes = Uint8Array.from(atob(text.replaceAll('-', '+').replaceAll('_', '/')), c => c.charCodeAt(0));
  const reader = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate-raw')).getReader();
  const parts = [];
  let length = 0;
  for (let part = await reader.read(); !part.done; part = await reader.read()) {
    if ((length += part.value.length) > most) throw Error('the scene in the address is too large');
    parts.push(part.value);
  }
  return JSON.parse(await new Blob(parts).text());
}
