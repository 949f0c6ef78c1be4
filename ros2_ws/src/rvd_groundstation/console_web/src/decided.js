// Who flies: one sentence for each (mode, who decided, why), from the decision that was made and never from what
// is supposed to follow. Whatever the page says of it, it says with this table. Codes are those of ThrustCommand.msg.

export const [NOBODY, PILOT, AUTO, BLEND, GUARD] = [0, 1, 2, 3, 4];
const [MISSING, MODE, PILOT_INVALID, AUTO_INVALID, BOTH_INVALID, ABORTED] = [7, 8, 9, 10, 11, 12];

const WHO = { [NOBODY]: 'nobody flies', [PILOT]: 'the pilot flies', [AUTO]: 'the automatic controller flies',
  [BLEND]: 'the pilot and the automatic controller fly together', [GUARD]: 'the guard on board flies' };
const UNKNOWN = 'who flies is not known';

// What a command that was refused or an input that was not there says, whoever decided.
const CAUSES = ['', 'nothing was due', 'wrong length', 'wrong checksum', 'out of order', 'too old', 'out of range',
  'an input was missing', 'as the mode says', 'no valid stick', 'no valid automatic command',
  'neither a valid stick nor a valid automatic command', 'ABORT is in force'];

// Who may decide in the modes of a pilot; a mission's own modes say nothing of it.
const MAY = { manual: [NOBODY, PILOT], shared: [NOBODY, PILOT, AUTO, BLEND], auto: [NOBODY, AUTO] };

// Sentences that are more than who and why put together: by 'who why', of any mode, or 'mode who why'.
const SAID = {
  [`${PILOT} ${MODE}`]: ['the pilot flies alone', CAUSES[MODE]],
  [`${AUTO} ${MODE}`]: ['the automatic controller flies alone', CAUSES[MODE]],
  [`${AUTO} ${PILOT_INVALID}`]: ['the automatic controller flies alone', CAUSES[PILOT_INVALID]],
  [`${AUTO} ${AUTO_INVALID}`]: ['a neutral command flies', CAUSES[AUTO_INVALID]], // a filter that had nothing to let pass
  [`${BLEND} ${AUTO_INVALID}`]: ['the pilot flies, blended with a neutral command', CAUSES[AUTO_INVALID]],
  [`shared ${PILOT} 0`]: ['the pilot flies', 'the automatic controller let the command pass'],
  [`shared ${AUTO} 0`]: ['the automatic controller flies', 'it changed what the pilot commanded'],
};

// A reason that denies what was decided: no node of ours sends it, and the page does not make sense of it.
const DENIED = { [PILOT_INVALID]: [PILOT, BLEND], [BOTH_INVALID]: [PILOT, AUTO, BLEND] };
const ODD = 'the reason that is told does not fit';

/**
 * Return who flies and why.
 *
 * `who` and `why` are words; `pilot` says whether the stick is in the command that was sent, `unheld` whether no valid
 * stick came, `alarm` whether nobody flies or a guard does. `mode` is the one in force, `by` and `reason` the codes of the newest command.
 */
export function decided(mode, by, reason) {
  if (!(by in WHO) || !(reason in CAUSES)) return { who: UNKNOWN, why: '', pilot: false, alarm: true };
  if (reason === ABORTED) {
    return by === GUARD ? { who: WHO[GUARD], why: CAUSES[ABORTED], pilot: false, alarm: true }
      : { who: 'nobody flies from the ground', why: 'every command says ABORT', pilot: false, alarm: true };
  }
  const [who, why] = SAID[`${mode} ${by} ${reason}`] ?? SAID[`${by} ${reason}`] ?? [WHO[by], CAUSES[reason]];
  const late = mode in MAY && by !== GUARD && (!MAY[mode].includes(by) || (mode === 'shared' && reason === MODE && by !== NOBODY));
  const odd = DENIED[reason]?.includes(by);
  return { who, why: odd ? ODD : late ? 'decided before the mode was changed' : why, pilot: by === PILOT || by === BLEND,
    unheld: reason === PILOT_INVALID || reason === BOTH_INVALID,
    alarm: by === NOBODY || by === GUARD || reason === MISSING || reason === AUTO_INVALID || odd === true };
}

export const sentence = ({ who, why }) => (why ? `${who}: ${why}` : who);

/**
 * Return `decided` of the command in a frame.
 *
 * Null where no command was sent, where none is decided on the ground (`link` of the display is false), or where
 * commands do not tell who decided them. A mode that the mission does not have says nothing.
 */
export function whoFlies(display, frame) {
  const sent = frame && display?.link ? frame.signals[display.commands.sent] : null;
  if (!sent || sent.parts.by === null) return null;
  const mode = display.modes.some(({ name }) => name === frame.mode) ? frame.mode : '';
  return decided(mode, sent.parts.by, sent.parts.reason);
}

// Of a mission that is only watched: what its command says besides its value.
export const cause = (reason) => CAUSES[reason] ?? '';

/** Return the words of `lost` (PILOT LOST, DEAD-MAN OPEN) with who flies instead, once that has been decided. */
export function instead(lost, found) {
  return found && !found.pilot ? `${lost}: ${found.who}` : lost;
}
