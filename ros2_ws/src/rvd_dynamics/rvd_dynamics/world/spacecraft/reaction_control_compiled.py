"""
Valves and thrust of a set of thrusters over one base step, for numba; see `reaction_control`.

The thrust of each obeys f' = (v - f)/tau exactly, v being the valve's amplitude, which changes once
within a step where the delay is no whole number of steps.
"""

import numpy as np

from rvd_dynamics.compiled import compiled

SOUND, STUCK_OFF, STUCK_ON, WEAK = 0, 1, 2, 3


@compiled
def fire(command, opened, line, thrust, amplitude, pulses, amplitudes, kinds, since, factor, k,
         least_on, columns, early, late, switch, lag, h, flow):
    """
    Carry all thrusters over step k in place.

    Return wrench (N, nodes, 6), mean thrust (N, T), and the propellant (N,) of `flow` (T) [kg/s].

    `command` (N, T) bool. State: `opened` (N, T) steps for which a valve has been open, `line`
    (N, D + 2, T) amplitudes at valves on their way through the delay, newest first, `thrust`,
    `amplitude` of the present pulse, `pulses` counted. `amplitudes` (N, T, P) of pulses, used in
    turn; failures by kind, step and factor. `early` and `late` (nodes,): exp(-t/tau) since the
    start and since the switch of the delay, `switch` the first node after it; `lag`: tau, delay
    within a step. Thrust as a fraction of nominal; `columns` (N, T, 6).
    """
    rows, count = command.shape
    nodes, depth = len(early), line.shape[1]
    wrench, mean, spent = np.zeros((rows, nodes, 6)), np.zeros((rows, count)), np.zeros(rows)
    tau, rest = lag
    for r in range(rows):
        for t in range(count):
            kind = kinds[r, t] if k >= since[r, t] else SOUND
            wanted = command[r, t] or 0 < opened[r, t] < least_on
            if kind == STUCK_ON:
                wanted = True
            elif kind == STUCK_OFF:
                wanted = False
            if wanted:
                if opened[r, t] == 0:
                    amplitude[r, t] = amplitudes[r, t, pulses[r, t] % amplitudes.shape[2]]
                    pulses[r, t] += 1
                opened[r, t] += 1
            else:
                opened[r, t] = 0
            for d in range(depth - 1, 0, -1):
                line[r, d, t] = line[r, d - 1, t]
            valve = amplitude[r, t] if wanted else 0.0
            if kind == WEAK:
                valve *= factor[r, t]
            line[r, 0, t] = valve
            before, after, f = line[r, depth - 1, t], line[r, depth - 2, t], thrust[r, t]
            if f == 0.0 and before == 0.0 and after == 0.0:
                continue
            turn = before + (f - before)*np.exp(-rest/tau)         # thrust when the delay is over
            for j in range(nodes):
                if j < switch:
                    now = before + (f - before)*early[j]
                else:
                    now = after + (turn - after)*late[j]
                for i in range(6):
                    wrench[r, j, i] += now*columns[r, t, i]
            end = after + (turn - after)*late[nodes - 1]
            # f = v - tau f', so its integral is that of v less tau times what it gained
            mean[r, t] = (before*rest + after*(h - rest) - tau*(end - f))/h
            spent[r] += mean[r, t]*(flow[t]*h)
            thrust[r, t] = end if end > 1e-9 else 0.0
    return wrench, mean, spent
