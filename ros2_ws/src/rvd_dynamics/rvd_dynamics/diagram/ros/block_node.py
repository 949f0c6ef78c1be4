"""A block as a node: what computes, its codecs, and the service that controls a run."""

import struct
from typing import Any

import numpy as np
from std_msgs.msg import Bool

from rvd_dynamics.diagram.block import Block
from rvd_dynamics.diagram.build import made
from rvd_dynamics.diagram.control import Control, MODE_EVENT, MODE_WORDS
from rvd_dynamics.diagram.diagram import DiagramError
from rvd_dynamics.diagram.in_process import everything
from rvd_dynamics.diagram.ros.firing import FiringNode
from rvd_dynamics.diagram.ros.host import Host, message_type
from rvd_dynamics.diagram.ros.node import LONGEST
from rvd_dynamics.diagram.signal import Signal
from rvd_interfaces.srv import RunControl


class BlockNode(FiringNode):
    """A block as a node."""

    def __init__(self, host: Host, block: Block) -> None:
        super().__init__(host, block)
        self._outputs = {name: (signal, self.codec_of(signal),
                                self.writer(signal.name, message_type(signal.message)))
                         for name, signal in block.writes.items()}
        self._commands = [name for name, signal in block.writes.items() for part in signal.parts
                          if part.name == 'command' and part.dtype.startswith('f')]
        self._control = Control()
        if block.control:
            self._serve_control()

    def make(self) -> None:
        """Make what computes: after the endpoints, which find their partners meanwhile."""
        block, run = self.block, self.run
        own = {name: draw.of_run(run.seed, run.run, run.last_step + 1)
               for name, draw in block.draws.items()}
        own |= {'batch': (), 'block': block, 'runs': [run.run], 'steps': run.last_step + 1,
                'abort_step': None, 'wanted': everything(block)}
        if block.settings:
            own['settings'] = self.scenario.settings(block.section)

        def available(name: str) -> Any:
            return own[name] if name in own else self.scenario.part(name)
        made_of = made(block.make, available, f'block {block.name}')
        self._compute, self._news = made_of.step, getattr(made_of, 'news', None)

    def on_step(self, k: int, values: dict[str, Any]) -> None:
        """Compute and publish."""
        for name, source in self._held.items():
            values[name] = source.value(k)
        for name, read in self.block.reads.items():
            if read.late:
                values[read.late] = self._inputs[name].take_late()
        if self.block.control:
            values['control'] = self._decided()
        outputs = self._compute(k, **values)
        if self._news is not None:
            for code, text in self._news():
                self.event(code, text)
        if k == 0 or self._commands:
            self._check(k, outputs)
        self.before_publishing(k, outputs)
        publish = self.host.publish
        for name, (signal, codec, publisher) in self._outputs.items():
            if signal.still and k:
                continue
            try:
                value = outputs[name]
                made_of = codec.encode(k, value)
            except Exception as error:          # noqa: B902 - said better, or handed on
                self._check(k, outputs)
                if isinstance(error, (ValueError, struct.error)):
                    raise self._refusal(k, signal, error) from error
                raise
            if codec.frames:
                publish(publisher, signal.name, k, made_of.serialised(), made_of)
            else:
                publish(publisher, signal.name, k, made_of, value)

    def before_publishing(self, k: int, outputs: dict[str, Any]) -> None:
        """Look at the outputs of step k."""

    def _check(self, k: int, outputs: Any) -> None:
        """
        Refuse outputs that have not the form of their signals, or a command that is no number.

        All of it at the first firing, and at each one where the command is a float. Later a value
        of another form is noticed when it does not go into its message.
        """
        given = set(outputs) if isinstance(outputs, dict) else set()
        if given != set(self._outputs):
            raise DiagramError(f'block {self.block.name}: step must return a value for each of '
                               f'{", ".join(self._outputs) or "no output"} by name, got '
                               f'{", ".join(sorted(given)) or type(outputs).__name__}')
        for name, (signal, _, _) in self._outputs.items():
            complaint = signal.complaint(outputs[name], ())
            if complaint:
                raise self._refusal(k, signal, complaint)
        for name in self._commands:
            command = outputs[name].command
            if not np.isfinite(command).all():
                raise self._refusal(k, self.block.writes[name],
                                    f'a command must be finite, got {np.asarray(command).tolist()}')

    def _refusal(self, k: int, signal: Signal, why: Any) -> DiagramError:
        return DiagramError(f'block {self.block.name} writes {signal.name} at step {k}: {why}')

    # -- control ----------------------------------------------------------------------------

    def _serve_control(self) -> None:
        scenario = self.scenario
        if scenario.has_shared('mode'):
            mode = scenario.part('operation').mode
            self._control = Control(mode, next_mode=mode)
        self._pause = self.writer('/run/pause', Bool)
        self.create_service(RunControl, '/run/control', self._on_control)

    def _decided(self) -> Control:
        """
        Return what is in force in this step, and let a new mode be so from the next one on.

        A mode is told to other blocks of the ring before it counts, so that all change in one
        step; an abort has no need of them and goes out at once.
        """
        now = self._control
        if now.next_mode != now.mode:
            self.event(MODE_EVENT, MODE_WORDS + now.next_mode)
            self._control = now._replace(mode=now.next_mode)
        return now

    def _on_control(self, request: RunControl.Request, response: RunControl.Response
                    ) -> RunControl.Response:
        actions, modes = RunControl.Request, self.scenario.mission.modes
        response.accepted = True
        if request.action in (actions.PAUSE, actions.RESUME):
            pause = request.action == actions.PAUSE
            self.host.publish(self._pause, '/run/pause', -1, Bool(data=pause))
            response.message = 'paused' if pause else 'resumed'
        elif request.action == actions.MODE and request.mode in modes:
            self._control = self._control._replace(next_mode=request.mode)
            response.message = f'mode {request.mode}'
        elif request.action == actions.ABORT:
            self._control = self._control._replace(abort=True)
            response.message = 'abort goes out with the next frame'
            self.event('ABORT', response.message)
        else:
            response.accepted = False
            response.message = (f'mode must be one of {", ".join(modes) or "none"}, got '
                                f'{request.mode[:LONGEST]!r}' if request.action == actions.MODE
                                else f'unknown action {request.action}')
        return response
