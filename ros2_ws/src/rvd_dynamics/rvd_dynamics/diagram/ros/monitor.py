"""
The judge as a node, outside the ring: it judges the truth and nothing else.

Reads       the plant's truth, each step once and in order; what else is there is refused;
            what shows an ABORT on board and what the run says of one: a run that was aborted was
            that (`aborts`); and who announces a writer on the topics of the run
Publishes   /run/verdict    rvd_interfaces/Verdict, at most 10 a second of wall time while the run
            goes on, and the final one

The final verdict goes to `fly` by a line of its own, too (`verdict_line`): anybody can write on a
topic. Whoever does is named there, by the event SECOND_WRITER, and in /diagnostics.
"""

import math
import time
from typing import Any

from rclpy.serialization import serialize_message

from rvd_dynamics import verdict_line
from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.diagram.aborts import Aborts
from rvd_dynamics.diagram.build import made
from rvd_dynamics.diagram.judge import aborted, judgement
from rvd_dynamics.diagram.ros.boundary import content, read, Refused
from rvd_dynamics.diagram.ros.conversions import header_at, verdict_to_msg
from rvd_dynamics.diagram.ros.host import Host, message_type
from rvd_dynamics.diagram.ros.node import RunNode
from rvd_dynamics.diagram.ros.writers import LOOK_S, Writers
from rvd_dynamics.diagram.roster import MONITOR
from rvd_interfaces.msg import RunEvent, Verdict

GAP_S = 2.0                     # [s] wall time in which what is due may still come
IN_A_ROW = 16                   # [steps] that come too early, if the plant's word cannot be had
ABORT_S = 0.5                   # [s] wall time in which the guard's last word may still come
PERIOD_S = 0.1                  # [s] wall time between two verdicts under way


