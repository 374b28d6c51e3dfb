"""How a server starts, and how it refuses to: one line, exit code 2."""
import json
import os
import re
import socket
import unittest

import suite
from server import SCENE, Server, run, within


class Refusals(unittest.TestCase):
    def refused(self, text, *options, scene=SCENE):
        result = run("serve", *scene, *options, timeout=60)
        self.assertEqual(result.returncode, 2, result.stderr)
        lines = [line for line in result.stderr.splitlines() if line.startswith("aeolic: ")]
        self.assertEqual(len(lines), 1, result.stderr)
        self.assertEqual(result.stderr.count("\n"), 1, result.stderr)
        self.assertIn(text, lines[0])
        return result

    def test_a_port_in_use(self):
        with socket.create_server(("127.0.0.1", 0)) as taken:
            port = str(taken.getsockname()[1])
            result = self.refused(port, "--port", port)
            self.assertEqual(result.stdout, "", "an address that is not this server's")

    def test_hosts_that_are_not_this_one(self):
        self.refused("--port", "--host", "192.0.2.1", "--port", "0")
        self.refused("--host", "--host", "no.such.host.invalid", "--port", "0")

    def test_a_bad_scene_file(self):
        with Server() as server:
            path = os.path.join(server.folder, "scene.json")
            for content, text in (('{"version":1,"lic":{"steps":-3}}', "lic.steps"), ("{", path), ("", path)):
                with open(path, "w") as file:
                    file.write(content)
                self.refused(text, path, "--port", "0", scene=[])
            self.refused("nothing.json", os.path.join(server.folder, "nothing.json"), scene=[])

    def test_a_surface_that_cannot_be_loaded(self):
        """The job finds it out after the address was printed."""
        self.refused("/no/such/car.vtp", "--surface", "/no/such/car.vtp", "--port", "0", scene=[])
        self.refused("nothing", *SCENE, "--color-by", "nothing", "--port", "0", scene=[])

    def test_names_that_are_no_text(self):
        """Scenes travel as JSON, which is UTF-8. The server says so and ends, instead of waiting for nothing."""
        self.refused("UTF-8", "--surface", b"caf\xe9.vtp", "--port", "0", scene=[])
        self.refused("UTF-8", "--surface", "teapot", "--field", b"\xff\xfe.vti", "--port", "0", scene=[])

    def test_no_token_where_others_can_connect(self):
        self.refused("--token", "--token", "none", "--host", "0.0.0.0", "--port", "0")
        self.refused("--token", "--token", "none", "--host", "::", "--port", "0")
        self.refused("--token", "--token", "a b", "--port", "0")

    def test_tokens_that_are_easy_to_guess(self):
        result = self.refused("--token", "--token", "fifteen.letters", "--port", "0")
        self.assertNotIn("fifteen", result.stderr)

    def test_wrong_numbers(self):
        for option, value in (("--port", "65536"), ("--port", "-1"), ("--ranks", "0"), ("--max-viewers", "0"),
                              ("--max-size", "1"), ("--codec", "morse")):
            self.refused(option, option, value)

    def test_launchers_that_are_none(self):
        self.refused("--launcher", "--launcher", "mpirun 'x", "--port", "0")
        self.refused("--launcher", "--launcher", " ", "--port", "0")
        self.refused("/no/such/mpirun", "--launcher", "/no/such/mpirun -n {ranks}", "--port", "0")

    def test_half_a_certificate(self):
        self.refused("--tls-key", "--tls-cert", "x.pem")
        self.refused("--tls-cert", "--tls-key", "x.pem")
        self.refused("/no/such.pem", "--tls-cert", "/no/such.pem", "--tls-key", "/no/such.pem")


