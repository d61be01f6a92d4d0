'use strict';
(() => {
  const data = JSON.parse(document.getElementById('data').textContent);
  const $ = id => document.getElementById(id);
  const sides = [$('left'), $('right')].map(select => ({select, page: select.closest('div').querySelector('iframe'), shown: ''}));
  const chosen = side => data[side.select.selectedIndex];
  const count = () => Math.max(...sides.map(side => chosen(side).last.length));
  let at = 0;

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

  const keys = {ArrowLeft: () => show(at - 1), ArrowRight: () => show(at + 1), Home: () => show(0), End: () => show(count() - 1)};
  document.addEventListener('keydown', event => {
    if (event.ctrlKey || event.metaKey || event.altKey || !keys[event.key] || event.target.closest('select')) return;
    event.preventDefault();
    keys[event.key]();
  });
  // A walkthrough that is shown here passes its keys on.
  addEventListener('message', event => { if (sides.some(side => side.page.contentWindow === event.source)) keys[event.data.key]?.(); });
  for (const [id, act] of [['first', keys.Home], ['back', keys.ArrowLeft], ['next', keys.ArrowRight], ['last', keys.End]])
    $(id).addEventListener('click', act);
  $('slider').addEventListener('input', () => show($('slider').value - 1));
  for (const side of sides) side.select.addEventListener('change', () => show(at));
  addEventListener('hashchange', readAddress);

  readAddress();
})();
