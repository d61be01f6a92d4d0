'use strict';
// The screens of the lesson: an idea, a picture to take hold of, and something to do there. Whether it is done the program says.

// `open(request)`: promises the answer of the program about a screen. `asks(wanted)`: asks what the next step will be, or nothing any more.
function lessonAbout({title, screens, host, stage, asks, open}) {
  const shelf = `gjkstep lesson ${location.pathname}`;
  const kept = stored(shop => JSON.parse(shop.getItem(shelf)));
  const done = new Set(Array.isArray(kept) ? kept.filter(place => place in screens) : []);
  let at = 0, isOpen = false;

  const button = (text, act) => {
    const made = make('button', {type: 'button', textContent: text});
    made.addEventListener('click', act);
    return made;
  };
  const dots = screens.map((_, i) => button(i + 1, () => go(i)));
  const list = make('ol', {className: 'screens', ariaLabel: 'Screens'}, ...dots.map(dot => make('li', {}, dot)));
  const heading = make('h2', {id: 'screen', tabIndex: -1}), idea = make('p'), task = make('p', {className: 'task'});
  const verdict = make('p', {className: 'done', role: 'status'}), hint = make('p', {className: 'small', role: 'status'});
  const hints = button('Hint', () => { hint.replaceChildren(...marked(`Hint: ${screens[at].hint}`)); });
  const anew = button('Begin again', () => go(at, null));
  const back = button('← Back', () => go(at - 1)), next = button('Next →', () => go(at + 1)), more = make('a');
  $('lesson').replaceChildren(list, heading, idea, task, verdict, make('p', {className: 'row'}, hints, anew, back, next, more), hint);
  $('lesson').hidden = false;
  document.documentElement.classList.add('lesson');

  function fillDots() {
    dots.forEach((dot, i) => {
      dot.className = done.has(i) ? 'finished' : '';
      dot.ariaLabel = `Screen ${i + 1}: ${screens[i].title}${done.has(i) ? ', done' : ''}`;
      if (i === at) dot.setAttribute('aria-current', 'page'); else dot.removeAttribute('aria-current');
    });
  }
  function fill() {
    const screen = screens[at];
    heading.replaceChildren(...marked(`${at + 1}. ${screen.title}`));
    idea.replaceChildren(...marked(screen.idea));
    task.replaceChildren(...marked(screen.task + (screen.doing === 'answer' ? ' Press it in the picture.' : '')));
    for (const box of [verdict, hint]) box.replaceChildren();
    back.disabled = at === 0;
    next.hidden = at + 1 === screens.length;
    next.className = '';
    more.hidden = !screen.page;
    set(more, {href: screen.page, textContent: `More: ${screen.name}`});
    fillDots();
    hidesWords(screen.is_before_search || screen.doing === 'draw');
  }
  const hidesWords = hides => document.documentElement.classList.toggle('untold-steps', hides);  // which tell what is to be drawn, or more than is known yet

  function finish() {
    if (verdict.hasChildNodes()) return;
    hidesWords(screens[at].is_before_search);
    hint.replaceChildren();
    done.add(at);
    stored(shop => shop.setItem(shelf, JSON.stringify([...done])));
    verdict.replaceChildren(make('b', {textContent: '✓ Done. '}), ...marked(screens[at].seen));
    next.className = 'strong';
    fillDots();
    verdict.scrollIntoView({block: 'nearest'});  // on a phone the picture stands below
  }
  function say(words) {
    hint.textContent = words;
    hint.scrollIntoView({block: 'nearest'});
  }

  // A screen begins anew, whatever was done there.
  async function go(place, how = 'pushState') {
    at = Math.max(0, Math.min(screens.length - 1, place));
    if (how) history[how](null, '', `#screen-${at + 1}`);
    Object.assign(host, {name: screens[at].name, known: screens[at].name, file: `${screens[at].name.split('/').at(-1)}.json`});
    isOpen = false;
    host.say('');
    stage.close();
    fill();
    await asks(false);
    const answer = await open({name: screens[at].name, screen: at});
    stage.ask(null);
    stage.begin(answer);
    isOpen = true;
    if (screens[at].doing === 'draw') stage.ask('direction', drawn);
    if (screens[at].doing === 'answer') await asks(true);  // which takes the focus
    else heading.focus({preventScroll: true});
  }
  function drawn(choice) {
    if (choice !== null) return finish();
    say('Not that way. Draw again, or ask for the hint.');
  }

  const addressed = () => (location.hash.match(/^#screen-(\d+)$/)?.[1] ?? [...screens.keys(), 0].find(i => !done.has(i)) + 1) - 1;
  addEventListener('popstate', () => go(addressed(), null));
  return {
    title,
    begin: () => go(addressed(), 'replaceState'),
    beside: () => ({screen: at}),
    // A scene of one's own belongs to the last screen.
    opened() {
      at = screens.length - 1;
      history.replaceState(null, '', `#screen-${at + 1}`);
      stage.ask(null);
      fill();
    },
    told: ({is_done: isDone, story}) => { if (isOpen && isDone && !story.is_brief) finish(); },  // not while one drags
    answered(isRight) {
      if (isRight) finish();
      else say('Begin again to be asked anew.');
    },
  };
}