class MissionMonitor(RunNode):
    """The judge as a node."""

    def __init__(self, host: Host) -> None:
        super().__init__(host, MONITOR)
        self._out = self.writer('/run/verdict', Verdict)
        self._published = time.monotonic()
        self._judged_final = False
        self._aborts = Aborts(self.run.step_s)
        self._board_step = -1                   # newest that was looked at
        self._board = b''                       # the newest of it from another process, serialised
        self._board_is_local = True
        self._final_at: float | None = None     # wall time at which the final truth came
        self._writers = Writers(self.roster, host.run_id, self)
        self._ahead: range = range(0)           # steps in a row that came before they were due
        self._looks = 0                         # since then, without a step that was due
        own = {'batch': ()}
        self._judge = made(self.scenario.mission.judge,
                           lambda name: own[name] if name in own else self.scenario.part(name),
                           'judge')

    def connect(self) -> None:
        """Listen to the truth, and see who writes."""
        self.create_timer(LOOK_S, self.guarded(self._look))
        self._follow_aborts()
        truth = self.roster.diagram.truth
        if self.host.is_local(truth.name):
            self.host.take(truth.name, self.guarded(self._on_truth))
            return
        self._taken = content(truth, self.codec_of(truth))
        self.watch(truth.name, message_type(truth.message), self._heard, rests=True)

    # -- aborts ---------------------------------------------------------------------------

    def _follow_aborts(self) -> None:
        """Listen to what shows an ABORT on board and to what the run says."""
        diagram, shown = self.roster.diagram, self.roster.diagram.abort_shown
        if shown is None:
            return
        signal = diagram.signals[shown.signal]
        if self.host.is_local(signal.name):
            self.host.take(signal.name, self.guarded(self._on_board))
        else:
            self._board_is_local = False
            self._board_kind = message_type(signal.message)
            self._board_taken = content(signal, self.codec_of(signal))
            self.watch(signal.name, self._board_kind, self._on_board_bytes, raw=True)
        if any(block.control for block in diagram.blocks if block.name in self.host.nodes):
            self.host.take('/run/events', self.guarded(self._on_event))
        else:
            self.watch('/run/events', RunEvent, lambda m: self._on_event(m.step, m))

    def _on_event(self, step: int, event: RunEvent) -> None:
        self._aborts.event(step, event.code)

    def _on_board(self, step: int, value: Any) -> None:
        shown = self.roster.diagram.abort_shown
        self._aborts.board(step, getattr(value, shown.part) == shown.value)

    def _on_board_bytes(self, data: bytes) -> None:
        """Keep what is on board; it is looked at once an ABORT has been asked for."""
        self._board = data
        if self._aborts.asked:
            self._look_on_board()
            self._end_if_known()

    def _look_on_board(self) -> None:
        data, self._board = self._board, b''
        if not data:
            return
        try:
            message = read(data, self._board_kind)
            self._on_board(message.step, self._board_taken(message.step, message))
            self._board_step = max(self._board_step, message.step)
        except Refused as why:
            self.refuse(self.roster.diagram.abort_shown.signal, str(why))

    # -- truth ----------------------------------------------------------------------------

    def _heard(self, message: Any) -> None:
        """Take truth from another process, if it is of the step that comes next."""
        step, due = message.step, self.step + 1
        newest = self.host.made
        try:
            if newest is not None and step > newest:
                raise Refused(f'step {step} has not been: this is step {newest}')
            if step < due:
                raise Refused(f'step {step} has been judged already')
            if step > due:
                self._beyond(step, due)
            value = self._taken(step, message)
            end = self.host.noted_end
            if end is not None and bool(value.final) != (step == end):
                raise Refused(f'step {step} {"is" if step == end else "is not"} the last')
        except Refused as why:
            self.refuse(self.roster.diagram.truth.name, str(why))
            return
        self._ahead, self._looks = range(0), 0
        if self.host.final_step is not None:
            self.host.ending.goes_on(step)
        self._on_truth(step, value)

    def _beyond(self, step: int, due: int) -> None:
        """
        Refuse a step that is not due yet; what is due has GAP_S to come.

        A stranger can make such a step; he cannot keep the one that is due from coming.
        """
        if step > self.run.last_step:
            raise Refused(f'step {step} is beyond {self.run.last_step}, the last of any run here')
        in_a_row = self._ahead and step == self._ahead.stop
        self._ahead = range(self._ahead.start if in_a_row else step, step + 1)
        raise Refused(f'step {step} came where {due} is due')

    def _look_at_gap(self) -> None:
        """
        End if what is due has not come for so long; who was stopped hears before it looks often.

        A later step that the plant has noted says that the one which is due was sent. Without the
        plant's word, several in a row say so, or one that ends with the run.

        Raises
        ------
        BadInput
            If it is lost.
        """
        if not self._ahead:
            return
        self._looks += 1
        if self._looks*LOOK_S < GAP_S or not (
                self.host.made is not None or len(self._ahead) >= IN_A_ROW
                or self.host.final_step in self._ahead):
            return
        raise BadInput(f'truth jumps from step {self.step} to {self._ahead.start}: a run with a '
                       'gap cannot be judged')

    def _on_truth(self, step: int, truth: Any) -> None:
        self.step = step
        self._judge.follow(step, truth)
        now = time.monotonic()
        if truth.final:
            self._final_at = now
            self._end_if_known()
        elif now - self._published >= PERIOD_S:
            self._published = now
            self._publish(False)
        self.host.diagnose()

    def _end_if_known(self) -> None:
        """Say the final verdict, once it is known whether an ABORT was in force."""
        if self._judged_final or self._final_at is None:
            return
        if self._aborts.asked and math.isnan(self._aborts.since(self.step)):
            self._look_on_board()
            if (self._board_step < self.step - 1 and not self._board_is_local
                    and time.monotonic() - self._final_at < ABORT_S):
                return                          # its last word is under way
        self._judged_final = True
        self._publish(True)
        self.finish()

    def _publish(self, final: bool) -> None:
        verdict = self._judge.verdict(final)
        if final:
            verdict = aborted(verdict, self._aborts.since(self.step))
        judged = judgement(self._judge, verdict)
        header = header_at(self.step * self.run.step_ns, self.run.frame_id)
        message = serialize_message(verdict_to_msg(header, self.step, final, judged))
        if final:
            verdict_line.tell(verdict_line.VERDICT, message)
        self.host.publish(self._out, '/run/verdict', self.step, message)

    def _look(self) -> None:
        self._end_if_known()
        self._look_at_gap()
        for stranger in self._writers.look(self.host.begun, self.host.traced):
            self.trouble[f'{stranger.topic} {stranger.node}'] = stranger.words
            self.event(stranger.code, stranger.words)
            if stranger.counts:
                verdict_line.tell(verdict_line.STRANGER, stranger.words.encode())

    def on_end(self, final_step: int) -> None:
        """Judge the final truth first, which may still be on its way."""
        if self._judged_final:
            self.finish()
