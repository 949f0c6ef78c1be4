"""What parts of the ground ask for besides their settings, with the paper's values for the rest."""

from dataclasses import dataclass
from typing import Any

from rvd_dynamics.commands.levels import LevelForm, ThrustParams
from rvd_dynamics.diagram.build import wired
from rvd_dynamics.diagram.run import LegParams, Legs, Run
from rvd_dynamics.geometry.cone import Cone
from rvd_dynamics.motion.orbit import OrbitParams, StartParams
from rvd_groundstation.operators.pilot import Pilot
from rvd_groundstation.prediction.predictor import Predictor
from rvd_groundstation.prediction.score import Score
from rvd_groundstation.sharing import Eq25


@dataclass(frozen=True)
class Paper:
    """The paper's approach, or one that differs in what is named."""

    step_s: float = 0.5
    forward_delay_s: float = 5.0
    back_delay_s: float = 5.0
    cone: Cone = Cone()
    thrust: ThrustParams = ThrustParams()
    orbit: OrbitParams = OrbitParams()
    start: StartParams = StartParams()

    @property
    def run(self) -> Run:
        return Run(step_s=self.step_s)

    @property
    def leg_params(self) -> LegParams:
        return LegParams(self.forward_delay_s, self.back_delay_s)

    @property
    def legs(self) -> Legs:
        return self.leg_params.on(self.run)

    @property
    def form(self) -> LevelForm:
        return LevelForm(self.thrust)

    def law(self, kind: type, sharing: Any = Eq25(), **settings: Any) -> Any:
        """Return a law with these settings, wired as a scenario does it."""
        return wired(kind(**settings), lambda name: (
            sharing if name == 'sharing' else getattr(self, name)))

    def levels(self, law: Any, prediction: Any, stick: Any) -> Any:
        """Return the command of a law, as the automatic controller makes it."""
        return self.form.quantise(law.wanted(prediction, stick))

    def filter(self, kind: type, params: Any, batch: tuple = (), track: bool = True) -> Any:
        return kind(params, self.run, self.orbit, self.start, batch, track)

    def predictor(self, params: Any, batch: tuple = (), track: bool = True, kind: type = Predictor
                  ) -> Predictor:
        return kind(params, self.run, self.legs, self.orbit, self.start, self.form, batch, track)

    def score(self) -> Score:
        return Score(self.legs)

    def pilot(self, params: Any, draws: Any, skill: Any, batch: tuple = ()) -> Pilot:
        return self.wired(params).flying(draws, skill, batch)

    def wired(self, part: Any) -> Any:
        """Return settings with what they ask for besides."""
        return wired(part, lambda name: getattr(self, name))
