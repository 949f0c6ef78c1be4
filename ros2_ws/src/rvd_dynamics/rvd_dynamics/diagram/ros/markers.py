"""
The scene for RViz and Foxglove, drawn by a node outside the ring.

Watches     /ground/estimate, /ground/prediction, /truth/relative_state, and what the mission's
            scene names
Publishes   /viz/corridor, /viz/control_boundary    visualization_msgs/MarkerArray, latched
            /viz/target             MarkerArray, latched: what stands still in a mission's scene
            /viz/obstacles          MarkerArray: what moves in it, as the ground foresees it
            /viz/chaser             MarkerArray: where the ground knows the chaser was
            /viz/ghost              MarkerArray: where it will be when a command sent now acts,
                                    with the ellipsoid of that prediction
            /viz/trail/estimate, /viz/trail/prediction      nav_msgs/Path
            /viz/truth, /viz/trail/truth                    only with `show_truth`
            /tf_static              tf2_msgs/TFMessage: the frame that all is drawn in
Parameters  the fields of MarkerParams

All is in the target orbital frame. It looks at the newest message ten times a second of wall
time, sleeps in between and keeps no queues, so that it costs the same however fast the run is.
"""

from collections.abc import Callable
import time

from geometry_msgs.msg import Point, Pose, PoseStamped, Quaternion, TransformStamped, Vector3
from nav_msgs.msg import Path
import numpy as np
from rclpy.publisher import Publisher
from rclpy.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy
from std_msgs.msg import ColorRGBA, Header
from tf2_msgs.msg import TFMessage
from visualization_msgs.msg import Marker, MarkerArray

from rvd_dynamics.geometry import cone, surfaces
from rvd_dynamics.recording.params import MarkerParams
from rvd_dynamics.diagram.build import loaded
from rvd_dynamics.diagram.display import Field, Spheres
from rvd_dynamics.diagram.ros import qos
from rvd_dynamics.diagram.ros.boundary import content, read, Refused
from rvd_dynamics.diagram.ros.codecs import Parts
from rvd_dynamics.diagram.ros.host import Host
from rvd_dynamics.diagram.ros.node import RunNode
from rvd_dynamics.diagram.roster import MARKERS, STATE
from rvd_dynamics.diagram.scenario import Scenario
from rvd_interfaces.msg import RelativeState, Values

TRAIL_EVERY = 5                 # [pictures] a trail is long: draw it less often
STATIONS = 31                   # along the control boundary
BODY_M = 0.6                    # [m] edge of the chaser's box; a symbol, not its size
NEWEST = QoSProfile(depth=1, reliability=ReliabilityPolicy.RELIABLE,
                    durability=DurabilityPolicy.TRANSIENT_LOCAL)
WALL, BOUNDARY = (0.84, 0.37, 0.0), (0.90, 0.62, 0.0)       # colours of Okabe and Ito
KNOWN, PREDICTED, TRUE = (0.85, 0.85, 0.85), (0.34, 0.71, 0.91), (0.0, 0.62, 0.45)
OBSTACLE = (0.8, 0.47, 0.65)
TOPICS = {                      # what viewers may ask for; truth only with `show_truth`
    '/viz/corridor': MarkerArray, '/viz/control_boundary': MarkerArray,
    '/viz/target': MarkerArray, '/viz/obstacles': MarkerArray,
    '/viz/chaser': MarkerArray, '/viz/ghost': MarkerArray, '/viz/truth': MarkerArray,
    '/viz/trail/estimate': Path, '/viz/trail/prediction': Path, '/viz/trail/truth': Path}
SOURCES = {'/ground/estimate': ('chaser', 'estimate', KNOWN),
           '/ground/prediction': ('ghost', 'prediction', PREDICTED),
           '/truth/relative_state': ('truth', 'truth', TRUE)}


