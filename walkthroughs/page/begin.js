'use strict';
// Where the story was left behind all pictures stand below each other.
if (window.gjkstep || !document.querySelector('[src^=story]')) document.documentElement.className = 'js';
