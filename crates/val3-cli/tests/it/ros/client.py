"""A client of the ROS-Industrial simple message format: little-endian messages of a length, type, kind and reply code.

Usage: client.py feedback PORT MESSAGES    prints so many messages, a line each
       client.py motion PORT J1 J2 ...     sends a trajectory point and prints the answer
"""

import socket
import struct
import sys
import time

PATIENCE = 20
HEADER = struct.Struct("<4i")
BODIES = {
    10: ("joints", struct.Struct("<i10f")),
    11: ("point", struct.Struct("<i")),
    13: ("status", struct.Struct("<7i")),
}
JOINTS = 10
TRAJECTORY_POINT = 11
REQUEST = 2


def connect(port):
    """The server opens its socket when its program first uses it."""
    end = time.monotonic() + PATIENCE
    while True:
        try:
            return socket.create_connection(("127.0.0.1", port), PATIENCE)
        except ConnectionRefusedError:
            if time.monotonic() > end:
                raise
            time.sleep(0.02)


def message(stream):
    """The next message: its name, kind, reply code and values."""
    length, number, kind, code = HEADER.unpack(stream.read(HEADER.size))
    name, body = BODIES[number]
    if length != HEADER.size - 4 + body.size:
        raise ValueError(f"{name} of {length} bytes")
    return name, kind, code, body.unpack(stream.read(body.size))


def shown(found):
    name, kind, code, values = found
    return " ".join([name, f"kind={kind}", f"code={code}", *(f"{value:g}" for value in values)])


def feedback(stream, port, messages):
    port.sendall(b"\n")
    for _ in range(int(messages)):
        print(shown(message(stream)))


def motion(stream, port, *goal):
    joints = [float(axis) for axis in goal] + [0.0] * (JOINTS - len(goal))
    body = struct.pack("<12f", *joints, 0.1, 5.0)
    sequence = struct.pack("<i", 7)
    length = HEADER.size - 4 + len(sequence) + len(body)
    port.sendall(HEADER.pack(length, TRAJECTORY_POINT, REQUEST, 0) + sequence + body)
    print(shown(message(stream)))


if __name__ == "__main__":
    command, number, *rest = sys.argv[1:]
    with connect(int(number)) as server:
        {"feedback": feedback, "motion": motion}[command](server.makefile("rb"), server, *rest)
