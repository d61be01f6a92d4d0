'use strict';
// Asks before each decision what will be found.
// `keeps`: whether answers outlive the page; those about a changed scene do not.
// `isToldAbove`: whether what is asked stands above the picture, too. `onPicture(k, answer)`: asks there, too, and returns whether it can; of null no longer. `answered(isRight)`: once the answer is shown.
function quizAbout({steps, entry, story, show, entitle, inWords, tellPicture, place, keeps, isToldAbove, onPicture, answered}) {
  const textOf = place => story.texts[place];
  const questions = story.questions.map(question => (
    {...question, text: textOf(question.text), choices: question.choices.map(choice => choice.map(textOf))}));
  const shelf = `gjkstep ${location.pathname} ${entry.name} ${questions.length}`;  // of two files each has its own
  const kinds = {crossing: 'Was the origin crossed', region: 'Regions', vertices: 'Which vertices stay',
                 direction: 'Where the search goes on', line: 'Which line is wrong'};
  const hidden = 'The picture; it is told in words once the question is answered.';
  const isAboutLine = questions.length > 0 && questions.every(question => question.kind === 'line');
  const untold = isAboutLine ? 'Which line is wrong?' : 'What will the search find?', skipped = new Set();
  const nothing = () => questions.map(() => null);
  const now = () => steps[place()], isAtEnd = () => place() === steps.length - 1;
  const store = act => keeps ? stored(act) : null;
  const kept = store(shop => JSON.parse(shop.getItem(shelf)));
  let answers = Array.isArray(kept) && kept.length === questions.length ? kept : nothing();
  let predicting = false, asked = null, isTold = false;

  // The question still to be answered before the next step; -1 where there is none.
  const isOpen = (question, k) => question.before === place() + 1 && answers[k] === null && !skipped.has(k);
  const openQuestion = () => predicting ? questions.findIndex(isOpen) : -1;
  function stopsToAsk() {
    const k = openQuestion();
    if (k >= 0) ask(k);
    return k >= 0;
  }

  function holds() {
    if (asked === null || answers[asked] !== null) return stopsToAsk();
    $('verdict').textContent = 'Choose one, or skip.';
    return true;
  }

  function ask(k) {
    asked = k;
    isTold = false;
    $('question').replaceChildren(...marked(questions[k].text));
    $('choices').replaceChildren(...questions[k].choices.map(([text], c) => {
      const button = make('button', {type: 'button'}, ...marked(text));
      button.addEventListener('click', () => answer(c));
      return make('li', {}, button);
    }));
    $('verdict').textContent = '';
    $('onward').textContent = 'Skip';
    now().querySelector('.told').prepend($('quiz'));
    now().classList.add('asking');
    now().classList.toggle('asks-crossing', questions[k].kind === 'crossing');
    hideWords(true);
    mark(false);
    $('quiz').hidden = false;
    const isAimed = onPicture(k, c => c === null ? $('verdict').textContent = 'No way on leads there: draw again.' : answer(c));
    $('in-words').open = !isAimed;
    if (isAimed) $('verdict').textContent = questions[k].kind === 'direction' ? 'Draw an arrow in the picture.' : 'Press it in the picture.';
    $('question').focus({preventScroll: isAimed && isToldAbove});  // then the picture stays in sight
  }

  // The first answer counts. Who is wrong may try once more where that is no sure thing, or look.
  function answer(c) {
    const {choices, right} = questions[asked], buttons = [...$('choices').querySelectorAll('button')];
    if (!buttons[c] || buttons[c].matches(':disabled, [aria-disabled]')) return;
    const isFirst = answers[asked] === null;
    if (isFirst) {
      answers[asked] = c;
      store(shop => shop.setItem(shelf, JSON.stringify(answers)));
    }
    if (c !== right && isFirst && choices.length > 2) {
      buttons[c].classList.add('wrong');
      buttons[c].setAttribute('aria-disabled', 'true');  // and keeps the focus, so that Tab goes on from there
      $('verdict').replaceChildren(...marked(`${notSo(choices[c][2])} Try once more.`));
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
    answered(c === right);
    $('in-words').open = true;
    for (const button of buttons) button.disabled = true;
    buttons[c].classList.add('wrong');
    buttons[right].className = 'right';
    $('verdict').replaceChildren(...c === right ? marked(`Right: ${reason}.`) : [
      ...marked(`${notSo(choices[c][1] === reason ? '' : choices[c][1])} The answer is `),
      make('b', {}, ...marked(`“${choices[right][0]}”`)), ...marked(`: ${reason}.`)]);
    $('onward').textContent = 'Go on';
    hideWords(false);
    $('onward').focus();
  }

  // The lines that run, which tell what is asked.
  function mark(isShown) {
    now().querySelectorAll('.code').forEach((box, b) => {
      const line = box.querySelectorAll('li')[story.frames[place()].code[b].current];
      if (line && isShown) line.setAttribute('aria-current', 'step'); else line?.removeAttribute('aria-current');
    });
  }

  // What is told of the picture tells where the origin lies.
  const hideWords = hides => tellPicture(hides ? hidden : inWords(place()));

  function close() {
    asked = null;
    onPicture(null);
    hideWords(openQuestion() >= 0);
    mark(true);
    $('quiz').hidden = $('score').hidden = true;
    now().classList.remove('asking');
  }

  function onward() {
    const first = answers[asked];
    if (first !== null && !isTold) return tell([...$('choices').querySelectorAll('button')], first);
    if (first === null) skipped.add(asked);
    if (stopsToAsk()) return;
    show(place() + 1, 'push');
    $(isAtEnd() ? 'first' : 'next').focus({preventScroll: true});  // the button that was pressed is gone
  }

  function showScore() {
    const given = questions.map((each, k) => ({...each, answer: answers[k]})).filter(({answer}) => answer !== null);
    const isWrong = each => each.answer !== each.right;
    const wrong = given.filter(isWrong).length, missing = questions.length - given.length;
    $('points').textContent = !given.length ? 'No question answered yet'
      : `${given.length - wrong} of ${questions.length} right${missing ? `, ${missing} not answered` : ''}`;
    const list = make('ul');
    let missesPages = false;
    for (const [kind, name] of Object.entries(kinds)) {
      const ours = given.filter(each => each.kind === kind), wrong = ours.filter(isWrong);
      if (!ours.length) continue;
      const line = make('li', {className: wrong.length ? 'no' : 'yes',
                               textContent: `${name}: ${ours.length - wrong.length} of ${ours.length}`});
      const practice = new Map(wrong.map(each => story.practices[each.practice]).filter(([title]) => title));
      let between = '; practise with ';
      for (const [title, url] of practice) {  // where there is no page, its name
        line.append(between, url ? make('a', {href: url, textContent: title}) : make('code', {textContent: title}));
        missesPages ||= !url;
        between = ', ';
      }
      list.append(line);
    }
    $('kinds').replaceChildren(list);
    if (missesPages)
      $('kinds').append(make('code', {textContent: 'gjkstep render regions --page'}), ' makes these pages.');
    now().querySelector('.told').prepend($('score'));
    $('score').hidden = false;
    $('forget').hidden = !given.length;
    $('score').scrollIntoView({block: 'nearest'});
    if (given.length) $('live').textContent = $('points').textContent;
  }

  function toggle() {
    predicting = !predicting;
    $('predict').setAttribute('aria-pressed', predicting);
    close();
    skipped.clear();
    const isOver = predicting && !answers.includes(null);
    if (isOver || (predicting && isAtEnd())) showScore();
    entitle();
    $('live').textContent = isOver ? 'All questions have been answered; who forgets the answers is asked again.'
      : !predicting ? 'No questions will be asked.'
      : `${isAboutLine ? 'Where the searches part' : 'Before each decision'} a question will be asked.`;
  }

  function forget() {
    answers = nothing();
    store(shop => shop.removeItem(shelf));
    show(0, 'push');
    $('next').focus();
  }

  function arrive(moved) {
    if (moved) skipped.clear();
    hideWords(openQuestion() >= 0);
    if (predicting && isAtEnd()) showScore();
  }

  $('onward').onclick = onward;  // not of a story that is shown no more
  $('forget').onclick = forget;

  return {
    leave: close, arrive, holds, answer, toggle,
    isAsking: () => asked !== null, untold: () => predicting && $('score').hidden ? untold : '',
  };
}
