'use strict';
(() => {
  const wordsOf = text => text.toLowerCase().split(/[\s/,;:()"“”·-]+/).filter(Boolean);
  // As one begins to write it, but a number is whole: "m1" is not M18, nor "4" the report's 7474.
  const fits = (word, wanted) => /\d$/.test(wanted) ? `${word}.`.startsWith(`${wanted}.`) : word.startsWith(wanted);
  const [words, answer, part] = ['words', 'answer', 'part'].map(id => document.getElementById(id));
  const groups = [...document.querySelectorAll('.group')];
  const titleOf = group => group.querySelector('h2').textContent;
  const cards = groups.flatMap(group => [...group.querySelectorAll('.card')].map(card => ({
    card, part: titleOf(group), text: wordsOf(titleOf(group) + ' ' + card.textContent.replace(/ARL-TR-7474|\d+ steps?/g, ''))})));

  function filter() {
    const wanted = wordsOf(words.value);
    let count = 0;
    for (const {card, part: own, text} of cards) {
      card.hidden = !wanted.every(word => text.some(each => fits(each, word))) || !card.dataset.answer.includes(answer.value) ||
        !['', own].includes(part.value);
      count += !card.hidden;
    }
    for (const group of groups) group.hidden = !group.querySelector('.card:not([hidden])');
    document.getElementById('found').textContent = count ? `${count} shown` : 'none fits: try fewer words, any answer, all parts';
  }
  // What is looked for stands in the address, so that one comes back to it.
  function keep() {
    const said = new URLSearchParams([words, answer, part].map(({id, value}) => [id, value]).filter(([, value]) => value));
    history.replaceState(null, '', '#' + said);
    filter();
  }
  function restore() {
    const said = new URLSearchParams(location.hash.slice(1));
    for (const field of [words, answer, part]) field.value = said.get(field.id) || '';
    for (const choice of [answer, part]) choice.selectedIndex = Math.max(0, choice.selectedIndex);
    filter();
  }
  words.addEventListener('input', keep);
  for (const choice of [answer, part]) choice.addEventListener('change', keep);
  addEventListener('pageshow', restore);
  document.getElementById('filters').addEventListener('submit', event => event.preventDefault());
})();
