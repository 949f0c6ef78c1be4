"""
The description that rosbag2 expects of a bag: `metadata.yaml`, version 9.

Readers require every key; qualities of service are spelt in words. The same text without its
outer key goes into the MCAP file as metadata record `rosbag2`.

Source  rosbag2 of ROS 2 Jazzy: `rosbag2_storage/yaml.hpp`, `qos.cpp`.
"""

import os
from dataclasses import dataclass, field
from pathlib import Path
from textwrap import indent
from typing import Any

import yaml

from rvd_dynamics.recording import whole

VERSION = 9
INFINITE = {'sec': 9223372036, 'nsec': 854775807}   # RMW_DURATION_INFINITE


@dataclass
class Topic:
    """One recorded topic and how many of its messages the bag holds."""

    name: str
    kind: str                                   # pkg/msg/Type
    type_hash: str
    qos: list[dict[str, Any]]
    count: int = 0


@dataclass
class Contents:
    """What a bag holds: topics by name, and the log times [ns] of its first and last message."""

    topics: dict[str, Topic] = field(default_factory=dict)
    start_ns: int = 0
    end_ns: int = 0
    count: int = 0

    def add(self, topic: Topic, log_ns: int) -> None:
        """Count one message."""
        if log_ns < self.start_ns or not self.count:
            self.start_ns = log_ns
        if log_ns > self.end_ns or not self.count:
            self.end_ns = log_ns
        self.count += 1
        topic.count += 1


def qos_words(depth: int, reliable: bool, transient_local: bool) -> list[dict[str, Any]]:
    """Return `offered_qos_profiles` of one writer with a history of `depth`."""
    return [{
        'history': 'keep_last',
        'depth': depth,
        'reliability': 'reliable' if reliable else 'best_effort',
        'durability': 'transient_local' if transient_local else 'volatile',
        'deadline': dict(INFINITE),
        'lifespan': dict(INFINITE),
        'liveliness': 'automatic',
        'liveliness_lease_duration': dict(INFINITE),
        'avoid_ros_namespace_conventions': False,
    }]


def information(contents: Contents, file_name: str) -> dict[str, Any]:
    """Return the bag information with every key that version 9 requires."""
    times = {'starting_time': {'nanoseconds_since_epoch': contents.start_ns},
             'duration': {'nanoseconds': contents.end_ns - contents.start_ns},
             'message_count': contents.count}
    return {
        'version': VERSION,
        'storage_identifier': 'mcap',
        **times,
        'topics_with_message_count': [
            {'topic_metadata': {'name': topic.name, 'type': topic.kind,
                                'serialization_format': 'cdr',
                                'offered_qos_profiles': topic.qos,
                                'type_description_hash': topic.type_hash},
             'message_count': topic.count}
            for topic in contents.topics.values()],
        'compression_format': '',
        'compression_mode': '',
        'relative_file_paths': [file_name],
        'files': [{'path': file_name, **times}],
        'custom_data': {'recorder': 'rvd_dynamics'},
        'ros_distro': os.environ.get('ROS_DISTRO', 'jazzy'),
    }


def dump(contents: Contents, file_name: str) -> str:
    """Return the bag information as YAML: no anchors, no wrapping, keys in rosbag2's order."""
    return yaml.dump(information(contents, file_name), Dumper=_Plain, sort_keys=False,
                     width=1 << 20)


class _Plain(yaml.SafeDumper):
    def ignore_aliases(self, data: Any) -> bool:
        return True


def write_metadata(directory: Path, text: str) -> None:
    """Put `metadata.yaml` into the bag, whole or not at all; `text` is what `dump` returned."""
    whole.write_text(directory / 'metadata.yaml',
                     'rosbag2_bagfile_information:\n' + indent(text, '  '))
