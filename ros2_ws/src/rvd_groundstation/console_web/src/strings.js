// Every word of the page that no mission brings, but who flies (decided.js). LADDER and REFUSED follow the codes of the messages.

import { REVIEW_WORDS } from './review_words.js';

export const S = {
  ...REVIEW_WORDS,
  title: 'RVD console',
  clocks: 'Three clocks', clock_generated: 'generated on board', clock_received: 'received on the ground',
  clock_predicted: 'predicted for',
  modes: 'Who decides', mode_turn: '{modes} in turn', mode_ground: 'ground', mode_board: 'on board',
  pause: 'Pause', resume: 'Resume', abort: 'ABORT', abort_hint: 'X twice', abort_armed: 'again: ABORT',
  instruments: 'Instruments', columns: { measured: 'measured', predicted: 'predicted', truth: 'truth', plain: '' },
  limit: 'limit', weight: 'pilot weight',
  scene: 'Scene', views: 'Views', camera_side: 'Camera, delay and charts',
  ladder: 'Command ladder', ladder_alt: 'Commands on their way to the craft and back',
  ladder_ground: 'ground', ladder_link: 'on the link', ladder_craft: 'at the craft', ladder_back: 'telemetry on its way back', ladder_known: 'known',
  ladder_untold: 'this craft acknowledges none',
  ladder_narrow: ['ground', 'link', 'craft', 'back', 'known'],
  round_trip: 'Round trip', dial_alt: 'Dial of the round trip',
  restart: 'New run', review: 'Review', settings: 'Stick', help: 'Help', stop: 'Stop run',
  review_close: 'Leave review', play: 'Play', stop_play: 'Stop', scrub: 'Instant of the review',
  review_title: 'Review a run', review_none: 'No finished runs here yet: a run is listed once its bag is closed.',
  review_loading: 'Reading the bag…', review_open: 'Open',
  take: 'Take the stick', drop: 'Release the stick', taken: 'Another page has the stick',
  stick_yours: 'You have the stick', stick_held: 'stick live', stick_open: 'DEAD-MAN OPEN', stick_away: 'NO FOCUS', stick_unheard: 'STICK NOT HEARD',
  stick_released: 'STICK RELEASED while “{what}” is open', stick_back: 'Close it to fly on.',
  watch_only: 'Watching only', abort_watch: 'not from here',
  live_head: 'LIVE FLIGHT · {t} s · {mode}', live_back: 'Back to the flight',
  review_in_flight: 'A flight is under way. It stays in view beside the review, and ABORT works.',
  stick_watch: 'watching', stick_none: 'you are in charge', keyboard: 'keyboard', gamepad: 'gamepad',
  stick_events: { STICK_LOST: 'nobody holds the stick, or the dead-man is open', STICK: 'the stick counts' },
  pages_one: '1 page', pages: '{n} pages', of: 'of',
  socket_closed: 'NOT CONNECTED',
  idle: 'Ready', idle_text: 'Take the stick (T), then start a run (N).', starting: 'The graph is coming up…',
  paused: 'PAUSED', stale: 'STALE', no_telemetry: 'no telemetry yet', first_in: 'first telemetry in {s} s',
  pilot_lost: 'PILOT LOST',
  stale_frames: 'NO DATA FOR {s} s', aborted: 'ABORTED', aborted_so: 'ABORTED: {does}', stop_run: 'End the flight', stop_hint: 'ends the run under way; its folder is kept whole',
  abort_sent: 'ABORT sent, acting in about {s} s',
  abort_asked: 'ABORT: waiting for the answer', abort_unconfirmed: 'ABORT NOT CONFIRMED',
  abort_again: 'no answer; asked {n} times, asking again', abort_accepted: 'ABORT accepted, goes out with the next frame',
  abort_untold: 'ABORT sent, NOT ACKNOWLEDGED', abort_untold_hint: 'sent {s} s ago; telemetry has not told whether it is in force',
  unconfirmed: '{name} NOT CONFIRMED', unconfirmed_hint: 'The run did not answer in 2 s. Try again.',
  no_webgl: 'No WebGL: the scene is drawn in lines', no_storage: 'Storage is blocked: settings are not remembered',
  stick_gone: 'GAMEPAD GONE', stick_stuck: 'NOT AT REST: {axes} counts as 0 until it has been centred',
  run_failed: 'The run could not be flown: see the terminal', run_refused: 'No run with these settings',
  verdict_title: 'Verdict', verdict_time: 'time',
  fly_again: 'Fly again (N)', close: 'Close', cancel: 'Cancel', start: 'Start', seed: 'seed', mode: 'mode',
  seed_hint: 'empty: the next one', new_run: 'New run', new_run_text: 'A new run in a new folder. A run under way is stopped.',
  no_fly: 'This console belongs to one run; start it with ./rvd fly --operator console to fly again.',
  no_page_token: 'This page needs the token of the address that the console printed.',
  no_token_title: 'No token', wrong_token: 'WRONG TOKEN', wrong_token_text: 'This console was started anew, or never knew this page: open the address that it printed.',
  line: { opening: '○ connecting', open: '● connected', silent: '○ NOTHING HEARD', closed: '○ NOT CONNECTED', full: '○ NO ROOM', stranger: '○ WRONG TOKEN', none: '○ NO TOKEN' },
  connecting: 'Connecting…', line_full: 'NO ROOM: as many pages are open as this console takes',
  line_silent: 'NO CONNECTION: nothing heard for {s} s', line_lost: 'NOT CONNECTED: no server for {s} s',
  line_old: 'All that is shown is so old.', line_again_old: 'All that is shown is at least so old. The page comes back by itself.', line_again: 'The page comes back by itself.',
  before: '{s} s ago',
  exaggerated: '{axis} scale × {n}',
  link: { transit: 'transit', p99: 'p99', lost: 'lost', late: 'late', corrupted: 'damaged', gap: 'last gap' },
  age: 'age {s} s', ago: '{s} s ago', ahead: 'in {s} s', now: 'now',
  settings_title: 'The stick', settings_dead_zone: 'dead zone', settings_axis: 'axis', settings_pair: 'buttons {plus} / {minus}, or', settings_invert: 'inverted',
  settings_button: 'dead-man button', settings_space: 'keyboard: hold Space as dead-man',
  settings_none: 'No gamepad seen. Press a button on it.', settings_pads: 'Gamepads', settings_now: 'now',
  pad_notes: { '': '', choose: 'Several gamepads: choose one under Stick (G)', setup: 'The gamepad must be set up under Stick (G) before it flies' },
  pad_plain: 'no standard mapping', pad_live: 'axes {axes} · pressed {buttons}', pad_nothing: 'none',
  pad_choose: 'Several gamepads are connected: choose one.',
  pad_setup: 'This gamepad has no standard mapping: its axes and buttons may be anything. It does not fly before each axis and the dead-man button have been set.',
  pad_ready: 'This gamepad is set up.', pad_start: 'Set it up step by step', pad_next: 'Next', pad_skip: 'No such axis', pad_stop: 'Stop',
  pad_rest: 'Let go of all its sticks, triggers and buttons, then go on.',
  pad_move: 'Push the stick all the way for {what} ({name}).', pad_back: 'Let it go.',
  pad_trigger: 'Axis {axis} does not rest at 0, as a trigger does not: take another.',
  pad_hold: 'Press the button that is to be held while flying.',
  dialog: 'a dialog', help_title: 'Keys', help_step: '{name} of the keys', or: 'or',
  review_truth: 'Review shows the truth. It never reaches this page while a run is flown.',
  unknown: '–', alarms: 'Alarms', acknowledge: 'Acknowledge (K)', digits: 'Position and rates of the craft',
  field: 'field {deg}°', field_was: '(was {deg}°)',
  desk: {
    door: 'Which volunteer? Enter the number you were given; no name is asked or kept.', volunteer: 'volunteer number', begin: 'Begin',
    heading: '{who}, flight {n} of {of}', training: 'Training: this flight does not count.', counts: 'This flight counts.',
    condition: 'Control: {mode}', clock: 'The clock starts when the graph is up.', fly: 'Start the flight',
    rest_title: 'A break', rest: 'Rest your eyes and hands.', go_on: 'Go on', done_title: 'Finished', done: 'Thank you, {who}. All flights are flown and rated.', next: 'Next volunteer',
    session: 'Session: {title}', is_training: 'training', is_counted: 'counts', open: 'Session', idle: 'Take the stick (T) to go on with the session.',
    broken: 'This flight does not count: {why}.', flown_again: 'It is flown again, with the same start.',
    unset: 'not set', back: 'Back', change: 'Change', chosen: 'What contributed more to the workload, in each pair:', save_pairs: 'Save',
    yes: 'Yes', no: 'No', again: 'Answer again', pick: 'Pick the sentence that fits best.', save: 'Save the ratings',
    weigh: 'Which of the two contributed more to the workload of flying in this way?', pair: 'pair {n} of {of}',
    tree: {
      controllable: 'Was the craft controllable?',
      adequate: 'Was adequate performance ({goal}) attainable with a tolerable pilot workload?',
      satisfactory: 'Was it satisfactory without improvement?',
    },
    ratings: ['', 'Excellent, highly desirable: compensation not a factor', 'Good, negligible deficiencies: compensation not a factor',
      'Fair, some mildly unpleasant deficiencies: minimal compensation', 'Minor but annoying deficiencies: moderate compensation',
      'Moderately objectionable deficiencies: considerable compensation', 'Very objectionable but tolerable deficiencies: extensive compensation',
      'Major deficiencies: adequate performance not attainable with maximum tolerable compensation',
      'Major deficiencies: considerable compensation needed for control', 'Major deficiencies: intense compensation needed to retain control',
      'Major deficiencies: control lost during some part of the flight'],
    tlx: {
      mental: ['Mental demand', 'How mentally demanding was the flight?', 'very low', 'very high'],
      physical: ['Physical demand', 'How physically demanding was the flight?', 'very low', 'very high'],
      temporal: ['Temporal demand', 'How hurried or rushed was the pace?', 'very low', 'very high'],
      performance: ['Performance', 'How successful were you in doing what you were asked to do?', 'perfect', 'failure'],
      effort: ['Effort', 'How hard did you have to work for your level of performance?', 'very low', 'very high'],
      frustration: ['Frustration', 'How insecure, discouraged, irritated, stressed and annoyed were you?', 'very low', 'very high'],
    },
    errors: { VOLUNTEER: 'A whole number from 1 to 999, please.', STAGE: 'Not now.', RATING: 'The rating is incomplete.', TLX: 'Please set every scale.', WEIGHTS: 'Please choose in every pair.', CLOSING: 'One moment: the recording of the last flight is being closed.' },
  },
};

