"""SQLite: bags of that kind, with tables that are none and files beside them."""

from contextlib import closing, suppress
import os
from pathlib import Path
from random import Random
import sqlite3

import zstandard

from rvd_campaign.bench.damaged.of_bytes import OF_BYTES
from rvd_campaign.bench.damaged.content import content_of

TABLES = '''
CREATE TABLE topics(id INTEGER PRIMARY KEY, name TEXT NOT NULL, type TEXT NOT NULL,
  serialization_format TEXT NOT NULL, offered_qos_profiles TEXT NOT NULL,
  type_description_hash TEXT NOT NULL);
CREATE TABLE message_definitions(id INTEGER PRIMARY KEY, topic_type TEXT NOT NULL,
  encoding TEXT NOT NULL, encoded_message_definition TEXT NOT NULL,
  type_description_hash TEXT NOT NULL);
CREATE TABLE messages(id INTEGER PRIMARY KEY, topic_id INTEGER NOT NULL,
  timestamp INTEGER NOT NULL, data BLOB NOT NULL);
'''
ENDLESS = ('WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n) '
           "SELECT i AS id, 1 AS topic_id, i AS timestamp, x'00' AS data FROM n")
HOSTILE = (
    f'DROP TABLE messages; CREATE VIEW messages AS {ENDLESS};',
    f'DROP TABLE messages; CREATE VIEW messages AS {ENDLESS.replace("i + 1", "i")};',
    'DROP TABLE messages; CREATE TABLE messages(id INTEGER PRIMARY KEY, topic_id, timestamp, '
    'data BLOB GENERATED ALWAYS AS (zeroblob(900000000)) VIRTUAL);'
    'INSERT INTO messages(topic_id, timestamp) VALUES (1, 1), (1, 2), (1, 3);',
    'DROP TABLE topics; CREATE VIEW topics AS WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT '
    "i + 1 FROM n) SELECT i AS id, 'x' AS name, 'y' AS type, 'cdr' AS serialization_format FROM n;",
    'DROP TABLE topics;', 'DROP TABLE messages;', 'DROP TABLE message_definitions;',
    'ALTER TABLE messages RENAME COLUMN data TO datum;', 'DELETE FROM topics;',
    "UPDATE messages SET data = 'text';", 'UPDATE messages SET data = 5;',
    'UPDATE messages SET timestamp = -1;', "UPDATE messages SET timestamp = 'x' WHERE id % 2;",
    'UPDATE messages SET topic_id = 99;',
    'UPDATE messages SET data = zeroblob(3000000) WHERE id < 20;',
    "UPDATE topics SET name = x'ff00ff';", "UPDATE topics SET name = CAST(x'ff' AS TEXT);",
    'UPDATE topics SET type = 7;', "UPDATE message_definitions SET encoded_message_definition = "
    "hex(zeroblob(1000000));", 'PRAGMA journal_mode=WAL;', 'PRAGMA encoding="UTF-16";',
    "CREATE TRIGGER t AFTER INSERT ON messages BEGIN SELECT 1; END;",
    "DROP TABLE messages; CREATE VIRTUAL TABLE messages USING fts5(id, topic_id, timestamp, data);")


def damage(rng: Random, base: Path, bag: Path) -> None:
    """Leave the bag in SQLite, changed by a statement, in its bytes or beside it."""
    content, path = content_of(base), bag / 'bag_0.db3'
    with closing(sqlite3.connect(path)) as made:
        made.executescript(TABLES)
        for number, c in content.channels.items():
            made.execute('INSERT INTO topics VALUES (?, ?, ?, ?, ?, ?)', (
                number, c.topic, content.schemas[c.schema_id].name, c.message_encoding, '', ''))
        for number, s in content.schemas.items():
            made.execute('INSERT INTO message_definitions VALUES (?, ?, ?, ?, ?)', (
                number, s.name, s.encoding, s.data.decode(), ''))
        made.executemany('INSERT INTO messages(topic_id, timestamp, data) VALUES (?, ?, ?)', (
            (m.channel_id, m.log_time, m.data) for m in content.messages))
        made.commit()
        if rng.random() < 0.6:
            with suppress(sqlite3.Error):       # an old SQLite does not know all of it
                made.executescript(rng.choice(HOSTILE))
                made.commit()
    data = path.read_bytes()
    if rng.random() < 0.4:
        data = rng.choice(OF_BYTES)(rng, data)
    path.write_bytes(data)
    beside = rng.randrange(8)
    if beside == 0:
        os.mkfifo(f'{path}-wal')
    elif beside == 1:
        Path(f'{path}-wal').write_bytes(rng.randbytes(5000))
    elif beside == 2:
        Path(f'{path}-journal').write_bytes(rng.randbytes(5000))
    elif beside == 3:
        Path(f'{path}-wal').symlink_to('/dev/zero')
    elif beside == 4:
        path.rename(f'{path}.plain')
        Path(f'{path}.zstd').write_bytes(zstandard.compress(data))