class Markers(RunNode):
    """The scene as a node."""

    def __init__(self, host: Host) -> None:
        super().__init__(host, MARKERS)
        self._params: MarkerParams = self.scenario.settings(MARKERS)
        self._newest: dict[str, bytes] = {}
        self._bodies, self._trails, self._paths = {}, {}, {}
        self._field: Field | None = None
        if self.scenario.mission.scene:
            self._field = loaded(self.scenario.mission.scene)(self.scenario)
        # the truth too, whose writer waits for its readers
        self._watched = [topic for topic in SOURCES if self.host.roster.topics.get(topic) == STATE]
        for topic, (body, trail, _) in SOURCES.items():
            shown = topic != '/truth/relative_state' or self._params.show_truth
            if shown and topic in self._watched:
                self._bodies[topic] = self._viewed(f'/viz/{body}', qos.VIEW)
                self._trails[topic] = self._viewed(f'/viz/trail/{trail}', qos.VIEW)
                self._paths[topic] = Path(header=Header(frame_id=self.run.frame_id))
        self._pictures = 0
        self._moving: dict[str, tuple[Spheres, Callable]] = {}
        signals = self.scenario.diagram.signals
        self._taken = {topic: content(signals[topic], self.codec_of(signals[topic]),
                                      ('covariance',)) for topic in self._watched}
        still = {}
        if self._field is None or self._field.corridor:
            still = still_scene(self.scenario, self._params.boundary_rate_m_s
                                or self.scenario.part('approach_rate_m_s'))
        if self._field is not None:
            still |= {'/viz/target': still_spheres(self._field, self.run.frame_id)}
            for spheres in self._field.moving:
                signal = self.scenario.diagram.signals[spheres.rows.signal]
                self._moving[signal.name] = spheres, content(signal, Parts(signal, self.run))
            self._obstacles = self._viewed('/viz/obstacles', qos.VIEW)
        for topic, markers in still.items():
            self._viewed(topic, qos.LATCHED).publish(markers)
        self._say_where()

    def _viewed(self, topic: str, profile: QoSProfile) -> Publisher:
        return self.create_publisher(TOPICS[topic], topic, profile)

    def _look_at(self, topic: str, kind: type) -> None:
        """Let only the newest message wait, as bytes."""
        def keep(data: bytes, _: dict) -> None:
            self._newest[topic] = data
        if self.host.is_local(topic):
            self.host.keep(topic, lambda step, data: keep(data, {}))
        else:
            self.watch_raw(topic, kind, keep, NEWEST)

    def connect(self) -> None:
        """Listen."""
        for topic in self._watched:
            self._look_at(topic, RelativeState)
        for topic in self._moving:
            self._look_at(topic, Values)

    def _say_where(self) -> None:
        """Make the frame known to tf2: RViz warns without."""
        transform = TransformStamped(header=Header(frame_id=self.run.frame_id),
                                     child_frame_id='target')
        self.create_publisher(TFMessage, '/tf_static', qos.LATCHED).publish(
            TFMessage(transforms=[transform]))

    def on_ready(self) -> None:
        """Begin to draw."""
        self.create_timer(1.0 / self._params.rate_hz, self.guarded(self._picture))

    def on_end(self, final_step: int) -> None:
        """Draw the last picture."""
        self._draw(trails=True)
        self.finish()

    def _picture(self) -> None:
        begin = time.monotonic()
        self._draw(trails=self._pictures % TRAIL_EVERY == 0)
        self._pictures += 1
        # Whatever comes meanwhile replaces what came before: a run at full speed would wake
        # this node for every message and be slowed down by it.
        if len(self.host.nodes) == 1:
            time.sleep(max(0.0, 0.9 / self._params.rate_hz - (time.monotonic() - begin)))

    def _draw(self, trails: bool) -> None:
        for topic, data in list(self._newest.items()):
            try:
                if topic in self._bodies:
                    self._draw_one(topic, read(data, RelativeState))
                elif topic in self._moving:
                    self._draw_spheres(read(data, Values), *self._moving[topic])
            except Refused as why:
                self.refuse(topic, str(why))
        self._newest.clear()
        if trails:
            for topic, path in self._paths.items():
                if path.poses:
                    self._trails[topic].publish(path)

    def _draw_one(self, topic: str, state: RelativeState) -> None:
        if state.step > self.run.last_step:
            raise Refused(f'step {state.step} is beyond {self.run.last_step}, the last of any run')
        self._taken[topic](state.step, state)
        self.step = max(self.step, state.step)
        if not state.valid:
            return
        name, _, colour = SOURCES[topic]
        size = BODY_M if self._field is None else 2.0 * self._field.craft_radius_m
        self._bodies[topic].publish(body(state, name, colour, self._params.ellipsoid_sigma, size))
        self._lengthen(self._paths[topic], state)

    def _draw_spheres(self, message: Values, spheres: Spheres, taken: Callable) -> None:
        rows = getattr(taken(message.step, message), spheres.rows.part)
        self._obstacles.publish(MarkerArray(markers=[
            sphere(message.header, spheres.name, i, place[:3].tolist(), radius, OBSTACLE, 0.75)
            for i, (place, radius) in enumerate(zip(rows, spheres.radii_m))
            if np.isfinite(place[:3]).all()]))

    def _lengthen(self, path: Path, state: RelativeState) -> None:
        """Add a point; a trail that has become too long loses every other one."""
        path.header.stamp = state.header.stamp
        path.poses.append(PoseStamped(header=state.header, pose=Pose(position=_point(state))))
        if len(path.poses) > self._params.trail_points:
            path.poses = path.poses[::2]