// The keys of the hand controller come after the first of these.
export const HELP = [
  ['T', 'take or release the stick'],
  ['Space', 'dead-man, if so chosen under Stick'],
  ['P', 'pause, resume'], ['X X', 'ABORT, past every buffer{abort}'],
  ['K', 'acknowledge the alarms: they fall silent until the next one'], ['O', 'sound of the alarms on, off'],
  ['N', 'new run'], ['V', 'next view'], ['+ − [ ]', 'zoom and turn the scene'], ['L', 'review a run'], ['G', 'stick settings'],
  ['?', 'this list'], ['Esc', 'close'],
  ['', 'A key that is released commands zero. Without focus, without this page, with the dead-man open, or while a dialog or a review is open, there is no pilot: the mode says who flies then, in shared the automatic controller, in manual nobody, and the page says what was decided.'],
];

// Of alarms, and of what a pilot is told before the first command.
export const A = {
  none: 'no alarm', sound_on: 'Sound on (O)', sound_off: 'Sound off (O)', beyond: '{said}{label} {value}, limit {limit}',
  telemetry: 'TELEMETRY LOST', pilot: 'PILOT LOST', nobody: 'NOBODY HOLDS THE STICK',
};
export const C = { good: 'A good approach', keys: 'Keys' };

export const KEYS = { ArrowUp: '↑', ArrowDown: '↓', ArrowLeft: '←', ArrowRight: '→' };

