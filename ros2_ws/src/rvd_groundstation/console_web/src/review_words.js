// The words of the review, its list and its exports; strings.js takes them in.

export const REVIEW_WORDS = {
  review_bar: 'Review', review_event_back: '«', review_step_back: '‹', review_step_on: '›', review_event_on: '»',
  review_event_back_alt: 'to the event before', review_step_back_alt: 'one picture back',
  review_step_on_alt: 'one picture on', review_event_on_alt: 'to the next event',
  review_speed: 'Speed of the review', review_times: '{n} ×', review_events: 'Events of the run',
  review_events_some: 'Events ({n})', review_events_none: 'No events',
  review_report: 'Report', review_png: 'PNG', review_csv: 'CSV', review_webm: 'WebM', review_webm_stop: 'Stop the video',
  review_report_hint: 'Open the report of this run in a tab of its own',
  review_png_hint: 'Save what is shown now as a picture', review_csv_hint: 'Save the numbers of all instants as a table',
  review_webm_hint: 'Play on from here, to the end or until it is stopped, and save it as a video',
  review_no_tab: 'The browser did not allow a new tab.',
  review_webm_none: 'This browser records no WebM video',
  review_failed: 'not saved: {why}',
  review_of: 'Review: {name}', review_flown: '{mode} at the start', review_seed: 'seed {n}',
  runs_loading: 'Reading the list…',
  runs_columns: ['ended', 'run', 'scenario', 'mode', 'operator', 'seed', 'time', 'verdict'],
  runs_flying: 'under way', runs_closing: 'its bag is being closed…', runs_no_report: 'This run has no report: ./rvd report makes one.',
  runs_report: 'Report of {name}', runs_open: 'Review {name}',
};

// What the list of keys says of the review.
export const REVIEW_HELP = [
  ['', 'In a review:'],
  ['Space', 'play, stop'], ['← →', 'one picture back, on'], ['Shift ← →', 'to the event before, to the next one'],
  ['↑ ↓', 'faster, slower'], ['Home End', 'to the beginning, to the end'], ['Esc', 'leave the review'],
];

// First columns of the table of numbers.
export const TABLE_HEAD = ['t [s]', 'step', 'mode'];

export const NO_PICTURE = 'no picture was recorded';
