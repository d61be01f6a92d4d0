'use strict';
// What all pages share: texts and pictures as elements, and stepping by buttons, slider, keys and by itself.

const $ = id => document.getElementById(id);

function make(tag, properties, ...children) {
  const element = Object.assign(document.createElement(tag), properties);
  element.append(...children);
  return element;
}

// What is the same already is not set: nothing need be laid out for it.
function set(object, values) {
  for (const [name, value] of Object.entries(values)) if (object[name] !== value) object[name] = value;
}

// Text with the markup of render/font.hpp: "_x" and "_{xyz}" are subscripts, "\_" is an underscore.
function marked(text) {
  const parts = [];
  let at = 0;
  for (const {0: all, 1: several, 2: one, index} of text.matchAll(/\\_|_\{([^}]*)\}|_(.)/gsu)) {
    parts.push(text.slice(at, index), all === '\\_' ? '_' : make('sub', {textContent: several ?? one}));
    at = index + all.length;
  }
  return [...parts, text.slice(at)];
}

// What `act` does with the store of the browser; null where it has none or does not allow it.
const stored = act => { try { return act(localStorage); } catch { return null; } };

// What of the pictures in an element is shown.
function cutOut(element, {width, left, top, aspect}) {
  for (const [name, value] of Object.entries({width: `${width}%`, left: `${left}%`, top: `${top}%`, aspect}))
    element.style.setProperty(`--${name}`, value);
}
const groundOf = entry => entry.is_dark ? 'dark-pictures' : 'light-pictures';  // on which pictures were drawn

// Steps through `count()` places. `show(i, how)` shows one; `how`: whether the address gets an entry of its own in the
// browser's history ('push'), replaces the last one, or stays. `reading()` is how long one looks at it, in
// milliseconds; `holds()` whether something is to be done there first.
function stepper({count, show, reading, holds = () => false, back}) {
  let at = 0, timer = 0;
  function turnTo(i, how) {
    at = Math.max(0, Math.min(count() - 1, i));
    set($('slider'), {max: `${count()}`, value: `${at + 1}`});
    set($('place'), {textContent: `${at + 1} / ${count()}`});
    $('first').disabled = $('back').disabled = at === 0;
    $('next').disabled = $('last').disabled = at === count() - 1;
    show(at, how);
  }
  function pause() {
    clearTimeout(timer);
    timer = 0;
    $('play').textContent = 'Play';
  }
  function playOn() {
    clearTimeout(timer);
    timer = setTimeout(() => {
      if (holds()) return pause();
      turnTo(at + 1, 'replace');
      if (at + 1 < count()) playOn(); else pause();
    }, reading());
  }
  function play() {
    if (timer) return pause();
    if (at + 1 === count()) turnTo(0, 'push');
    $('play').textContent = 'Pause';
    playOn();
  }
  const go = (i, how = 'push') => { pause(); turnTo(i, how); };
  const keys = {
    ArrowLeft: back ?? (() => go(at - 1)), ArrowRight: () => { pause(); if (!holds()) turnTo(at + 1, 'push'); },
    Home: () => go(0), End: () => go(count() - 1), ' ': play,
  };
  const buttons = {first: 'Home', back: 'ArrowLeft', next: 'ArrowRight', last: 'End', play: ' '};
  for (const [id, key] of Object.entries(buttons)) $(id).addEventListener('click', () => keys[key]());
  $('slider').addEventListener('input', () => go($('slider').value - 1, 'replace'));
  return {at: () => at, turnTo, go, keys, restart: () => { if (timer) playOn(); }};
}

// `act(event)`: what a key does, if anything. Fields and what is pressed keep keys of their own.
function onKeys(act) {
  document.addEventListener('keydown', event => {
    const does = act(event);
    const own = event.key === ' ' ? 'select, button, summary, a, input:not([type=range])' : 'select';
    const isOther = event.ctrlKey || event.metaKey || event.altKey || event.isComposing || event.target.closest(own);
    if (!does || isOther) return;
    event.preventDefault();
    does();
  });
}