export const LADDER = ['sent', 'due', 'executed', 'effect seen', 'refused', 'missed', 'unknown'];
export const REFUSED = {
  LEASE: 'Take the stick first (T).', TAKEN: 'Another page has the stick.', NO_RUN: 'No run is under way.',
  WATCH: 'This page watches only. To fly, open the first address that the console printed.',
  NO_FLY: S.no_fly, NO_ANSWER: 'The run did not answer.', DESK: 'The session says what is flown.', SESSION_MODE: 'The session says in which mode this flight is flown.',
  SESSION_PAUSE: 'A flight of a session is not paused.', SESSION_STOP: 'A flight of a session is flown to its end. Only ABORT ends it before, and it does not count then.',
  NO_DESK: 'This console leads no session.', JSON: 'The console did not understand the page: reload it.', REQUEST: 'The console did not understand the page: reload it.', ID: 'The console did not understand the page: reload it.',
  LENGTH: 'A stick sample was damaged and left out.', KIND: 'A stick sample was damaged and left out.', RANGE: 'A stick sample was out of range and left out.', MODE: 'No such mode.', SETTINGS: 'Too many settings, or one that is too long.', SEED: 'The seed must be a whole number.',
};

export function fill(text, values) {
  return text.replace(/\{(\w+)\}/g, (_, key) => values[key]);
}
