'use strict';
// Steps through one walkthrough, which story.js tells.
(() => {
  if (!window.gjkstep) return;  // it was left behind: all pictures stand below each other
  const {entry} = window.gjkstep;
  let {story} = window.gjkstep, {frames} = story, lesson = null;  // that is open, where this is the lesson
  const {lesson: screens} = story;
  let title = document.title;
  const heading = document.querySelector('h1');
  let name = heading.textContent, stage = null;  // what draws and can be taken hold of, once the program runs
  const near = 4;  // pictures that are loaded ahead
  const isBare = location.hash.endsWith('&bare');  // beside another walkthrough, in a page that steps both

  // -- One step -------------------------------------------------------------------------------------------------------

  const where = ({iterations, simplex}, i) => [
    `Step ${i + 1} of ${frames.length}`,
    ...iterations ? [`iteration${iterations[1] ? 's' : ''} ${iterations.join(' and ')}${story.is_float ? ', in float' : ''}`] : [],
    ...simplex ? [`simplex ${simplex}`] : [],
  ].join(' · ');

  // Its class gives a caption or a fact a mark; words for who cannot see that.
  const wordsOf = {yes: 'true: ', no: 'not so: '};
  const textOf = place => story.texts[place];
  const told = (tag, mark, text) => make(tag, {className: mark},
    make('i', {className: 'unseen', textContent: wordsOf[mark] ?? ''}), mark === 'skipped' ? 'skipped ' : '', ...marked(text));
  const fact = ([mark, text]) => told('li', mark, textOf(text));
  const inWords = i => (frames[i]?.words ?? []).map(textOf).join(' ');

  // How near the search has come: one box for all steps, by the picture, where it keeps its place.
  const nearing = make('figure', {className: 'progress'}, make('div', {ariaHidden: 'true'}), make('figcaption'));
  function tellProgress({progress}) {
    nearing.hidden = !progress && !story.is_brief;
    nearing.classList.toggle('former', !progress);  // while one drags
    if (progress) {
      const [drawn, caption] = nearing.children, words = textOf(progress[0]), graph = story.graphs[0] + story.graphs[progress[1]];
      refill(caption, words, () => marked(words));
      refill(drawn, graph, () => [elementOf(graph)]);
    }
    if (isWide.matches && frames[at].events.length > 1) steps[at].querySelector('.told').append(nearing);  // pictures of two are large
    else if (stage && isWide.matches) $('taking').before(nearing);
    else steps[at].querySelector('.seen').append(nearing);
  }

  let steps = [];
  // What says the same is not laid out anew.
  function refill(element, what, children) {
    const text = JSON.stringify(what);
    if (element.what !== text) element.replaceChildren(...children());
    element.what = text;
  }

  const toldOf = (frame, i) => [
    make('p', {className: 'where'}, ...marked(where(frame, i))),
    told('h2', frame.mark ?? '', frame.caption),
    ...frame.facts.length ? [make('ul', {}, ...frame.facts.map(fact))] : []];
  const makeStep = (frame, i) => make('section', {className: 'step', id: i + 1},
    make('div', {className: 'seen'},
      make('div', {className: 'shot'}, make('img', {loading: 'lazy', alt: inWords(i), src: frame.pictures[0]}))),
    make('div', {className: 'text'},
      make('div', {className: 'told'}, ...toldOf(frame, i)),
      ...frame.code.map(() => make('div', {className: 'code'}, make('h3'), make('ol')))));

  // While one drags the step that is shown becomes the next one: what is the same of it needs no layout.
  function becomes(step, frame, i) {
    step.id = i + 1;
    refill(step.querySelector('.told'), [where(frame, i), frame.mark, frame.caption, inWords(i)], () => toldOf(frame, i));
    return step;
  }
  const isLike = (step, frame) => step?.querySelectorAll('.code').length === frame.code.length;

  function fillCode(box, {title, listing, current, outcomes = {}}) {
    const list = box.querySelector('ol'), lines = story.listings[listing];
    refill(box.querySelector('h3'), textOf(title), () => marked(textOf(title)));
    refill(list, lines, () => lines.map(([indent, text]) => {
      const line = make('li', {}, make('span', {}, ...marked(text)), make('b'));
      line.style.setProperty('--indent', indent);
      return line;
    }));
    [...list.children].forEach((line, i) => {
      const outcome = outcomes[i] ?? '', sign = line.querySelector('b');
      refill(sign, outcome, () => [outcome]);
      sign.className = outcome.endsWith('✓') ? 'met' : 'unmet';
      if (i === current) line.setAttribute('aria-current', 'step');
      else line.removeAttribute('aria-current');
    });
  }

  // What few ask for is loaded when somebody does. A page that holds all has it.
  async function loaded(name, file) {
    if (!window[name]) await new Promise((use, fail) => {
      const missing = () => fail(Error(`The file ${file}, which belongs beside this page, is not there.`));
      document.head.append(make('script', {src: file, onload: use, onerror: missing}));
    });
    return window[name];
  }

  const eventsOf = (i, scenes) => frames[i].events.flatMap(([first, last], s) =>
    scenes[s].events.slice(first, last + 1).map(event => JSON.stringify({scene: scenes[s].name, ...event}))).join('\n');

  function addEvents(i) {
    if (!frames[i].events.length || steps[i].querySelector('.events')) return;
    if (stage?.isChanged()) return;  // the file is about the scene as it was
    const details = make('details', {className: 'events'}, make('summary', {textContent: 'Events as JSON'}));
    details.addEventListener('toggle', async () => {
      if (details.querySelector('pre')) return;
      const text = make('pre');
      details.append(text);
      const scenes = loaded('gjkstepEvents', 'events.js');
      text.textContent = await scenes.then(found => eventsOf(i, found), error => error.message);
    });
    steps[i].querySelector('.told').append(details);
  }

  function complete(i) {
    steps[i].querySelectorAll('.code').forEach((box, b) => fillCode(box, frames[i].code[b]));
    addEvents(i);
    for (const step of steps.slice(Math.max(0, i - near), i + near + 1))
      step?.querySelector('img')?.setAttribute('loading', 'eager');
  }

  // Where the words stand beside the picture the line that runs stays in sight, and so does the picture.
  const isWide = matchMedia('(min-width: 900px)');
  function keepInSight() {
    if (!isWide.matches || isBare) return;
    for (const part of ['.code [aria-current]', '.shot'])
      steps[at].querySelector(part)?.scrollIntoView({block: 'nearest'});
  }

  const said = i => [...steps[i].querySelectorAll('.where, .told > h2, .told > ul > li')]
    .map(each => each.textContent.trim().replace(/\.$/, '')).join('. ');

  // -- From step to step ----------------------------------------------------------------------------------------------

  let at = 0;
  function show(i, how) {
    const moved = i !== at;
    quiz.leave();
    if (!steps[i]) return;  // while one drags there is one step alone
    steps[at]?.classList.remove('now');
    steps[at = i].classList.add('now');
    complete(i);
    tellProgress(frames[i]);
    stage?.draw();
    tellPicture(inWords(i));
    set($('slider'), {ariaValueText: steps[i].querySelector('.where').textContent});
    if (!story.is_brief) keepInSight();  // which asks for a layout
    if (moved) $('live').textContent = said(i);
    quiz.arrive(moved);
    entitle();
    if (isBare) parent.postMessage({reading: readingTime()}, '*');
    if (how !== 'stay' && moved && !lesson) history[how === 'push' ? 'pushState' : 'replaceState'](null, '', addressOf(i));
  }

  // What is seen, for who does not see it.
  function tellPicture(words) {
    set(steps[at]?.querySelector('img') ?? {}, {alt: words});
    set($('picture').querySelector('.drawn'), {ariaLabel: words});
  }

  // Titles tell how it ends: not while it is asked.
  function entitle() {
    const untold = lesson ? '' : quiz.untold();
    set(document, {title: `${at + 1}/${frames.length} ${untold || title}`});
    set(heading, {textContent: untold || name});
    for (const told of document.querySelectorAll('.made, #answers')) told.classList.toggle('untold', untold !== '');
  }

  const readingTime = () => Math.min(9000, 1500 + 25 * said(at).length);
  let taken = '';  // of the scene, where it is another: what its address holds of it
  const addressOf = i => taken ? `#scene=${taken}&step=${i + 1}` : `#${i + 1}`;
  const stepOf = hash => (hash.match(/^#(?:scene=[\w-]+&step=)?(\d+)(?:&bare)?$/)?.[1] ?? 1) - 1;
  const addressed = () => stepOf(location.hash);
  const stepping = stepper({
    count: () => frames.length, show, reading: readingTime, holds: () => quiz.holds(),
    back: () => { if (quiz.isAsking()) quiz.leave(); else stepping.go(at - 1); },
  });

  // What asks is loaded when somebody wants to be asked: until then nothing is.
  const noQuiz = {leave() {}, arrive() {}, holds: () => false, isAsking: () => false, untold: () => ''};
  let quiz = noQuiz, asker = null;
  async function predict() {
    try {
      const quizAbout = await loaded('quizAbout', 'quiz.js');
      quiz = asker ??= quizAbout({steps, entry, story, show: stepping.turnTo, entitle, inWords, tellPicture, place: () => at,
                                  keeps: !stage?.isChanged() && !lesson, isToldAbove: Boolean(lesson), answered: isRight => lesson?.answered(isRight),
                                  onPicture: (k, answer) => stage?.ask(k, answer) ?? false});
      quiz.toggle();
    } catch (error) {
      $('live').textContent = error.message;
    }
  }
  function offerQuestions() {
    const wasAsking = $('predict').ariaPressed === 'true';
    quiz.leave();
    quiz = noQuiz;
    asker = null;
    $('predict').setAttribute('aria-pressed', false);
    $('predict').hidden = !story.questions.length;
    $('unasked').hidden = story.questions.length > 0 || !story.unasked;
    if (wasAsking && story.questions.length) predict();  // of the other story
  }

  // -- Views of a picture, the usual one first, all around ------------------------------------------------------------

  const turns = frames[0].pictures.length - 1;
  const shotNow = () => steps[at].querySelector('.shot');
  const viewOf = shot => frames[at].pictures.indexOf(shot.firstElementChild.getAttribute('src'));
  function turnTo(shot, view) {
    const views = frames[at].pictures, place = (view % views.length + views.length) % views.length;
    shot.firstElementChild.src = views[place];
    $('live').textContent = `View ${place + 1} of ${views.length}`;
  }
  const turnBy = by => turnTo(shotNow(), viewOf(shotNow()) + by);
  const turning = {ArrowLeft: () => stage ? stage.turnBy(-15) : turnBy(-1), ArrowRight: () => stage ? stage.turnBy(15) : turnBy(1)};

  // -- What one presses, drags and swipes -----------------------------------------------------------------------------

  function letter(key) {
    if (!story.questions.length || !$('letters').checked) return null;
    if (key.toLowerCase() === 'p') return predict;
    return quiz.isAsking() && /^[1-9]$/.test(key) ? () => quiz.answer(key - 1) : null;
  }
  onKeys(event => {
    const act = ((turns || stage?.isInSpace()) && event.shiftKey && turning[event.key]) || stepping.keys[event.key] || letter(event.key);
    return act && isBare ? () => parent.postMessage({key: event.key}, '*') : act;
  });
  for (const [id, act] of [['predict', predict], ['turn-back', turning.ArrowLeft], ['turn-on', turning.ArrowRight]])
    $(id).addEventListener('click', act);
  addEventListener('popstate', () => {
    if (lesson) return;
    const scene = sceneOf(location.hash);
    if (stage && (scene ?? '') !== taken) restore(scene);
    else stepping.go(addressed(), 'stay');
  });

  // A swipe steps; where there are further views, it turns the picture, as buttons and keys do.
  let from = null;
  document.querySelector('main').classList.toggle('turns', turns > 0);
  for (const id of ['turn-back', 'turn-on', 'turning']) $(id).hidden = !turns;
  $('steps').addEventListener('pointerdown', event => {
    const shot = event.target.closest('.shot');
    from = null;
    if (!shot || !event.isPrimary || event.button !== 0) return;
    from = {x: event.clientX, y: event.clientY, shot, view: viewOf(shot)};
    if (turns) shot.setPointerCapture(event.pointerId);
  });
  addEventListener('pointermove', event => {
    if (!from || !turns) return;
    const width = from.shot.clientWidth / (turns + 1);
    turnTo(from.shot, Math.round((event.clientX - from.x) / width) + from.view);
  });
  addEventListener('pointerup', event => {
    if (!from) return;
    const x = event.clientX - from.x, y = event.clientY - from.y;
    from = null;
    const isSwipe = !turns && Math.abs(x) > 40 && Math.abs(x) > 2 * Math.abs(y);
    if (isSwipe) stepping.keys[x < 0 ? 'ArrowRight' : 'ArrowLeft']();
  });
  addEventListener('pointercancel', () => { from = null; });
  $('steps').addEventListener('dragstart', event => event.preventDefault());

  // -- Marks of iterations, decisions and the end ---------------------------------------------------------------------

  const latest = i => Math.max(...frames[i]?.iterations ?? [0]);
  function marksOf({iterations, kind}, i) {
    const isFirst = iterations && latest(i) !== latest(i - 1);
    return [isFirst && 'iteration', kind].filter(Boolean).map(className => {
      const textContent = className === 'iteration' && frames.length <= 80 ? latest(i) : '';
      const mark = make('span', {className, textContent});
      mark.style.left = `${100 * i / Math.max(1, frames.length - 1)}%`;
      return mark;
    });
  }

  let mostLines = 0;
  function fillPage() {
    const main = document.querySelector('main');
    for (const box of [$('quiz'), $('score')]) if (box.parentNode !== main) main.append(box);  // which a step may hold
    const kept = story.is_brief && isLike(steps[at], frames.find(Boolean)) ? steps[at] : null;
    steps = frames.map((frame, i) => frame && (kept ? becomes(kept, frame, i) : makeStep(frame, i)));
    if (kept) for (const other of [...$('steps').children]) other === kept || other.remove();
    else $('steps').replaceChildren(...steps.filter(Boolean));
    if (story.is_brief) return;
    mostLines = Math.max(mostLines, ...story.listings.map(lines => lines.length));  // also of a scene before: the box keeps its place
    $('steps').style.setProperty('--lines', mostLines);
    $('marks').replaceChildren(...frames.length <= 400 ? frames.flatMap(marksOf) : []);
    offerQuestions();
  }

  // Before printing all is there, also what nobody has looked at.
  const chooseHandout = () => document.documentElement.classList.toggle('strip', $('handout').value === 'strip');
  $('printing').hidden = false;
  $('handout').addEventListener('change', chooseHandout);
  $('print').addEventListener('click', () => print());
  chooseHandout();  // a browser may have kept the choice
  addEventListener('beforeprint', () => steps.forEach((step, i) => {
    complete(i);
    if (stage?.isChanged()) step.querySelector('.shot').replaceChildren(stage.drawn(i));
  }));

  // -- The program in the page ----------------------------------------------------------------------------------------

  const isDark = matchMedia('(prefers-color-scheme: dark)');
  const host = {
    name: entry.name, known: story.live?.file ?? entry.name, file: `${entry.name.split('/').at(-1)}.json`,
    frame: () => at,
    beside: () => lesson?.beside() ?? {},
    looks: () => ({theme: entry.is_dark || isDark.matches ? 'dark' : 'report', text: story.text_scale}),
    opened: () => lesson?.opened(),
    pause: () => stepping.go(at, 'stay'),
    say: text => { $('live').textContent = text; },
    changed(answer) {
      story = {...answer.story, text_scale: story.text_scale};
      frames = story.frames;
      title = lesson?.title ?? answer.title;
      offerTurns();
      fillPage();
      stepping.turnTo(answer.frame, 'stay');
      lesson?.told(answer);
    },
    async kept(scene, isOther) {  // `isOther`: a scene that came from elsewhere, and has a title of its own
      if (screens) return;
      taken = scene ? await packed(scene) : '';
      name = scene && !isOther ? `Changed: ${title}` : title;
      document.documentElement.classList.toggle('changed', Boolean(scene));
      entitle();
      history.replaceState(null, '', addressOf(at));
    },
  };
  const offerTurns = () => { for (const id of ['turn-back', 'turn-on']) $(id).hidden = !stage.isInSpace(); };
  async function begin() {
    const hash = location.hash;
    if (!runsPrograms()) {
      set($('lesson'), {hidden: !screens, textContent: 'The lesson needs WebAssembly, which this browser does not have. Its pictures stand here; nothing can be done in them.'});
      return;
    }
    const names = ['gjkstepProgram', 'gjkstepAllSearches'], {live, programs} = story;
    const program = await programFrom(i => loaded(names[i], programs[i]));
    const told = await program.asked({tell: live});
    if (told.error) throw Error(told.error.text);
    stage = stageOf(program, told, {...host, live});
    offerTurns();
    show(at, 'stay');
    performance.mark('first picture');
    isDark.addEventListener('change', () => stage.draw());
    if (screens) await openLesson(program);
    if (sceneOf(hash)) await restore(sceneOf(hash), stepOf(hash));
  }

  async function openLesson(program) {
    const lessonAbout = await loaded('lessonAbout', 'lesson.js');
    const asks = async wanted => {
      if (wanted !== ($('predict').ariaPressed === 'true')) await predict();
      if (wanted) stepping.keys.ArrowRight();
    };
    lesson = lessonAbout({title, screens, host, stage, asks, open: request => program.asked({tell: request})});
    name = title = lesson.title;
    await lesson.begin();
  }

  // The scene of an address; without one that of the page.
  const sceneOf = hash => hash.match(/^#scene=([\w-]+)/)?.[1] ?? null;
  async function restore(scene, step = addressed()) {
    try {
      if (scene) host.opened();
      await stage.restore(scene && await unpacked(scene));
      stepping.turnTo(step, 'stay');
    } catch {
      stage.complain('The address holds no whole scene: copy the link again.');
    }
  }

  document.documentElement.classList.toggle('bare', isBare);
  document.body.classList.add(groundOf(entry));
  if (story.text_scale !== 1) document.documentElement.style.fontSize = `${100 * story.text_scale}%`;
  cutOut($('steps'), entry.cut);
  fillPage();
  stepping.turnTo(addressed(), 'stay');
  if (story.live && !isBare) begin().catch(error => set($('lesson'), {hidden: false,
    textContent: `${error.message} So nothing can be taken hold of: copy the whole folder, or draw with --page=single.`}));
  addEventListener('load', keepInSight);  // the browser itself has gone to the step of the address by then
})();
