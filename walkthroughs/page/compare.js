'use strict';
(() => {
  const data = JSON.parse(document.getElementById('data').textContent);
  const $ = id => document.getElementById(id);
  const sides = [$('left'), $('right')].map(select => ({select, page: select.closest('div').querySelector('iframe'), shown: '', reading: 0}));
  const chosen = side => data[side.select.selectedIndex];
  const count = () => Math.max(...sides.map(side => chosen(side).last.length));
  let at = 0, timer = 0;

  // The step of a walkthrough that ends iteration `at`, or the search where that has ended before.
  function turnTo(side) {
    const {name, last} = chosen(side), address = `${name}/index.html#${last[Math.min(at, last.length - 1)] + 1}&bare`;
    if (side.shown === name) side.page.contentWindow.location.replace(new URL(address, location.href));
    else side.page.src = address;
    side.shown = name;
  }

  function show(i) {
    at = Math.max(0, Math.min(count() - 1, i));
    sides.forEach(turnTo);
    $('slider').max = count();
    $('slider').value = at + 1;
    $('place').textContent = `${at + 1} / ${count()}`;
    $('first').disabled = $('back').disabled = at === 0;
    $('next').disabled = $('last').disabled = at === count() - 1;
    history.replaceState(null, '', '#' + [...sides.map(side => encodeURI(chosen(side).name)), at + 1].join(','));
  }

  const decoded = text => { try { return decodeURIComponent(text); } catch { return ''; } };

  // "#figure-4-left,figure-4-right,3"
  function readAddress() {
    const [left, right, number] = location.hash.slice(1).split(',');
    [left, right].forEach((name, s) => {
      const place = data.findIndex(each => each.name === decoded(name));
      const usual = data.findIndex(each => each.name === ['figure-4-left', 'figure-4-right'][s]);
      const taken = s === 1 ? sides[0].select.selectedIndex : -1;  // the right one is another, unless somebody asks for it
      sides[s].select.selectedIndex = place >= 0 ? place : [usual, 0, 1].find(i => i >= 0 && i !== taken);
    });
    show(Number(number) - 1 || 0);
  }

  // As long as it takes to read what is said in either.
  function playOn() {
    clearTimeout(timer);
    timer = setTimeout(() => {
      show(at + 1);
      if (at + 1 < count()) playOn(); else pause();
    }, Math.max(...sides.map(side => side.reading)));
  }
  function pause() {
    clearTimeout(timer);
    timer = 0;
    $('play').textContent = 'Play';
  }
  function play() {
    if (timer) return pause();
    if (at + 1 === count()) show(0);
    $('play').textContent = 'Pause';
    playOn();
  }
  const go = i => { pause(); show(i); };

  const keys = {ArrowLeft: () => go(at - 1), ArrowRight: () => go(at + 1), Home: () => go(0), End: () => go(count() - 1), ' ': play};
  document.addEventListener('keydown', event => {
    if (event.ctrlKey || event.metaKey || event.altKey || !keys[event.key] || event.target.closest('select')) return;
    if (event.key === ' ' && event.target.closest('button, a')) return;
    event.preventDefault();
    keys[event.key]();
  });
  // A walkthrough that is shown here passes its keys on, and how long it takes to read what it says.
  addEventListener('message', event => {
    const side = sides.find(each => each.page.contentWindow === event.source);
    if (!side) return;
    keys[event.data.key]?.();
    side.reading = event.data.reading ?? side.reading;
    if (timer && event.data.reading) playOn();
  });
  for (const [id, act] of [['first', keys.Home], ['back', keys.ArrowLeft], ['next', keys.ArrowRight], ['last', keys.End], ['play', play]])
    $(id).addEventListener('click', act);
  $('slider').addEventListener('input', () => go($('slider').value - 1));
  for (const side of sides) side.select.addEventListener('change', () => show(at));
  addEventListener('hashchange', readAddress);

  readAddress();
})();
