'use strict';
(() => {
  const wordsOf = text => text.toLowerCase().split(/[\s/,;:()"“”·-]+/).filter(Boolean);
  // As one begins to write it, but a number is whole: "m1" is not M18, nor "4" the report's 7474.
  const fits = (word, wanted) => /\d$/.test(wanted) ? `${word}.`.startsWith(`${wanted}.`) : word.startsWith(wanted);
  const words = document.getElementById('words'), answer = document.getElementById('answer');
  const groups = [...document.querySelectorAll('.group')];
  const cards = groups.flatMap(group => [...group.querySelectorAll('.card')].map(
    card => [card, wordsOf(group.querySelector('h2').textContent + ' ' + card.textContent.replace(/ARL-TR-7474|\d+ steps?/g, ''))]));

  function filter() {
    const wanted = wordsOf(words.value);
    let count = 0;
    for (const [card, text] of cards) {
      card.hidden = !wanted.every(word => text.some(each => fits(each, word))) || !card.dataset.answer.includes(answer.value);
      count += !card.hidden;
    }
    for (const group of groups) group.hidden = !group.querySelector('.card:not([hidden])');
    document.getElementById('found').textContent = count ? `${count} shown` : 'none has all of these words: try fewer, or another answer';
  }
  // What is looked for stands in the address, so that one comes back to it.
  function keep() {
    const said = new URLSearchParams(Object.entries({words: words.value, answer: answer.value}).filter(([, value]) => value));
    history.replaceState(null, '', '#' + said);
    filter();
  }
  function restore() {
    const said = new URLSearchParams(location.hash.slice(1));
    words.value = said.get('words') || '';
    answer.value = said.get('answer') || '';
    filter();
  }
  words.addEventListener('input', keep);
  answer.addEventListener('change', keep);
  addEventListener('pageshow', restore);
  document.getElementById('filters').addEventListener('submit', event => event.preventDefault());
})();