def still_scene(scenario: Scenario, rate: float) -> dict[str, MarkerArray]:
    """Return what does not move: the corridor with the target, and the control boundary."""
    header = Header(frame_id=scenario.run.frame_id)
    corridor, delay_s = scenario.part('cone'), scenario.part('leg_params').loop_s
    far = scenario.part('start').position_m[0] - 2.0
    ends = np.array([far, 0.0])
    x = np.linspace(far, 0.0, STATIONS)
    inner = cone.control_boundary(
        x, corridor, scenario.part('orbit').mean_motion, rate=rate, delay=delay_s)
    target = Marker(header=header, ns='target', id=0, type=Marker.CUBE, action=Marker.ADD,
                    color=_rgba(KNOWN, 0.9), scale=Vector3(x=1.0, y=1.0, z=1.0),
                    pose=Pose(position=Point(x=0.5)))
    return {
        '/viz/corridor': MarkerArray(markers=[
            _surface(header, 'wall', ends, cone.radius(ends, corridor), WALL, 0.12),
            _ring(header, 'docking plane', corridor.docking_radius_m, WALL), target]),
        '/viz/control_boundary': MarkerArray(markers=[
            _surface(header, 'boundary', x, inner, BOUNDARY, 0.15)])}


def still_spheres(field: Field, frame_id: str) -> MarkerArray:
    """Return the spheres of a scene that stand still."""
    header = Header(frame_id=frame_id)
    looks = {'target': (KNOWN, 0.9), 'limit': (OBSTACLE, 0.75)}
    return MarkerArray(markers=[
        sphere(header, each.name, 0, list(each.place), each.radius_m,
               *looks.get(each.role, (BOUNDARY, 0.15))) for each in field.still])


def sphere(header: Header, name: str, number: int, place: list, radius: float, colour: tuple,
           opacity: float) -> Marker:
    """Return a sphere at a place [m]."""
    x, y, z = map(float, place)
    return Marker(header=header, ns=name, id=number, type=Marker.SPHERE, action=Marker.ADD,
                  pose=Pose(position=Point(x=x, y=y, z=z)), color=_rgba(colour, opacity),
                  scale=Vector3(x=2.0*radius, y=2.0*radius, z=2.0*radius))


def body(state: RelativeState, name: str, colour: tuple, sigmas: float, size: float = BODY_M
         ) -> MarkerArray:
    """Return a box with its velocity and, if it is estimated, its ellipsoid."""
    header, at = state.header, Pose(position=_point(state))
    box = Marker(header=header, ns=name, id=0, type=Marker.CUBE, action=Marker.ADD, pose=at,
                 color=_rgba(colour, 0.9 if name == 'chaser' else 0.45),
                 scale=Vector3(x=size, y=size, z=size))
    ahead = Point(x=at.position.x + 10.0 * state.velocity.x,
                  y=at.position.y + 10.0 * state.velocity.y,
                  z=at.position.z + 10.0 * state.velocity.z)
    arrow = Marker(header=header, ns=f'{name} velocity, 10 s', id=0, type=Marker.ARROW,
                   action=Marker.ADD, color=_rgba(colour, 0.8), points=[at.position, ahead],
                   scale=Vector3(x=0.06, y=0.14, z=0.2))
    made = [box, arrow]
    if not np.isnan(state.covariance[0]):
        covariance = np.asarray(state.covariance).reshape(6, 6)[:3, :3]
        half, q = surfaces.ellipsoid(covariance, sigmas)
        x, y, z = (2.0 * half).tolist()
        turn = Quaternion(**dict(zip('xyzw', q.tolist())))
        made.append(Marker(
            header=header, ns=f'{name} uncertainty', id=0, type=Marker.SPHERE, action=Marker.ADD,
            pose=Pose(position=at.position, orientation=turn), color=_rgba(colour, 0.35),
            scale=Vector3(x=x, y=y, z=z)))
    return MarkerArray(markers=made)


def _surface(header: Header, name: str, x: np.ndarray, radius: np.ndarray, colour: tuple,
             opacity: float) -> Marker:
    corners = surfaces.revolved(x, radius).reshape(-1, 3).tolist()
    return Marker(header=header, ns=name, id=0, type=Marker.TRIANGLE_LIST, action=Marker.ADD,
                  scale=Vector3(x=1.0, y=1.0, z=1.0), color=_rgba(colour, opacity),
                  points=[Point(x=x, y=y, z=z) for x, y, z in corners])


def _ring(header: Header, name: str, radius: float, colour: tuple) -> Marker:
    angle = np.linspace(0.0, 2.0 * np.pi, 73)
    return Marker(header=header, ns=name, id=0, type=Marker.LINE_STRIP, action=Marker.ADD,
                  scale=Vector3(x=0.02), color=_rgba(colour, 1.0),
                  points=[Point(y=radius * c, z=radius * s)
                          for c, s in zip(np.cos(angle).tolist(), np.sin(angle).tolist())])


def _rgba(colour: tuple, opacity: float) -> ColorRGBA:
    return ColorRGBA(r=colour[0], g=colour[1], b=colour[2], a=opacity)


def _point(state: RelativeState) -> Point:
    p = state.position
    return Point(x=p.x, y=p.y, z=p.z)
