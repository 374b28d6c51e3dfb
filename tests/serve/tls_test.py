"""https with the user's certificate."""
import os
import socket
import ssl
import subprocess
import tempfile
import time
import unittest
import warnings

import suite
from server import SCENE, SLOW, Server, has_openssl, run
from suite import waits
from viewer import Closed, Viewer, Wire


@unittest.skipUnless(has_openssl, "no openssl program to make a certificate with")
class Tls(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory(prefix="aeolic_tls_")
        cls.certificate, cls.key = (os.path.join(cls.folder.name, name) for name in ("cert.pem", "key.pem"))
        subprocess.run(["openssl", "req", "-x509", "-newkey", "ec", "-pkeyopt", "ec_paramgen_curve:prime256v1", "-nodes",
                        "-days", "2", "-subj", "/CN=localhost", "-addext", "subjectAltName=IP:127.0.0.1,DNS:localhost",
                        "-keyout", cls.key, "-out", cls.certificate], check=True, capture_output=True)
        cls.server = Server("--tls-cert", cls.certificate, "--tls-key", cls.key)

    @classmethod
    def tearDownClass(cls):
        cls.server.__exit__()
        cls.folder.cleanup()

    def context(self, trusted=True):
        context = ssl.create_default_context(cafile=self.certificate if trusted else None)
        return context

    def test_the_address_says_so(self):
        self.assertRegex(self.server.address, r"^https://127\.0\.0\.1:\d+/\?token=")

    def test_a_viewer_that_trusts_the_certificate(self):
        with Viewer(self.server.address, context=self.context(), timeout=60 * SLOW) as viewer:
            viewer.see()
            self.assertIn(viewer.wire.socket.version(), ("TLSv1.2", "TLSv1.3"))

    def test_grab(self):
        rendered, grabbed = os.path.join(self.folder.name, "r.png"), os.path.join(self.folder.name, "g.png")
        self.assertEqual(run("render", *SCENE, "--size", "70x50", "-o", rendered).returncode, 0)
        refused = run("grab", self.server.address, "--size", "70x50", "-o", grabbed)
        self.assertEqual(refused.returncode, 1, "a certificate that nobody signed")
        self.assertEqual(len(refused.stderr.splitlines()), 1)
        self.assertIn("certificate", refused.stderr)
        self.assertFalse(os.path.exists(grabbed))
        result = run("grab", self.server.address, "--insecure", "--size", "70x50", "-o", grabbed)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        with open(rendered, "rb") as a, open(grabbed, "rb") as b:
            self.assertEqual(a.read(), b.read())

    def test_wrong_tokens(self):
        result = run("grab", self.server.address + "x", "--insecure", "-o", os.path.join(self.folder.name, "x.png"))
        self.assertEqual(result.returncode, 1)
        self.assertIn("token", result.stderr)

    def test_plain_http_on_the_tls_port_ends(self):
        wire = self.server.wire()
        start = time.monotonic()
        wire.send(b"GET / HTTP/1.1\r\nHost: x\r\n\r\n")
        self.assertNotIn(b"200", wire.rest())
        self.assertLess(time.monotonic() - start, 5 * SLOW)

    @waits(10)
    def test_who_says_nothing_is_not_waited_for_without_end(self):
        wire = self.server.wire(timeout=40)
        start = time.monotonic()
        self.assertEqual(wire.rest(), b"")
        self.assertLess(time.monotonic() - start, 30 * SLOW)
        self.test_a_viewer_that_trusts_the_certificate()

    def test_old_versions_are_refused(self):
        for version in (ssl.TLSVersion.TLSv1, ssl.TLSVersion.TLSv1_1):
            context = ssl.SSLContext(ssl.PROTOCOL_TLS_CLIENT)
            context.check_hostname, context.verify_mode = False, ssl.CERT_NONE
            with warnings.catch_warnings():
                warnings.simplefilter("ignore", DeprecationWarning)
                context.minimum_version = context.maximum_version = version
            context.set_ciphers("ALL:@SECLEVEL=0")  # Without this the client itself would refuse.
            with self.assertRaises((ssl.SSLError, Closed, ConnectionError)) as refused:
                Wire(self.server.host, self.server.port, 20 * SLOW, context)
            self.assertNotIn("no protocols available", str(refused.exception).lower(), "the client's own refusal")

    def test_others_wait_for_nobody_in_the_middle_of_a_handshake(self):
        stuck = [socket.create_connection((self.server.host, self.server.port)) for _ in range(20)]
        for sock in stuck:
            sock.send(b"\x16\x03\x01\x02\x00\x01")  # The beginning of a ClientHello.
        with Viewer(self.server.address, context=self.context(), timeout=30 * SLOW) as viewer:
            viewer.see()
        for sock in stuck:
            sock.close()

    def test_a_key_that_does_not_belong_to_the_certificate(self):
        other = os.path.join(self.folder.name, "other.pem")
        subprocess.run(["openssl", "genpkey", "-algorithm", "EC", "-pkeyopt", "ec_paramgen_curve:prime256v1", "-out", other],
                       check=True, capture_output=True)
        for certificate, key in ((self.certificate, other), (self.key, self.key), (self.certificate, self.certificate)):
            result = run("serve", *SCENE, "--port", "0", "--tls-cert", certificate, "--tls-key", key)
            self.assertEqual(result.returncode, 2, result.stderr)
            self.assertEqual(len(result.stderr.splitlines()), 1)
            self.assertIn("--tls-", result.stderr)


if __name__ == "__main__":
    suite.main()
