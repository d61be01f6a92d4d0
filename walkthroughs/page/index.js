'use strict';
// Cards of all walkthroughs, and what one looks for among them.
(() => {
  const answerOf = entry => [...new Set(entry.answers)].join(', ');
  function card(entry) {
    const picture = make('span', {className: 'shot'}, make('img', {loading: 'lazy', alt: '', src: entry.picture_url}));
    cutOut(picture, entry.cut);
    return make('li', {className: `card ${groundOf(entry)}`},
      make('a', {href: `${entry.name}/index.html`}, picture, make('strong', {dir: 'auto', textContent: entry.title})),
      make('p', {}, ...marked(entry.sentence)),
      make('p', {className: 'small'},
        `${entry.section && `${entry.section} · `}${entry.steps} ${entry.steps === 1 ? 'step' : 'steps'}`,
        ...entry.answers.length ? [' · ', make('b', {textContent: answerOf(entry)})] : [],
        ' ', make('br'), make('code', {textContent: entry.name})));
  }

  const wordsOf = text => text.toLowerCase().split(/[\s/,;:()"“”·-]+/).filter(Boolean);
  // As one begins to write it, but a number is whole: "m1" is not M18, nor "4" the report's 7474.
  const fits = (word, wanted) => /\d$/.test(wanted) ? `${word}.`.startsWith(`${wanted}.`) : word.startsWith(wanted);
  // What people also call it; a walkthrough that has any of these words fits.
  const alsoCalled = {
    touch: ['touching'], contact: ['touch', 'touching'], overlap: ['intersect'], collide: ['intersect'], collision: ['intersect'],
    voronoi: ['region', 'regions'], separating: ['separated'], axis: ['separated'], sat: ['separated'], mapping: ['support'],
    minkowski: ['difference'], witness: ['certificate'], predicate: ['sign'], filter: ['proven'], degenerate: ['zero'],
    bug: ['mistake'], infinite: ['circle'], loop: ['circle'], cycle: ['circle'], precision: ['float', 'rounded'],
  };
  // What is not here, so that nobody looks for long.
  const depth = 'gjkstep decides whether objects intersect, not how deep';
  const distance = 'gjkstep decides whether objects intersect, not how far apart they are';
  const notHere = {epa: depth, penetration: depth, depth, manifold: depth, distance, mpr: 'gjkstep shows GJK only',
                   xenocollide: 'gjkstep shows GJK only'};
  const [words, answer, part] = ['words', 'answer', 'part'].map($);
  const groups = window.gjkstepGroups.map(({title, entries}) => {
    const cards = entries.map(entry => {
      const made = card(entry), said = [...made.querySelectorAll('strong, p')].map(each => each.textContent).join(' ');
      const text = [...wordsOf(`${title} ${said.replace(/ARL-TR-7474|\d+ steps?/g, '')}`), ...entry.words.split(' ')];
      return {card: made, name: entry.name, part: title, text, answer: answerOf(entry)};
    });
    const list = make('ul', {className: 'cards'}, ...cards.map(each => each.card));
    return {title, cards, section: make('section', {className: 'group'}, make('h2', {textContent: title}), list)};
  });

  function filter() {
    const wanted = wordsOf(words.value), typed = words.value.toLowerCase().trim();
    // Part of a name ("adb-edge-ad") means that name, not captions that hold all its words.
    const isName = /[-/]/.test(typed) && groups.some(({cards}) => cards.some(({name}) => name.includes(typed)));
    let count = 0;
    for (const {cards, section} of groups) {
      for (const {card, name, part: own, text, answer: found} of cards) {
        const has = word => text.some(each => fits(each, word));
        const isWanted = isName ? name.includes(typed) : wanted.every(word => has(word) || alsoCalled[word]?.some(has));
        card.hidden = !isWanted || !found.includes(answer.value) || !['', own].includes(part.value);
        count += !card.hidden;
      }
      section.hidden = cards.every(each => each.card.hidden);
    }
    const missing = wanted.find(word => notHere[word]);
    $('found').textContent = count ? `${count} shown`
      : missing ? `nothing about “${missing}”: ${notHere[missing]}` : 'none fits: try fewer words, any answer, all parts';
  }
  // What is looked for stands in the address, so that one comes back to it.
  function keep() {
    const filled = [words, answer, part].filter(field => field.value);
    const said = new URLSearchParams(filled.map(({id, value}) => [id, value]));
    history.replaceState(null, '', '#' + said);
    filter();
  }
  function restore() {
    const said = new URLSearchParams(location.hash.slice(1));
    for (const field of [words, answer, part]) field.value = said.get(field.id) || '';
    for (const choice of [answer, part]) choice.selectedIndex = Math.max(0, choice.selectedIndex);
    filter();
  }

  $('cards').replaceChildren(...groups.map(group => group.section));
  part.append(...groups.map(({title}) => make('option', {textContent: title})));
  $('start').hidden = window.gjkstepGroups[0]?.entries[0].name !== 'lesson';
  const isSearch = entry => entry.iteration_ends.length > 0;
  $('compare').hidden = window.gjkstepGroups.flatMap(group => group.entries).filter(isSearch).length < 2;
  words.addEventListener('input', keep);
  for (const choice of [answer, part]) choice.addEventListener('change', keep);
  addEventListener('pageshow', restore);
  $('filters').addEventListener('submit', event => event.preventDefault());
})();
