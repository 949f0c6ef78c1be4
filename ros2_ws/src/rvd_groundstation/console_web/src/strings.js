// Every word of the page. Keys of REASONS, BY, STATES, REFUSED follow the messages' codes.

export const S = {
  title: 'RVD console',
  clocks: 'Three clocks', clock_generated: 'generated on board', clock_received: 'received on the ground',
  clock_predicted: 'predicted for',
  modes: 'Who decides', mode_manual: 'Manual', mode_shared: 'Shared', mode_auto: 'Auto',
  pause: 'Pause', resume: 'Resume', abort: 'ABORT', abort_hint: 'X twice', abort_armed: 'again: ABORT',
  instruments: 'Instruments', motion: 'Motion', measured: 'measured', predicted: 'predicted',
  limit: 'limit', truth: 'truth',
  range: 'range', closing: 'closing rate', offset: 'lateral offset', lateral: 'lateral rate',
  margin: 'corridor margin',
  section: 'Corridor section', section_alt: 'Cross-section of the corridor with measured and predicted position',
  leave: 'drifting out in', leave_never: 'stays inside', leave_out: 'OUTSIDE',
  thrust: 'Thrust levels', pilot: 'pilot', auto: 'automatic', sent: 'sent', weight: 'pilot weight',
  scene: 'Scene', views: 'Views', view_orbit: 'Orbit', view_side: 'Side', view_top: 'Top',
  camera_side: 'Camera, delay and prediction error', camera: 'Docking camera',
  camera_tag: 'docking camera · delayed', camera_tag_review: 'docking camera · truth',
  ladder: 'Command ladder', ladder_alt: 'Commands on their way to the craft and back',
  ladder_ground: 'ground', ladder_link: 'on the link', ladder_craft: 'at the craft', ladder_back: 'telemetry on its way back', ladder_known: 'known',
  round_trip: 'Round trip', dial_alt: 'Dial of the round trip',
  errors: 'Prediction error', error_position: 'position, cm', error_rate: 'rate, mm/s',
  restart: 'New run', review: 'Review', settings: 'Stick', help: 'Help', stop: 'Stop run',
  review_close: 'Leave review', play: 'Play', stop_play: 'Stop', scrub: 'Instant of the review',
  review_title: 'Review a run', review_none: 'No finished runs here yet.',
  review_loading: 'Reading the bag…', review_open: 'Open',
  take: 'Take the stick', drop: 'Release the stick', taken: 'Another page has the stick',
  stick_yours: 'You have the stick', stick_held: 'stick live', stick_open: 'DEAD-MAN OPEN: automatic alone flies',
  stick_watch: 'watching', keyboard: 'keyboard', gamepad: 'gamepad', level: 'level',
  pages_one: '1 page', pages: '{n} pages', of: 'of',
  socket_open: 'connected', socket_closed: 'NOT CONNECTED',
  idle: 'Ready', idle_text: 'Take the stick (T), then start a run (N).', starting: 'The graph is coming up…',
  paused: 'PAUSED', stale: 'STALE', no_telemetry: 'no telemetry yet', first_in: 'first telemetry in {s} s',
  pilot_lost: 'PILOT LOST: the automatic half flies alone',
  stale_frames: 'NO DATA FOR {s} s', aborted: 'ABORT in force: braking and backing away',
  abort_sent: 'ABORT sent, acting in about {s} s',
  run_failed: 'The run could not be flown: see the terminal',
  docked: 'DOCKED', verdict: { docked: 'Docked', left_corridor: 'Left the corridor', closing_rate: 'Closing rate out of limits',
    offset: 'Lateral offset out of limits', lateral_rate: 'Lateral rate out of limits',
    timeout: 'Did not reach the docking plane in time', invalid: 'The true state became invalid' },
  verdict_title: 'Verdict', verdict_time: 'time', verdict_closing: 'closing rate', verdict_offset: 'lateral offset',
  verdict_lateral: 'lateral rate', verdict_margin: 'least corridor margin', verdict_dv: 'delta-v',
  fly_again: 'Fly again (N)', close: 'Close', cancel: 'Cancel', start: 'Start', seed: 'seed', mode: 'mode',
  seed_hint: 'empty: the next one', new_run: 'New run', new_run_text: 'A new run in a new folder. A run under way is stopped.',
  no_fly: 'This console belongs to one run; start it with ./rvd fly --operator console to fly again.',
  no_page_token: 'This page needs the token of the address that the console printed.',
  no_token_title: 'No token',
  section_at: 'at x = {x} m', exaggerated: 'lateral scale × {n}', lead: 'in {s} s',
  rms: 'rms {p} cm · {v} mm/s',
  legend: { measured: 'measured', predicted: 'predicted, 2σ tube', drift: 'drift from there', wall: 'corridor',
    boundary: 'control boundary', truth: 'truth' },
  link: { transit: 'transit', p99: 'p99', lost: 'lost', late: 'late', corrupted: 'damaged', gap: 'last gap' },
  age: 'age {s} s', ago: '{s} s ago', ahead: 'in {s} s', now: 'now',
  settings_title: 'The stick', settings_dead_zone: 'dead zone', settings_axis: 'axis', settings_invert: 'inverted',
  settings_button: 'dead-man button', settings_space: 'keyboard: hold Space as dead-man',
  settings_none: 'No gamepad seen. Press a button on it.', settings_found: 'Gamepad: {name}',
  settings_x: 'forward / back', settings_y: 'up / down', settings_z: 'right / left',
  help_title: 'Keys',
  review_truth: 'Review shows the truth. It never reaches this page while a run is flown.',
  unknown: '–',
};

export const HELP = [
  ['T', 'take or release the stick'], ['W / S', 'thrust forward / back (x)'],
  ['↑ / ↓ or R / F', 'thrust up / down (y, radially outward is up)'],
  ['← / → or A / D', 'thrust left / right (z)'], ['1 2 3', 'thrust level of the keys'],
  ['Space', 'dead-man, if so chosen under Stick'], ['M', 'manual, shared, auto in turn'],
  ['P', 'pause, resume'], ['X X', 'ABORT: brake and back away, past every buffer'],
  ['N', 'new run'], ['V', 'next view'], ['L', 'review a run'], ['G', 'stick settings'],
  ['?', 'this list'], ['Esc', 'close'],
  ['', 'A key that comes up is zero. Without focus, without this page, or with the dead-man open, the pilot is lost and the automatic half flies alone.'],
];

export const BY = ['nobody', 'pilot', 'automatic', 'blend', 'guard'];
export const REASONS = ['', 'nothing due', 'wrong length', 'checksum', 'out of order', 'too old',
  'out of range', 'an input was missing', 'as the mode says', 'stick invalid: automatic alone',
  'automatic invalid: counts as 0', 'neither valid: level 0', 'ABORT in force'];
export const LADDER = ['sent', 'due', 'executed', 'effect seen', 'refused', 'missed', 'unknown'];
export const REFUSED = {
  LEASE: 'Take the stick first (T).', TAKEN: 'Another page has the stick.', NO_RUN: 'No run is under way.',
  NO_FLY: S.no_fly, DESK: 'The session says what is flown.', MODE: 'No such mode.', SEED: 'The seed must be a whole number.',
};

export function fill(text, values) {
  return text.replace(/\{(\w+)\}/g, (_, key) => values[key]);
}
