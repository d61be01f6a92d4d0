'use strict';
// Two walkthroughs that step together, iteration by iteration.
(() => {
  const groups = window.gjkstepGroups
    .map(({title, entries}) => ({title, searches: entries.filter(entry => entry.iteration_ends.length)}))
    .filter(group => group.searches.length);
  const searches = groups.flatMap(group => group.searches);
  const sides = ['left', 'right'].map($).map(select => {
    const optionsOf = group => group.searches.map(search => make('option', {textContent: search.title}));
    select.append(...groups.map(group => make('optgroup', {label: group.title}, ...optionsOf(group))));
    select.addEventListener('change', () => steps.turnTo(steps.at()));
    return {select, page: select.closest('div').querySelector('iframe'), shown: '', reading: 0};
  });
  const chosen = side => searches[side.select.selectedIndex];

  // The step of a walkthrough that ends iteration `at`, or the search where that has ended before.
  function turnTo(side, at) {
    const {name, iteration_ends: ends} = chosen(side);
    const address = `${name}/index.html#${ends[Math.min(at, ends.length - 1)] + 1}&bare`;
    if (side.shown === name) side.page.contentWindow.location.replace(new URL(address, location.href));
    else side.page.src = address;
    side.shown = name;
  }

  const steps = stepper({
    count: () => Math.max(...sides.map(side => chosen(side).iteration_ends.length)),
    show(at) {
      for (const side of sides) turnTo(side, at);
      history.replaceState(null, '', '#' + [...sides.map(side => encodeURI(chosen(side).name)), at + 1].join(','));
    },
    reading: () => Math.max(...sides.map(side => side.reading)),  // as long as it takes to read what is said in either
  });

  const decoded = text => { try { return decodeURIComponent(text); } catch { return ''; } };

  // "#figure-4-left,figure-4-right,3"
  function readAddress() {
    const [left, right, number] = location.hash.slice(1).split(',');
    const placeOf = name => searches.findIndex(search => search.name === name);
    [left, right].forEach((name, s) => {
      const asked = placeOf(decoded(name)), usual = placeOf(['figure-4-left', 'figure-4-right'][s]);
      const taken = s === 1 ? sides[0].select.selectedIndex : -1;  // the right one is another, unless asked for
      sides[s].select.selectedIndex = asked >= 0 ? asked : [usual, 0, 1].find(i => i >= 0 && i !== taken);
    });
    steps.turnTo(Number(number) - 1 || 0);
  }

  onKeys(event => steps.keys[event.key]);
  // A walkthrough that is shown here passes its keys on, and how long it takes to read what it says.
  addEventListener('message', event => {
    const side = sides.find(each => each.page.contentWindow === event.source);
    if (!side) return;
    steps.keys[event.data.key]?.();
    side.reading = event.data.reading ?? side.reading;
    if (event.data.reading) steps.restart();
  });
  addEventListener('hashchange', readAddress);
  readAddress();
})();
