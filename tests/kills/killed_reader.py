#!/usr/bin/env python3
"""Stands between a program and its reader (AEOLIC_READER), and is killed at the place that AEOLIC_TEST_KILL names.

"start": before anything. "hang": not killed, but it waits for ever once a file is closed. "read:2": when the second packet of this kind has been passed on, whoever sends it. The real
reader is AEOLIC_TEST_READER. Where it is killed a line with the time is added to the file AEOLIC_TEST_KILLED.
"""
import os
import select
import signal
import socket
import time

KINDS = ["", "open", "arrays", "read", "look", "close", "progress", "memory", "answer", "refusal"]  # PacketKind
MOST_BYTES, MOST_FILES = 1 << 16, 253


def note():
    with open(os.environ["AEOLIC_TEST_KILLED"], "a") as file:
        file.write(f"{time.time()}\n")


def die():
    note()
    os.kill(os.getpid(), signal.SIGKILL)


def main():
    place, _, left = os.environ["AEOLIC_TEST_KILL"].partition(":")
    left = int(left or 1)
    if place == "start":
        die()
    caller = socket.socket(fileno=3)
    reader, theirs = socket.socketpair(socket.AF_UNIX, socket.SOCK_SEQPACKET)
    real = os.environ["AEOLIC_TEST_READER"]
    os.posix_spawn(real, [real], os.environ, file_actions=[(os.POSIX_SPAWN_DUP2, theirs.fileno(), 3)])
    theirs.close()
    other = {caller: reader, reader: caller}
    while True:
        for side in select.select(list(other), [], [])[0]:
            data, files, _, _ = socket.recv_fds(side, MOST_BYTES, MOST_FILES)
            if not data:
                return
            if place == "hang" and KINDS[data[0]] == "close":
                note()
                while True:
                    signal.pause()
            socket.send_fds(other[side], [data], files)
            for file in files:
                os.close(file)
            if KINDS[data[0]] == place:
                left -= 1
                if left == 0:
                    die()


main()
