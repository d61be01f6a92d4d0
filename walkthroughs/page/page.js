'use strict';
(() => {
  const inside = document.getElementById('data');  // else it came from a file beside the page
  const data = inside ? JSON.parse(inside.textContent) : window.gjkstepSteps;
  if (!data) return document.documentElement.classList.remove('js');  // that was left behind: all steps below each other
  const steps = [...document.querySelectorAll('.step')];
  const title = document.title;
  const heading = document.querySelector('h1'), name = heading.textContent;
  const $ = id => document.getElementById(id);
  const make = (tag, className, text) => Object.assign(document.createElement(tag), {className: className || '', textContent: text || ''});
  const near = 4;  // pictures that are loaded ahead
  const isBare = location.hash.endsWith('&bare');  // beside another walkthrough, in a page that steps both
  let at = 0, timer = 0;

  const boxesOf = i => steps[i].querySelectorAll('.code');  // one for each search whose lines are shown

  // -- One step -------------------------------------------------------------------------------------------------------

  function fillCode(box, [listing, current, outcomes]) {
    if (box.querySelector('ol')) return;
    const list = make('ol');
    data.listings[listing].forEach(([indent, html], i) => {
      const line = make('li');
      line.style.setProperty('--indent', indent);
      line.append(Object.assign(make('span'), {innerHTML: html}));  // made by the program, with <sub> for subscripts
      if (outcomes[i]) line.append(make('b', outcomes[i].endsWith('✓') ? 'met' : 'unmet', outcomes[i]));
      if (i === current) line.setAttribute('aria-current', 'step');
      list.append(line);
    });
    box.querySelector('code')?.remove();
    box.append(list);
  }

  const load = file => new Promise((use, fail) => {
    const script = make('script');
    script.addEventListener('load', use);
    script.addEventListener('error', fail);
    script.src = file;
    document.head.append(script);
  });

  // Data that stand in the page, or in a script beside it that is loaded when somebody asks.
  async function held(id, variable, file) {
    const inside = $(id);
    if (inside) return JSON.parse(inside.textContent);
    if (!window[variable]) await load(file);
    return window[variable];
  }

  function addEvents(i) {
    if (!data.steps[i].iteration || steps[i].querySelector('.events')) return;
    const details = make('details', 'events');
    details.append(make('summary', '', 'Events as JSON'));
    details.addEventListener('toggle', async () => {
      if (details.querySelector('pre')) return;
      const text = make('pre');
      details.append(text);
      try {
        const {scenes, steps: ranges} = await held('events', 'gjkstepEvents', 'events.js');
        text.textContent = ranges[i].flatMap(([first, last], s) =>
          scenes[s].events.slice(first, last + 1).map(event => JSON.stringify({scene: scenes[s].name, ...event}))).join('\n');
      } catch {
        text.textContent = 'The file events.js, which belongs beside this page, is not there.';
      }
    });
    steps[i].querySelector('.text').append(details);
  }

  function complete(i) {
    boxesOf(i).forEach((box, b) => fillCode(box, data.steps[i].code[b]));
    addEvents(i);
    for (let j = Math.max(0, i - near); j <= Math.min(steps.length - 1, i + near); ++j)
      steps[j].querySelector('img').loading = 'eager';
  }

  // Where the words stand beside the picture the line that runs stays in sight, and so does the picture.
  const isWide = matchMedia('(min-width: 900px)');
  function keepInSight() {
    if (!isWide.matches || isBare) return;
    for (const part of ['.code [aria-current]', '.shot']) steps[at].querySelector(part)?.scrollIntoView({block: 'nearest'});
  }

  const said = i => [...steps[i].querySelectorAll('.where, .text > h2, .text > ul > li')].map(e => e.textContent.trim().replace(/\.$/, '')).join('. ');

  // -- From step to step ----------------------------------------------------------------------------------------------

  // `how`: whether the address gets an entry of its own in the browser's history, replaces the last one, or stays.
  function show(i, how) {
    i = Math.max(0, Math.min(steps.length - 1, i));
    const moved = i !== at;
    quiz.leave();
    steps[at].classList.remove('now');
    steps[at = i].classList.add('now');
    complete(i);
    $('slider').value = i + 1;
    $('slider').setAttribute('aria-valuetext', steps[i].querySelector('.where').textContent);
    $('place').textContent = `${i + 1} / ${steps.length}`;
    for (const [id, end] of [['first', 0], ['back', 0], ['next', steps.length - 1], ['last', steps.length - 1]])
      $(id).disabled = i === end;
    keepInSight();
    if (moved) $('live').textContent = said(i);
    quiz.arrive(moved);
    entitle();
    if (isBare) parent.postMessage({reading: readingTime(i)}, '*');
    if (how !== 'stay' && moved) history[how === 'push' ? 'pushState' : 'replaceState'](null, '', `#${i + 1}`);
  }

  // Titles tell how it ends: not while it is asked.
  function entitle() {
    const untold = quiz.untold();
    document.title = `${at + 1}/${steps.length} ${untold || title}`;
    heading.textContent = untold || name;
    for (const told of [$('summary'), ...document.querySelectorAll('.made')]) told.hidden = untold !== '';
  }

  const go = i => { pause(); show(i, 'push'); };
  const back = () => { if (quiz.isAsking()) quiz.leave(); else go(at - 1); };
  function forward() {
    pause();
    if (!quiz.holds()) show(at + 1, 'push');
  }
  const addressed = () => /^#\d+(&bare)?$/.test(location.hash) ? parseInt(location.hash.slice(1), 10) - 1 : 0;

  // -- Playing --------------------------------------------------------------------------------------------------------

  // As long as it takes to read what is said.
  const readingTime = i => Math.min(9000, 1500 + 25 * said(i).length);

  function playOn() {
    timer = setTimeout(() => {
      if (quiz.holds()) return pause();
      show(at + 1, 'replace');
      if (at + 1 < steps.length) playOn(); else pause();
    }, readingTime(at));
  }
  function pause() {
    clearTimeout(timer);
    timer = 0;
    $('play').textContent = 'Play';
  }
  function play() {
    if (timer) return pause();
    if (at + 1 === steps.length) show(0, 'push');
    $('play').textContent = 'Pause';
    playOn();
  }

  // -- Predicting -----------------------------------------------------------------------------------------------------

  // What asks, and what it asks, are loaded when somebody wants to be asked: until then nothing is.
  const nobody = {leave() {}, arrive() {}, holds: () => false, isAsking: () => false, untold: () => ''};
  let quiz = nobody, coming = null;
  async function prepareQuiz() {
    const questions = await held('questions', 'gjkstepQuestions', 'questions.js');
    if (!window.gjkstepQuiz) await load('predict.js');
    return window.gjkstepQuiz({steps, data, $, make, boxesOf, show, entitle, place: () => at}, questions);
  }
  async function predict() {
    try {
      quiz = await (coming ??= prepareQuiz());
    } catch {
      coming = null;
      $('live').textContent = 'The files questions.js and predict.js, which belong beside this page, are not there.';
      return;
    }
    quiz.toggle();
  }
  $('predict').hidden = !data.questions;
  $('unasked').hidden = data.questions || !data.unasked;

  // -- What one presses, drags and swipes ---------------------------------------------------------------------------------

  // Views of a picture, the usual one first, all around.
  const turns = data.turned.length ? data.turned[0].length : 0;
  const viewOf = shot => turns ? 1 + data.turned[at].indexOf(shot.firstElementChild.getAttribute('src')) : 0;
  function turnTo(shot, view) {
    shot.dataset.usual ??= shot.firstElementChild.getAttribute('src');
    const views = [shot.dataset.usual, ...data.turned[at]], place = (view % views.length + views.length) % views.length;
    shot.firstElementChild.src = views[place];
    $('live').textContent = `View ${place + 1} of ${views.length}`;
  }
  const turnBy = by => { const shot = steps[at].querySelector('.shot'); turnTo(shot, viewOf(shot) + by); };

  const keys = {
    ArrowLeft: back, ArrowRight: forward, Home: () => go(0), End: () => go(steps.length - 1), ' ': play,
  };
  const turning = {ArrowLeft: () => turnBy(-1), ArrowRight: () => turnBy(1)};
  const hasQuestions = () => data.questions && $('letters').checked;
  function letter(key) {
    if (!hasQuestions()) return null;
    if (key.toLowerCase() === 'p') return predict;
    return quiz.isAsking() && /^[1-9]$/.test(key) ? () => quiz.answer(key - 1) : null;
  }
  document.addEventListener('keydown', event => {
    const act = (turns && event.shiftKey && turning[event.key]) || keys[event.key] || letter(event.key);
    if (event.ctrlKey || event.metaKey || event.altKey || event.isComposing || !act || event.target.closest('select')) return;
    if (event.key === ' ' && event.target.closest('button, summary, a, input:not([type=range])')) return;
    event.preventDefault();
    if (isBare) parent.postMessage({key: event.key}, '*'); else act();
  });
  for (const [id, act] of [['first', keys.Home], ['back', keys.ArrowLeft], ['next', keys.ArrowRight], ['last', keys.End], ['play', play], ['predict', predict],
                           ['turn-back', turning.ArrowLeft], ['turn-on', turning.ArrowRight]])
    $(id).addEventListener('click', act);
  $('slider').addEventListener('input', () => { pause(); show($('slider').value - 1, 'replace'); });
  addEventListener('popstate', () => { pause(); show(addressed(), 'stay'); });

  // A swipe steps; where there are further views, it turns the picture, as buttons and keys do.
  let from = null;
  document.querySelector('main').classList.toggle('turns', turns > 0);
  for (const id of ['turn-back', 'turn-on', 'turning']) $(id).hidden = !turns;
  function turn(shot, x) {
    const width = shot.clientWidth / (turns + 1);
    turnTo(shot, Math.round((x - from.x) / width) + from.view);
  }
  $('steps').addEventListener('pointerdown', event => {
    const shot = event.target.closest('.shot');
    from = null;
    if (!shot || !event.isPrimary || event.button !== 0) return;
    from = {x: event.clientX, y: event.clientY, shot, view: viewOf(shot)};
    if (turns) shot.setPointerCapture(event.pointerId);
  });
  addEventListener('pointermove', event => { if (from && turns) turn(from.shot, event.clientX); });
  addEventListener('pointerup', event => {
    if (!from) return;
    const x = event.clientX - from.x, y = event.clientY - from.y;
    from = null;
    if (!turns && Math.abs(x) > 40 && Math.abs(x) > 2 * Math.abs(y)) (x < 0 ? forward : back)();
  });
  addEventListener('pointercancel', () => { from = null; });
  $('steps').addEventListener('dragstart', event => event.preventDefault());

  // -- Marks of iterations, decisions and the end ---------------------------------------------------------------------

  if (steps.length <= 400) data.steps.forEach((step, i) => {
    const isFirst = step.iteration && step.iteration !== data.steps[i - 1]?.iteration;
    for (const kind of [isFirst && 'iteration', step.kind]) {
      if (!kind) continue;
      const mark = make('span', kind, kind === 'iteration' && steps.length <= 80 ? String(step.iteration) : '');
      mark.style.left = `${100 * i / Math.max(1, steps.length - 1)}%`;
      $('marks').append(mark);
    }
  });

  // Before printing all is there, also what nobody has looked at.
  const chooseHandout = () => document.documentElement.classList.toggle('strip', $('handout').value === 'strip');
  $('printing').hidden = false;
  $('handout').addEventListener('change', chooseHandout);
  $('print').addEventListener('click', () => print());
  chooseHandout();  // a browser may have kept the choice
  addEventListener('beforeprint', () => steps.forEach((step, i) => complete(i)));

  document.documentElement.classList.toggle('bare', isBare);
  show(addressed(), 'stay');
  addEventListener('load', keepInSight);  // the browser itself has gone to the step of the address by then
})();