class Starts(unittest.TestCase):
    def test_the_address_is_one_line_with_a_token(self):
        with Server() as server:
            self.assertRegex(server.address, r"^http://127\.0\.0\.1:\d+/\?token=[A-Za-z0-9_-]{32}$")
            with Server() as other:
                self.assertNotEqual(server.token, other.token)

    def test_the_token_is_on_no_command_line_and_in_no_environment(self):
        with Server() as server:
            for pid in [server.pid, *server.ranks(1)]:
                for what in ("cmdline", "environ"):
                    with open(f"/proc/{pid}/{what}", "rb") as file:
                        self.assertNotIn(server.token.encode(), file.read())

    def test_loopback_alone(self):
        with Server() as server:
            port = format(server.port, "04X")
            with open("/proc/net/tcp") as table:
                listening = [line.split()[1] for line in table if re.search(rf":{port} 0+:0000 0A", line)]
            self.assertEqual(listening, [f"0100007F:{port}"])

    def test_no_token_on_loopback(self):
        with Server("--token", "none") as server:
            self.assertRegex(server.address, r"^http://127\.0\.0\.1:\d+/$")
            self.assertIn(b"<!doctype html>", server.get("/"))
            with server.viewer() as viewer:
                viewer.see()

    def test_an_own_token(self):
        with Server("--token", "open.Sesame-1234") as server:
            self.assertEqual(server.token, "open.Sesame-1234")
            with server.viewer() as viewer:
                viewer.see()

    def test_without_a_token_other_names_for_this_host_are_refused(self):
        """A foreign page whose name was made to point here must not pass for the server's own (DNS rebinding)."""
        with Server("--token", "none") as server:
            for host, status in ((f"127.0.0.1:{server.port}", b"200"), (f"localhost:{server.port}", b"200"),
                                 (f"evil.example:{server.port}", b"40"), ("evil.example", b"40")):
                wire = server.wire()
                wire.send(f"GET /status HTTP/1.1\r\nHost: {host}\r\nConnection: close\r\n\r\n".encode())
                self.assertIn(status, wire.rest().split(b"\r\n")[0], host)

    def test_status(self):
        with Server() as server:
            pids = server.ranks(1)
            within(60, lambda: server.status()["state"] == "ready", "loading")
            with server.viewer() as viewer:
                viewer.see()
                status = server.status()
            self.assertEqual({**status, "frames": 1}, {"state": "ready", "ranks": 1, "viewers": 1, "frames": 1, "restarts": 0,
                                                       "pids": pids})

    def test_the_page_is_there_and_says_nothing_to_strangers(self):
        with Server() as server:
            for path in ("/", "/index.html"):
                self.assertIn(b"<!doctype html>", server.get(path))
            wire = server.wire()
            wire.send(f"GET / HTTP/1.1\r\nHost: x\r\nAuthorization: Bearer {server.token}\r\nConnection: close\r\n\r\n".encode())
            head = wire.rest().split(b"\r\n\r\n")[0].decode().lower()
            self.assertNotIn("\r\nserver:", head)
            self.assertIn("content-security-policy: default-src 'none'", head)
            self.assertIn("x-content-type-options: nosniff", head)

    def raw(self, server):
        wire = server.wire()
        wire.send(f"GET /?token={server.token} HTTP/1.1\r\nHost: x\r\nConnection: close\r\n\r\n".encode())
        return wire.rest().split(b"\r\n\r\n")[0].decode()

    def test_two_servers_on_one_host_keep_their_cookies_apart(self):
        with Server() as one, Server() as two:
            names = [re.search(r"[Ss]et-[Cc]ookie: ([^=]*)", self.raw(server)).group(1) for server in (one, two)]
            self.assertNotEqual(*names)

    def test_a_job_may_not_join_without_the_secret(self):
        """Everybody on this host can connect to the port for ranks."""
        with Server() as server, server.viewer() as viewer:
            viewer.see()
            inodes = set()
            for name in os.listdir(f"/proc/{server.pid}/fd"):
                target = os.readlink(f"/proc/{server.pid}/fd/{name}")
                if target.startswith("socket:["):
                    inodes.add(target[8:-1])
            with open("/proc/net/tcp") as table:
                rows = [line.split() for line in table][1:]
            ports = [int(row[1].split(":")[1], 16) for row in rows if row[3] == "0A" and row[9] in inodes]
            ports.remove(server.port)
            self.assertEqual(len(ports), 1)
            from viewer import Wire, message
            join = {"secret": "", "rank": 0, "ranks": 1, "host": "x", "pid": 1, "direct": None}
            for data in (message(0x81, join), message(0x81, {**join, "secret": server.token}), message(0x81, {**join, "secret": 7}),
                         message(0x81, {**join, "rank": "0"}), message(0x81, b"{"), message(0x81, b"[]"), message(0x43, {}),
                         message(0x45, b"x" * 100), b"\0" * 8, b"GET / HTTP/1.1\r\n\r\n", message(0x81, b"x" * 5000), b"\xae"):
                wire = Wire(server.host, ports[0], 20)
                wire.send(data)
                if len(data) >= 8:
                    self.assertEqual(wire.rest(), b"")
                wire.close()
            for proof in ({}, {"proof": ""}, {"proof": "0" * 64}, {"proof": 7}):  # Who knocks is asked for a proof.
                wire = Wire(server.host, ports[0], 20)
                wire.send(message(0x89, {"nonce": "n" * 32}))
                head = wire.take(8)
                self.assertEqual(head[2], 0x8A)
                self.assertNotIn(b"secret", wire.take(int.from_bytes(head[4:], "little")))
                wire.send(message(0x81, {**join, **proof}))
                self.assertEqual(wire.rest(), b"")
                wire.close()
            viewer.see()
            self.assertEqual(server.status()["restarts"], 0)


if __name__ == "__main__":
    suite.main()
