"""Who gets in, and where the token is to be seen: sessions of browsers, token files, address files, wrong tokens."""
import json
import os
import re
import resource
import signal
import socket
import ssl
import stat
import subprocess
import tempfile
import time
import unittest

import suite
from server import LAUNCHING, PROGRAM, SCENE, SLOW, Server, run, within
from suite import waits
from viewer import Viewer, Wire, message, upgrade

TOKEN, OTHER = "a.Token_of-18.signs", "another.Token-of_18"


def get(server, path, *fields, method="GET", upgraded=False):
    """Status, head and body of the answer."""
    wire = server.wire()
    host = f"{server.host}:{server.port}"
    extra = "".join(field + "\r\n" for field in fields)
    wire.send(upgrade(path, host, extra) if upgraded
              else f"{method} {path} HTTP/1.1\r\nHost: {host}\r\nConnection: close\r\n{extra}\r\n".encode())
    head = wire.until(b"\r\n\r\n").decode()
    body = b"" if upgraded else wire.rest()
    wire.close()
    return int(head.split()[1]), head, body


def field(head, name):
    found = re.search(rf"(?im)^{name}: (.*)\r$", head)
    return found and found[1]


class Sessions(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.server = Server()

    @classmethod
    def tearDownClass(cls):
        cls.server.__exit__()

    def opened(self):
        """The cookie of a browser that has opened the address."""
        status, head, body = get(self.server, "/?token=" + self.server.token)
        self.assertEqual((status, field(head, "Location"), body), (303, "./", b""))
        return field(head, "Set-Cookie")

    def test_the_token_is_exchanged_for_a_random_session(self):
        cookies = [self.opened() for _ in range(2)]
        for cookie in cookies:
            self.assertRegex(cookie, rf"^aeolic-{self.server.port}=[A-Za-z0-9_-]{{22,}}; Path=/; HttpOnly; SameSite=Strict$")
            self.assertNotIn(self.server.token, cookie)
        self.assertNotEqual(*cookies)

    def test_a_session_gets_page_status_and_stream(self):
        cookie = "Cookie: " + self.opened().split(";")[0]
        for path in ("/", "/main.js", "/status"):
            status, head, _ = get(self.server, path, cookie)
            self.assertEqual((status, field(head, "Cache-Control"), field(head, "Set-Cookie")), (200, "no-store", None), path)
        bare = f"http://{self.server.host}:{self.server.port}"
        with Viewer(bare + "/", fields=f"{cookie}\r\nOrigin: {bare}\r\n", timeout=60 * SLOW) as viewer:
            viewer.see()

    def test_other_pages_cannot_use_it(self):
        cookie = "Cookie: " + self.opened().split(";")[0]
        for origin in ("http://evil.example", f"http://{self.server.host}:{self.server.port + 1}", "null"):
            self.assertEqual(get(self.server, "/stream", cookie, "Origin: " + origin, upgraded=True)[0], 403, origin)

    def test_the_token_is_no_cookie_and_a_session_no_token(self):
        name, session = self.opened().split(";")[0].split("=")
        self.assertEqual(get(self.server, "/status", f"Cookie: {name}={self.server.token}")[0], 401)
        self.assertEqual(get(self.server, "/status?token=" + session)[0], 401)
        self.assertEqual(get(self.server, "/status", "Authorization: Bearer " + session)[0], 401)

    def test_programs_need_no_session(self):
        token = self.server.token
        for fields, path in (((), "?token=" + token), (("Authorization: Bearer " + token,), "")):
            status, head, body = get(self.server, "/status" + path, *fields)
            self.assertEqual((status, field(head, "Set-Cookie")), (200, None))
            self.assertIn(b'"state"', body)
            self.assertEqual(get(self.server, "/stream" + path, *fields, upgraded=True)[0], 101)

    def test_the_page_may_connect_to_its_own_host_alone(self):
        cookie = "Cookie: " + self.opened().split(";")[0]
        _, head, _ = get(self.server, "/", cookie)
        self.assertIn(f"connect-src 'self' ws://{self.server.host}:{self.server.port};", field(head, "Content-Security-Policy"))

    def test_sessions_without_end_leave_the_newest(self):
        first = self.opened().split(";")[0]
        for _ in range(300):
            last = self.opened().split(";")[0]
        self.assertEqual(get(self.server, "/status", "Cookie: " + first)[0], 401)
        self.assertEqual(get(self.server, "/status", "Cookie: " + last)[0], 200)


class WrongTokens(unittest.TestCase):
    def seconds(self, ask):
        start = time.monotonic()
        ask()
        return time.monotonic() - start

    @waits(6)
    def test_make_answers_slow_but_only_those(self):
        with Server() as server:
            cookie = "Cookie: " + field(get(server, "/?token=" + server.token)[1], "Set-Cookie").split(";")[0]
            with server.viewer() as viewer:
                viewer.see()
                for _ in range(12):
                    self.assertEqual(get(server, "/status?token=wrong")[0], 401)
                slow = self.seconds(lambda: get(server, "/status?token=wrong"))
                self.assertGreater(slow, 0.9)
                self.assertLess(slow, 4 * SLOW, "it has a bound")
                right = self.seconds(lambda: self.assertEqual(get(server, "/status?token=" + server.token)[0], 200))
                self.assertGreater(right, 0.9, "or silence would tell who guesses that the guess was wrong")
                self.assertLess(right, 4 * SLOW, "the holder is not locked out")
                # Many who wait hold nobody up.
                waiting = [server.wire() for _ in range(20)]
                for wire in waiting:
                    wire.send(b"GET /status?token=wrong HTTP/1.1\r\nHost: x\r\n\r\n")
                self.assertLess(self.seconds(lambda: self.assertEqual(get(server, "/status", cookie)[0], 200)), 0.8 * SLOW)
                viewer.see()
                for wire in waiting:
                    wire.close()


class GivenTokens(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory(prefix="aeolic_access_")
        self.addCleanup(self.folder.cleanup)

    def file(self, content=TOKEN + "\n", mode=0o600):
        path = os.path.join(self.folder.name, "token")
        with open(path, "w") as file:
            file.write(content)
        os.chmod(path, mode)
        return path

    def test_from_a_file_or_the_environment_and_which_counts(self):
        path = self.file()
        for options, environment, token in ((("--token-file", path), {}, TOKEN), ((), {"AEOLIC_TOKEN": OTHER}, OTHER),
                                            (("--token-file", path), {"AEOLIC_TOKEN": OTHER}, TOKEN),
                                            (("--token", OTHER, "--token-file", path), {"AEOLIC_TOKEN": OTHER + "x"}, OTHER)):
            with Server(*options, environment=environment) as server:
                self.assertEqual(server.token, token)
                server.ranks(1)

    def test_are_in_no_command_line_and_no_environment(self):
        path = self.file()
        for options, environment in ((("--token-file", path), {}), ((), {"AEOLIC_TOKEN": TOKEN})):
            with Server(*options, environment=environment) as server:
                for pid in [server.pid, *server.ranks(1)]:
                    for what in ("cmdline", "environ"):
                        with open(f"/proc/{pid}/{what}", "rb") as file:
                            self.assertNotIn(TOKEN.encode(), file.read(), f"{what} of {pid}")

    def test_bad_ones_are_refused_in_one_line_that_does_not_tell_them(self):
        for options, environment in ((("--token-file", self.file(mode=0o644)), {}), (("--token-file", "/no/such/file"), {}),
                                     ((), {"AEOLIC_TOKEN": "short.token"}), ((), {"AEOLIC_TOKEN": "none"}),
                                     (("--token", "short.token"), {})):
            done = subprocess.run([PROGRAM, "serve", *SCENE, "--port", "0", *options], env={**os.environ, **environment},
                                  capture_output=True, text=True, timeout=60 * SLOW, stdin=subprocess.DEVNULL, check=False)
            self.assertEqual((done.returncode, done.stdout, done.stderr.count("\n")), (2, "", 1), done.stderr)
            self.assertNotIn("short.token", done.stderr)
            self.assertNotIn(TOKEN, done.stderr)

    def test_grab_takes_them_the_same_ways(self):
        path = self.file()
        picture = os.path.join(self.folder.name, "a.png")
        with Server("--token-file", path) as server:
            bare = f"http://{server.host}:{server.port}/"
            for address, options, environment, code in ((bare, ["--token-file", path], {}, 0), (bare, [], {"AEOLIC_TOKEN": TOKEN}, 0),
                                                        (server.address, [], {"AEOLIC_TOKEN": OTHER}, 0),
                                                        (bare, ["--token-file", path], {"AEOLIC_TOKEN": OTHER}, 0),
                                                        (bare, [], {"AEOLIC_TOKEN": OTHER}, 1), (bare, [], {}, 1)):
                done = subprocess.run([PROGRAM, "grab", address, "--size", "40x30", "-o", picture, *options],
                                      env={**os.environ, **environment}, capture_output=True, text=True, timeout=60 * SLOW, check=False)
                self.assertEqual(done.returncode, code, done.stderr)
                self.assertEqual(done.stderr.count("\n"), code)


class Addresses(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory(prefix="aeolic_access_")
        self.addCleanup(self.folder.cleanup)
        self.path = os.path.join(self.folder.name, "address")

    def test_an_address_file_is_the_owners_alone_and_goes_with_the_server(self):
        with open(os.path.join(self.folder.name, "victim"), "w") as victim:
            victim.write("precious")
        os.symlink(victim.name, self.path)
        with Server("--address-file", self.path) as server:
            status = os.lstat(self.path)
            self.assertEqual((stat.S_ISREG(status.st_mode), stat.S_IMODE(status.st_mode)), (True, 0o600))
            with open(self.path) as file:
                self.assertEqual(file.read(), server.address + "\n")
            with open(victim.name) as file:
                self.assertEqual(file.read(), "precious")
        self.assertEqual(os.listdir(self.folder.name), ["victim"])

    def test_one_that_cannot_be_written_is_refused(self):
        done = run("serve", *SCENE, "--port", "0", "--address-file", "/no/such/folder/address")
        self.assertEqual((done.returncode, done.stdout, done.stderr.count("\n")), (2, "", 1), done.stderr)
        self.assertIn("--address-file", done.stderr)

    def logged(self, *options, environment=None):
        """What a server writes to a log, and where it says the address is."""
        log = os.path.join(self.folder.name, "log")
        with open(log, "w") as out:
            process = subprocess.Popen([PROGRAM, "serve", *SCENE, "--port", "0", *options], stdout=out, stderr=subprocess.DEVNULL,
                                       stdin=subprocess.DEVNULL,
                                       env={**os.environ, **LAUNCHING, "HOME": self.folder.name, **(environment or {})})
        try:
            def text():
                with open(log) as file:
                    lines = file.read()
                return lines if lines.count("\n") == 2 else None
            address, place = within(60, text, "two lines in the log").splitlines()
            self.assertNotIn("token=", address + place)
            path = place.rpartition(" ")[2]
            self.assertEqual(stat.S_IMODE(os.stat(path).st_mode), 0o600)
            with open(path) as file:
                whole = file.read().strip()
            self.assertTrue(whole.startswith(address + "?token="), whole)
            picture = os.path.join(self.folder.name, "a.png")
            self.assertEqual(run("grab", whole, "--size", "40x30", "-o", picture).returncode, 0)
        finally:
            process.send_signal(signal.SIGTERM)
            self.assertEqual(process.wait(20 * SLOW), 0)
        self.assertFalse(os.path.exists(path))
        with open(log) as file:
            self.assertNotIn(whole.rpartition("=")[2], file.read())
        return path

    def test_a_log_does_not_hold_the_token(self):
        self.assertEqual(self.logged("--address-file", self.path), self.path)
        self.assertTrue(self.logged().startswith(os.path.join(self.folder.name, ".aeolic/127.0.0.1-")))
        self.logged(environment={"AEOLIC_TOKEN": TOKEN})


def free_port():
    with socket.create_server(("127.0.0.1", 0)) as taken:
        return taken.getsockname()[1]


def has_ipv6():
    try:
        with socket.create_server(("::1", 0), family=socket.AF_INET6):
            return True
    except OSError:
        return False


class JobLinks(unittest.TestCase):
    """The port that ranks connect to. `env` is the smallest launcher: with it, ranks may be on other hosts."""

    def test_between_hosts_they_are_encrypted(self):
        port = free_port()
        with Server("--launcher", "env", "--job-port", str(port)) as server, server.viewer() as viewer:
            viewer.see()
            wire = Wire(server.host, port, 20 * SLOW)
            wire.send(message(0x89, {"nonce": "n" * 32}))
            self.assertNotIn(b"nonce", wire.rest(), "an answer in plain text")
            wire.close()
            context = ssl.SSLContext(ssl.PROTOCOL_TLS_CLIENT)
            context.check_hostname, context.verify_mode = False, ssl.CERT_NONE
            wire = Wire(server.host, port, 20 * SLOW, context)
            self.assertEqual(wire.socket.version(), "TLSv1.3")
            first = wire.socket.getpeercert(binary_form=True)
            wire.close()
            os.kill(server.ranks(1)[0], signal.SIGKILL)
            viewer.wait_state("restarting", 20 * SLOW)
            viewer.wait_state("ready", 60 * SLOW)
            wire = Wire(server.host, port, 20 * SLOW, context)
            self.assertNotEqual(wire.socket.getpeercert(binary_form=True), first, "a new key for each start")
            wire.close()
            viewer.see()
            self.assertEqual(server.status()["restarts"], 1)

    def test_strangers_who_wait_do_not_keep_ranks_out(self):
        port = free_port()
        with Server("--job-port", str(port)) as server, server.viewer() as viewer:
            viewer.see()
            crowd = [socket.create_connection((server.host, port), 20 * SLOW) for _ in range(300)]
            os.kill(server.ranks(1)[0], signal.SIGKILL)
            viewer.wait_state("restarting", 20 * SLOW)
            crowd += [socket.create_connection((server.host, port), 20 * SLOW) for _ in range(100)]
            viewer.wait_state("ready", 60 * SLOW)
            viewer.see()
            self.assertEqual(server.status()["restarts"], 1)
            for one in crowd:
                one.close()

    @unittest.skipUnless(has_ipv6(), "no IPv6 here")
    def test_ipv6(self):
        with Server("--host", "::1", "--job-host", "::1") as server:
            self.assertRegex(server.address, r"^http://\[::1\]:\d+/\?token=")
            with server.viewer() as viewer:
                viewer.see()
            picture = os.path.join(server.folder, "a.png")
            done = run("grab", server.address, "--size", "40x30", "-o", picture)
            self.assertEqual((done.returncode, done.stderr), (0, ""))

    def test_direct_ports(self):
        port = free_port()
        with Server("--direct", "--direct-ports", f"{port}-{port}") as server, server.viewer(direct=True) as viewer:
            viewer.until(lambda _: viewer.offer)
            self.assertEqual([one["port"] for one in viewer.offer], [port])


class Refusing(unittest.TestCase):
    def refused(self, *options, words=(), scene=SCENE, files=None):
        done = subprocess.run([PROGRAM, "serve", *scene, "--port", "0", *options], capture_output=True, text=True, timeout=120 * SLOW,
                              stdin=subprocess.DEVNULL, check=False, env={**os.environ, **LAUNCHING},
                              preexec_fn=files and (lambda: resource.setrlimit(resource.RLIMIT_NOFILE, (files, files))))
        self.assertEqual((done.returncode, done.stderr.count("\n")), (2, 1), done.stderr[:2000])
        for word in words:
            self.assertIn(word, done.stderr)


class Refused(Refusing):
    def test_more_ranks_than_files(self):
        self.refused("--ranks", "500", words=("--ranks: 500", "256 files", "at most 160 ranks"), files=256)

    def test_places_that_are_not_to_be_had(self):
        self.refused("--job-host", "192.0.2.1", words=("--job-host",))
        with socket.create_server(("127.0.0.1", 0)) as taken:
            self.refused("--job-port", str(taken.getsockname()[1]), words=("--job-port", str(taken.getsockname()[1])))
        for wrong in ("5000", "5000-", "-5000", "6000-5000", "0-10", "5000-70000", "a-b", "5000-5001-5002", "5000 -5001"):
            self.refused("--direct", "--direct-ports=" + wrong, words=("--direct-ports",))
        self.refused("--direct", "--ranks", "3", "--direct-ports", "5000-5001", words=("--direct-ports", "3 ranks"))

    def test_values_that_are_empty(self):
        # As a variable of the shell that is not set gives them.
        self.refused("--host", "", words=("--host: found ''",))
        for option in ("--job-port", "--ranks", "--max-viewers"):
            self.refused(option, "", words=(option + ": found ''; expected a number",))

    def test_a_scene_that_no_message_holds(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "scene.json")
            with open(path, "w") as file:
                json.dump({"version": 1, "surface": {"spec": "teapot:2000"}, "field": {"spec": "rotation:16,16,16"},
                           "shading": {"colorBy": "x" * (200 << 10)}}, file)
            self.refused(path, scene=[], words=("KiB of names",))


TRIANGLE = """<VTKFile type="PolyData" version="0.1" byte_order="LittleEndian"><PolyData><Piece NumberOfPoints="3" NumberOfPolys="1">
<PointData Vectors="v"><DataArray type="Float32" Name="v" NumberOfComponents="3" format="ascii">1 0 0 1 0 0 1 0 0</DataArray></PointData>
<Points><DataArray type="Float32" NumberOfComponents="3" format="ascii">0 0 0 1 0 0 0 1 0</DataArray></Points>
<Polys><DataArray type="Int32" Name="connectivity" format="ascii">0 1 2</DataArray>
<DataArray type="Int32" Name="offsets" format="ascii">3</DataArray></Polys></Piece></PolyData></VTKFile>"""


class ManyTimes(Refusing):
    """A scene is told to viewers with all its time steps."""

    def series(self, folder, count):
        with open(os.path.join(folder, "one.vtp"), "w") as file:
            file.write(TRIANGLE)
        path = os.path.join(folder, "many.pvd")
        with open(path, "w") as file:
            file.write('<VTKFile type="Collection" version="0.1"><Collection>')
            file.writelines(f'<DataSet timestep="{i + 1 / 3!r}" file="one.vtp"/>\n' for i in range(count))
            file.write("</Collection></VTKFile>")
        return path

    def test_over_a_mebibyte(self):
        with tempfile.TemporaryDirectory() as folder:
            path = self.series(folder, 80000)
            with Server(scene=["--surface", path, "--vectors", "v"]) as server, server.viewer(timeout=120 * SLOW) as viewer:
                viewer.loaded()
                self.assertEqual(len(viewer.scene["choices"]["times"]), 80000)
                viewer.see()
                self.assertEqual(server.status()["restarts"], 0)

    def test_more_than_viewers_can_be_told(self):
        with tempfile.TemporaryDirectory() as folder:
            self.refused(scene=["--surface", self.series(folder, 300000), "--vectors", "v"], words=("KiB",))


if __name__ == "__main__":
    suite.main()
