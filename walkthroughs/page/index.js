'use strict';
(() => {
  const words = document.getElementById('words'), answer = document.getElementById('answer');
  const groups = [...document.querySelectorAll('.group')];
  const cards = [...document.querySelectorAll('.card')].map(card => [card, card.textContent.toLowerCase()]);

  function filter() {
    const wanted = words.value.toLowerCase().split(/\s+/).filter(Boolean);
    let count = 0;
    for (const [card, text] of cards) {
      card.hidden = !wanted.every(word => text.includes(word)) || !card.dataset.answer.includes(answer.value);
      count += !card.hidden;
    }
    for (const group of groups) group.hidden = !group.querySelector('.card:not([hidden])');
    document.getElementById('found').textContent = `${count} shown`;
  }
  words.addEventListener('input', filter);
  answer.addEventListener('change', filter);
  document.getElementById('filters').addEventListener('submit', event => event.preventDefault());
  if (words.value || answer.value) filter();  // of a page that the browser has restored
})();
