// First of all the line to the server: it opens while the rest of the page is read.

import './link.js';

import('./main.js');
