"""
The stranger of `bench attack dds`: SCENARIO SEED COUNT; prints how many messages it has sent.

It comes into the domain when a line comes on its standard input, and is ready by then.

Frames on the topics of the link as `frames` makes them, and mutated messages on the rest of the
ring, but for the ground's command: by that the judge knows what the ground has sent.
"""

from pathlib import Path
from random import Random
import sys
import time

import rclpy
from rclpy.serialization import serialize_message

from rvd_campaign.bench import hostile
from rvd_campaign.bench.attack.frames import Hostile, legs_of
from rvd_dynamics.diagram.ros import qos
from rvd_dynamics.diagram.ros.host import message_type
from rvd_dynamics.diagram.roster import Roster
from rvd_dynamics.diagram.scenario import load, Scenario

SPARED = ('/ground/command', '/onboard/thruster_command')       # what the judge compares
FRAMES = 0.7                    # share of frames
MATCHED_S = 20.0                # [s] wall time in which a reader is found
SEND_S = 30.0                   # [s] wall time
AT_ONCE = 50                    # messages between two looks


def main(path: str, seed: int, count: int) -> int:
    """Publish; return how many messages were sent while somebody heard them."""
    scenario, rng = load(Path(path)), Random(seed)
    roster = Roster(scenario)
    kinds = {topic: message_type(name) for topic, name in roster.topics.items()
             if topic not in SPARED}
    legs = _legs(scenario, rng)
    sys.stdin.readline()
    rclpy.init(args=[])
    node = rclpy.create_node(f'stranger_{seed}', enable_rosout=False,
                             start_parameter_services=False)
    writers = {topic: node.create_publisher(kind, topic, qos.of(topic))
               for topic, kind in kinds.items()}
    others = sorted(set(kinds) - {topic for _, topic in legs})
    deadline = time.monotonic() + MATCHED_S
    while not _heard(writers) and time.monotonic() < deadline:
        time.sleep(0.05)
    sent, deadline = 0, time.monotonic() + SEND_S
    while sent < count and _heard(writers) and time.monotonic() < deadline:
        for _ in range(AT_ONCE):
            k = rng.randint(0, scenario.run.last_step)
            if rng.random() < FRAMES:
                made, topic = rng.choice(legs)
                frame = made.envelope(k)
                if rng.random() < 0.5:          # of a step that is waited for, maybe
                    frame = frame._replace(step=k)
                data = frame.serialised()
            else:
                topic = rng.choice(others)
                _, message = hostile.mutant(kinds[topic](), rng.getrandbits(32))
                data = serialize_message(message)
            writers[topic].publish(data)
            sent += 1
    time.sleep(0.2)                             # what is on its way gets there
    return sent


def _legs(scenario: Scenario, rng: Random) -> list[tuple[Hostile, str]]:
    """Return what makes hostile frames for each topic of frames."""
    found = []
    for leg, block in zip(legs_of(scenario, []), scenario.diagram.legs()):
        made = Hostile(leg, scenario, rng)
        made.seen(leg.sender.encode(0, leg.value).payload)
        found += [(made, block.reads['content'].signal.name), (made, block.writes['arrival'].name)]
    return found


def _heard(writers: dict) -> bool:
    return any(writer.get_subscription_count() > 0 for writer in writers.values())


if __name__ == '__main__':
    print(main(sys.argv[1], int(sys.argv[2]), int(sys.argv[3])), flush=True)
    import os
    os._exit(0)                                 # it is nobody's: nothing is to be taken down
