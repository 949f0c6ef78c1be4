"""
The barrier at the start: a process begins when everything it talks to is there.

Publisher and subscription counts must be what the roster says, the writers of what it reads must
be known by name, and no node of another run may be in the domain.
"""

from typing import Any

from rclpy.timer import Timer

from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.diagram import identity
from rvd_dynamics.diagram.ros.writers import UNKNOWN_NODE
from rvd_dynamics.diagram.roster import COMMON

PERIOD_S = 0.05                 # [s] wall time between two looks at the endpoints


class Barrier:
    """What the process of `host` waits for; it is asked often, and lets the process begin once."""

    def __init__(self, host: Any) -> None:
        self._host = host
        self._timer: Timer | None = None

    def wait(self) -> None:
        """Look now and then, until the process may begin; when its first node is made."""
        self._timer = self._host.lead.create_timer(PERIOD_S, self.look)

    def look(self) -> None:
        """Let the process begin if all is there, or fail where another run is."""
        host = self._host
        waits = bool(self.unmatched()) or not self.are_known()
        other = self.others()
        if other:
            domain = host.lead.context.get_domain_id()
            host.fail(host.lead, BadInput(
                f'another run is in ROS_DOMAIN_ID={domain}: {other}; give each run its own'))
            return
        if waits:
            return
        self._timer.cancel()
        host.lead.destroy_timer(self._timer)
        host.begin()

    def unmatched(self) -> list[str]:
        """Return the topics whose other end is not there yet."""
        host, missing = self._host, []
        for node in host.nodes.values():
            for topic, publisher in node.publishers_of.items():
                readers = host.roster.expected(topic)[1]
                if topic not in COMMON and publisher.get_subscription_count() < readers:
                    missing.append(topic)
            for topic, subscription in node.subscriptions_of.items():
                writers = host.roster.expected(topic)[0]
                if topic not in COMMON and subscription.get_publisher_count() < writers:
                    missing.append(topic)
        return missing

    def are_known(self) -> bool:
        """Say whether it is known which nodes write what this process reads."""
        return not any(
            writer.node_name == UNKNOWN_NODE for node in self._host.nodes.values()
            for topic in node.subscriptions_of
            for writer in node.get_publishers_info_by_topic(topic))

    def others(self) -> str:
        """Return in words a node of another run in this domain; empty where there is none."""
        host = self._host
        ours = {name for name in host.roster.names if not (
            name in host.roster.externals and host.roster.externals[name].foreign)}
        return identity.foreign(host.lead.get_node_names_and_namespaces_with_enclaves(),
                                ours, host.run_id)
