"""A client of the ROS-Industrial simple message format: little-endian messages of a length, type, kind and reply code.

Usage: client.py feedback PORT MESSAGES    prints so many messages, a line each
       client.py motion PORT FEEDBACK POINT ...
                                           sends the points of a trajectory, J1,J2,... each, then its end, and prints
                                           the answers and the joints at which the arm comes to rest
"""

import socket
import struct
import sys
import time

TIMEOUT = 120
HEADER = struct.Struct("<4i")
BODIES = {
    10: ("joints", struct.Struct("<i10f")),
    11: ("point", struct.Struct("<i")),
    13: ("status", struct.Struct("<7i")),
}
JOINTS = 10
TRAJECTORY_POINT = 11
REQUEST = 2
END = -3


def connect(port):
    """The server opens its socket when its program first uses it."""
    end = time.monotonic() + TIMEOUT
    while True:
        try:
            return socket.create_connection(("127.0.0.1", port), TIMEOUT)
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


def send(port, sequence, joints):
    joints = joints + [0.0] * (JOINTS - len(joints))
    body = struct.pack("<i12f", sequence, *joints, 0.1, 5.0)
    port.sendall(HEADER.pack(HEADER.size - 4 + len(body), TRAJECTORY_POINT, REQUEST, 0) + body)


def motion(stream, port, feedback_port, *points):
    for sequence, point in enumerate(points):
        send(port, sequence, [float(axis) for axis in point.split(",")])
        print(shown(message(stream)))
    send(port, END, [])
    print(shown(message(stream)))
    with connect(int(feedback_port)) as states:
        print(at_rest(states.makefile("rb"), states))


def at_rest(stream, port):
    """The joints once the arm has moved, and nothing is left to do."""
    port.sendall(b"\n")
    joints, seen = None, 0
    end = time.monotonic() + TIMEOUT
    while time.monotonic() < end:
        name, _, _, values = message(stream)
        if name == "joints":
            seen += values[1:] != joints
            joints = values[1:]
        elif values[-1] == 1:
            return " ".join(["moved" if seen > 10 else "stood", *(f"{axis:.3f}" for axis in joints[:6])])
    raise TimeoutError("the arm does not come to rest")


if __name__ == "__main__":
    command, number, *rest = sys.argv[1:]
    with connect(int(number)) as server:
        {"feedback": feedback, "motion": motion}[command](server.makefile("rb"), server, *rest)
