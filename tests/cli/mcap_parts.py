# SPDX-FileCopyrightText: 2026 The Lanefuse Authors
# SPDX-License-Identifier: Apache-2.0
"""As much of MCAP as it takes to damage a recording on purpose: its records, and a file made of chosen ones."""

import struct
from typing import NamedTuple

MAGIC = b"\x89MCAP0\r\n"
HEADER, FOOTER, CHANNEL, CHUNK, CHUNK_INDEX, METADATA, DATA_END = 1, 2, 4, 6, 8, 0x0C, 0x0F


class Record(NamedTuple):
    kind: int
    begin: int  # of its content in the file
    content: bytes


def records(data):
    """The records of a sound file; those inside of chunks stay inside."""
    at = len(MAGIC)
    while at < len(data) - len(MAGIC):
        kind, length = struct.unpack_from("<BQ", data, at)
        yield Record(kind, at + 9, data[at + 9:at + 9 + length])
        at += 9 + length


def chunks(data):
    return [record.content for record in records(data) if record.kind == CHUNK]


def topics(data):
    """The topics on which a sound recording has channels."""
    found = (r.content for r in records(data) if r.kind == CHANNEL)
    return {content[8:8 + struct.unpack_from("<I", content, 4)[0]].decode() for content in found}


def input_chunks(data):
    """(begin, end) in the file of every chunk with messages of /in."""
    inputs = {struct.unpack_from("<H", r.content)[0] for r in records(data)
              if r.kind == CHANNEL and r.content[8:].startswith(b"/in/")}
    found = []
    for index in (r.content for r in records(data) if r.kind == CHUNK_INDEX):
        begin, length, map_bytes = struct.unpack_from("<QQI", index, 16)
        entries = struct.iter_unpack("<HQ", index[36:36 + map_bytes])
        if inputs & {channel for channel, _ in entries}:
            found.append((begin, begin + length))
    return found


def text(value):
    return struct.pack("<I", len(value)) + value.encode()


def record(kind, content):
    return struct.pack("<BQ", kind, len(content)) + content


def recording_without_channels(metadata):
    """A sound file that holds nothing but the metadata record of Lanefuse."""
    entries = b"".join(text(key) + text(value) for key, value in metadata.items())
    body = text("lanefuse") + struct.pack("<I", len(entries)) + entries
    return (MAGIC + record(HEADER, text("") + text("test")) + record(METADATA, body) +
            record(DATA_END, bytes(4)) + record(FOOTER, bytes(20)) + MAGIC)
