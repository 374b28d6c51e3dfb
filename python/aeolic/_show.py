"""A server of the program for one scene, and a browser that looks at it."""
import html
import os
import pathlib
import shutil
import subprocess
import tempfile
import time
import weakref

from . import _core

HERE = pathlib.Path(__file__).resolve().parent
STARTED_AFTER_S = 60  # At most, until the server tells its address.


def _program():
    """The program that was built or installed with this module, or else the one on the path."""
    for place in (HERE.parent.parent / "aeolic", HERE.parents[3] / "bin" / "aeolic"):
        if place.is_file() and os.access(place, os.X_OK):
            return str(place)
    found = shutil.which("aeolic")
    if not found:
        raise RuntimeError("there is no program aeolic beside this module or on the path: install it to show a scene")
    return found


def _stop(server, folder):
    server.terminate()
    try:
        server.wait(10)
    except subprocess.TimeoutExpired:
        server.kill()
        server.wait()
    folder.cleanup()


class Viewer:
    """A scene that is being shown. It ends with close(), or when nobody holds this object.

    address: open it in a browser. It holds a secret, so that nobody else can look.
    """

    def __init__(self, words):
        folder = tempfile.TemporaryDirectory(prefix="aeolic-")
        file, said = pathlib.Path(folder.name) / "address", pathlib.Path(folder.name) / "said"
        with open(said, "wb") as errors:
            server = subprocess.Popen([_program(), "serve", *words, "--port=0", f"--address-file={file}"],
                                      stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=errors)
        self._end = weakref.finalize(self, _stop, server, folder)
        until = time.monotonic() + STARTED_AFTER_S
        while not file.exists():
            if server.poll() is not None or time.monotonic() > until:
                words = said.read_text(errors="replace").strip().splitlines() or ["the server said nothing"]
                self._end()
                raise (_core.InputError if server.returncode == 2 else RuntimeError)(words[-1].removeprefix("aeolic: "))
            time.sleep(0.02)
        self.address = file.read_text().strip()

    def close(self):
        """Ends the server."""
        self._end()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def __repr__(self):
        return f"<aeolic.Viewer at {self.address}>" if self._end.alive else "<aeolic.Viewer, closed>"

    def _repr_html_(self):
        link = html.escape(self.address)
        return f'<a href="{link}" target="_blank">{link}</a>' if self._end.alive else "closed"
