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
    data.listings[listing].lines.forEach(([indent, html], i) => {
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

  // The scenes with all of their events stand in the page, or in a script beside it that is loaded when somebody asks.
  function withScenes(use, fail) {
    const inside = $('events');
    if (inside) return use(JSON.parse(inside.textContent));
    if (window.gjkstepEvents) return use(window.gjkstepEvents);
    const script = make('script');
    script.addEventListener('load', () => use(window.gjkstepEvents));
    script.addEventListener('error', fail);
    script.src = 'events.js';
    document.head.append(script);
  }

  function addEvents(step, ranges) {
    if (!ranges || step.querySelector('.events')) return;
    const details = make('details', 'events');
    details.append(make('summary', '', 'Events as JSON'));
    details.addEventListener('toggle', () => {
      if (details.querySelector('pre')) return;
      const text = make('pre');
      details.append(text);
      withScenes(scenes => {
        const lines = ranges.flatMap(([first, last], s) =>
          scenes[s].events.slice(first, last + 1).map(event => JSON.stringify({scene: scenes[s].name, ...event})));
        text.textContent = lines.join('\n');
      }, () => { text.textContent = 'The file events.js, which belongs beside this page, is not there.'; });
    });
    step.querySelector('.text').append(details);
  }

  function complete(i) {
    boxesOf(i).forEach((box, b) => fillCode(box, data.steps[i].code[b]));
    addEvents(steps[i], data.steps[i].events);
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
    close();
    steps[at].classList.remove('now');
    steps[at = i].classList.add('now');
    hideWords(openQuestion() >= 0);
    complete(i);
    $('slider').value = i + 1;
    $('slider').setAttribute('aria-valuetext', steps[i].querySelector('.where').textContent);
    $('place').textContent = `${i + 1} / ${steps.length}`;
    for (const [id, end] of [['first', 0], ['back', 0], ['next', steps.length - 1], ['last', steps.length - 1]])
      $(id).disabled = i === end;
    keepInSight();
    if (moved) $('live').textContent = said(i);
    if (moved) skipped.clear();
    if (predicting && i === steps.length - 1) showScore();
    entitle();
    if (how !== 'stay' && moved) history[how === 'push' ? 'pushState' : 'replaceState'](null, '', `#${i + 1}`);
  }

  // Titles tell how it ends: not before the score does.
  function entitle() {
    const isOpen = predicting && $('score').hidden;
    document.title = `${at + 1}/${steps.length} ${isOpen ? untold : title}`;
    heading.textContent = isOpen ? untold : name;
    for (const told of [$('summary'), ...document.querySelectorAll('.made')]) told.hidden = isOpen;
  }

  const go = i => { pause(); show(i, 'push'); };
  const back = () => { if (asked === null) go(at - 1); else close(); };
  function forward() {
    pause();
    if (asked !== null && answers[asked] === null) $('verdict').textContent = 'Choose one, or skip.';
    else if (!stopsToAsk()) show(at + 1, 'push');
  }
  const addressed = () => /^#\d+(&bare)?$/.test(location.hash) ? parseInt(location.hash.slice(1), 10) - 1 : 0;

  // -- Playing --------------------------------------------------------------------------------------------------------

  // As long as it takes to read what is said.
  const readingTime = i => Math.min(9000, 1500 + 25 * said(i).length);

  function playOn() {
    timer = setTimeout(() => {
      if (stopsToAsk()) return pause();
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

  // Texts of questions, choices and reasons are HTML that the program has made, with <sub> for subscripts.
  const questions = data.questions.map(question => ({...question, text: data.texts[question.text],
                                                     choices: question.choices.map(places => places.map(place => data.texts[place]))}));
  const shelf = `gjkstep ${location.pathname} ${data.name} ${questions.length}`;  // of two files with one name neither has the other's
  const kinds = {crossing: 'Was the origin crossed', region: 'Regions', vertices: 'Which vertices stay', direction: 'Where the search goes on',
                 line: 'Which line is wrong'};
  const isAboutLine = questions.length > 0 && questions.every(question => question.kind === 'line');
  const untold = isAboutLine ? 'Which line is wrong?' : 'What will the search find?', skipped = new Set();
  const nothing = () => questions.map(() => null);
  let answers = nothing(), predicting = false, asked = null, isTold = false;

  // The store of the browser, where it has one and allows it; else answers live as long as the page.
  function store(act) { try { return act(localStorage); } catch { return null; } }
  function restore() {
    const kept = store(shop => JSON.parse(shop.getItem(shelf)));
    if (Array.isArray(kept) && kept.length === questions.length) answers = kept;
  }

  // The question still to be answered before the next step; -1 where there is none.
  const openQuestion = () => predicting ? questions.findIndex((question, k) => question.before === at + 1 && answers[k] === null && !skipped.has(k)) : -1;
  function stopsToAsk() {
    const k = openQuestion();
    if (k >= 0) ask(k);
    return k >= 0;
  }

  function ask(k) {
    asked = k;
    isTold = false;
    $('question').innerHTML = questions[k].text;
    $('choices').replaceChildren(...questions[k].choices.map(([text], c) => {
      const line = make('li'), button = Object.assign(make('button'), {type: 'button', innerHTML: text});
      button.addEventListener('click', () => answer(c));
      line.append(button);
      return line;
    }));
    $('verdict').textContent = '';
    $('onward').textContent = 'Skip';
    steps[at].querySelector('.text').prepend($('quiz'));
    steps[at].classList.add('asking');
    hideWords(true);
    mark(false);
    $('quiz').hidden = false;
    $('question').focus();
  }

  const isOff = button => button.disabled || button.getAttribute('aria-disabled') === 'true';

  // The first answer counts. Who is wrong may try once more where that is no sure thing, or look.
  function answer(c) {
    const {choices, right} = questions[asked], buttons = [...$('choices').querySelectorAll('button')];
    if (!buttons[c] || isOff(buttons[c])) return;
    const isFirst = answers[asked] === null;
    if (isFirst) {
      answers[asked] = c;
      store(shop => shop.setItem(shelf, JSON.stringify(answers)));
    }
    if (c !== right && isFirst && choices.length > 2) {
      buttons[c].classList.add('wrong');
      buttons[c].setAttribute('aria-disabled', 'true');  // and keeps the focus, so that Tab goes on from there
      $('verdict').innerHTML = `${notSo(choices[c][2])} Try once more.`;
      $('onward').textContent = 'Show the answer';
      $('onward').scrollIntoView({block: 'nearest'});
    } else {
      tell(buttons, c);
    }
  }

  const notSo = why => why ? `Not so: ${why}.` : 'Not so.';

  function tell(buttons, c) {
    const {choices, right} = questions[asked], reason = choices[right][1];
    isTold = true;
    for (const button of buttons) button.disabled = true;
    buttons[c].classList.add('wrong');
    buttons[right].className = 'right';
    $('verdict').innerHTML = c === right ? `Right: ${reason}.`
      : `${notSo(choices[c][1] === reason ? '' : choices[c][1])} The answer is <b>“${choices[right][0]}”</b>: ${reason}.`;
    $('onward').textContent = 'Go on';
    hideWords(false);
    $('onward').focus();
  }

  // The lines that run, which tell what is asked.
  function mark(isShown) {
    boxesOf(at).forEach((box, b) => {
      const line = box.querySelectorAll('li')[data.steps[at].code[b][1]];
      if (line && isShown) line.setAttribute('aria-current', 'step'); else line?.removeAttribute('aria-current');
    });
  }

  // What is told of the picture tells where the origin lies.
  function hideWords(hides) {
    const picture = steps[at].querySelector('img');
    picture.dataset.words ??= picture.alt;
    picture.alt = hides ? 'The picture; it is told in words once the question is answered.' : picture.dataset.words;
  }

  function close() {
    asked = null;
    hideWords(openQuestion() >= 0);
    mark(true);
    $('quiz').hidden = $('score').hidden = true;
    steps[at].classList.remove('asking');
  }

  function onward() {
    const first = answers[asked];
    if (first !== null && !isTold) return tell([...$('choices').querySelectorAll('button')], first);
    if (first === null) skipped.add(asked);
    if (stopsToAsk()) return;
    show(at + 1, 'push');
    $(at + 1 < steps.length ? 'next' : 'first').focus({preventScroll: true});  // the button that was pressed is gone
  }

  function showScore() {
    const given = questions.filter((question, k) => answers[k] !== null);
    const right = (question, k) => answers[k] === question.right;
    $('points').textContent = given.length ? `${questions.filter(right).length} of ${questions.length} right` +
      (given.length < questions.length ? `, ${questions.length - given.length} not answered` : '') : 'No question answered yet';
    const list = make('ul');
    let missesPages = false;
    for (const [kind, name] of Object.entries(kinds)) {
      const ours = questions.map((question, k) => [question, k]).filter(([question, k]) => question.kind === kind && answers[k] !== null);
      const wrong = ours.filter(([question, k]) => !right(question, k));
      if (!ours.length) continue;
      const line = make('li', wrong.length ? 'no' : 'yes', `${name}: ${ours.length - wrong.length} of ${ours.length}`);
      const practice = new Map(wrong.map(([question]) => question.practice).filter(([title]) => title));
      let between = '; practise with ';
      for (const [title, url] of practice) {  // where there is no page, its name
        line.append(between, url ? Object.assign(make('a', '', title), {href: url}) : make('code', '', title));
        missesPages ||= !url;
        between = ', ';
      }
      list.append(line);
    }
    $('kinds').replaceChildren(list);
    if (missesPages) $('kinds').append(make('code', '', 'gjkstep render regions --page'), ' makes these pages.');
    steps[at].querySelector('.text').prepend($('score'));
    $('score').hidden = false;
    $('forget').hidden = !given.length;
    $('score').scrollIntoView({block: 'nearest'});
    if (given.length) $('live').textContent = $('points').textContent;
  }

  function predict() {
    predicting = !predicting;
    $('predict').setAttribute('aria-pressed', predicting);
    close();
    skipped.clear();
    const isOver = predicting && !answers.includes(null);
    if (isOver || (predicting && at === steps.length - 1)) showScore();
    entitle();
    $('live').textContent = isOver ? 'All questions have been answered; who forgets the answers is asked again.'
      : predicting ? `${isAboutLine ? 'Where the searches part' : 'Before each decision'} a question will be asked.` : 'No questions will be asked.';
  }

  function forget() {
    answers = nothing();
    store(shop => shop.removeItem(shelf));
    show(0, 'push');
    $('next').focus();
  }

  restore();
  $('predict').hidden = !questions.length;
  $('onward').addEventListener('click', onward);
  $('forget').addEventListener('click', forget);

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
  const hasQuestions = () => questions.length && $('letters').checked;
  function letter(key) {
    if (!hasQuestions()) return null;
    if (key.toLowerCase() === 'p') return predict;
    return asked !== null && /^[1-9]$/.test(key) ? () => answer(key - 1) : null;
  }
  document.addEventListener('keydown', event => {
    const act = (turns && event.shiftKey && turning[event.key]) || keys[event.key] || letter(event.key);
    if (event.ctrlKey || event.metaKey || event.altKey || event.isComposing || !act) return;
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
  $('steps').classList.toggle('turns', turns > 0);
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
  addEventListener('beforeprint', () => steps.forEach((step, i) => complete(i)));

  document.documentElement.classList.toggle('bare', isBare);
  show(addressed(), 'stay');
  addEventListener('load', keepInSight);  // the browser itself has gone to the step of the address by then
})();
