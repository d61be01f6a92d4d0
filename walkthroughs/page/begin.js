'use strict';
if (window.gjkstep) document.documentElement.className = 'js';  // else it was left behind, and all pictures stand below each other
