"""A scene that is shown in a browser, from a server in this process."""
import html
import math
import os
import reprlib
import sys
import urllib.parse
import weakref
from collections.abc import Mapping

import numpy

from ._checks import InputError, nearest, number, text, whole


def in_notebook():
    """Whether this process is the kernel of a notebook."""
    shell = sys.modules.get("IPython")
    shell = shell and shell.get_ipython()
    return shell is not None and getattr(shell, "kernel", None) is not None


def served(port, title, controls):
    """What a server is asked for: (port, title, [(name, kind, lo, hi, value)]); the last of
    {name: (lo, hi[, value]) | bool | "button"}."""
    if controls is not None and not isinstance(controls, Mapping):
        raise TypeError(f"controls: found {type(controls).__name__}; expected a dict")
    made = []
    for name, what in (controls or {}).items():
        name = text("controls: name", name)
        if isinstance(what, (bool, numpy.bool_)):
            made.append((name, "toggle", 0.0, 1.0, float(what)))
        elif isinstance(what, str) and what == "button":
            made.append((name, "button", 0.0, 1.0, 0.0))
        elif isinstance(what, (tuple, list)) and len(what) in (2, 3):
            lo, hi, value = (number(f"controls: {name!r}", one) for one in (*what, what[0])[:3])
            made.append((name, "number", lo, hi, value))
        else:
            raise TypeError(f"controls: found {name!r}: {reprlib.repr(what)}; "
                            "expected (lowest, highest, value), True, False or 'button'")
    return whole("port", port, 0, 65535), text("title", title), made


# A notebook on this host may be open as localhost or as 127.0.0.1. Cookies go only to the same one.
FRAME = """<iframe id="{id}" title="Aeolic" style="width:100%;height:{height}px;border:1px solid #8884;border-radius:6px"></iframe>
<script>(() => {{
  const frame = document.getElementById("{id}"), here = location.hostname, path = "{path}";
  const url = new URL("{address}");
  if (path) frame.src = path + url.search;
  else {{
    if (["localhost", "127.0.0.1"].includes(here)) url.hostname = here;
    frame.src = url.href;
  }}
}})()</script>
<noscript><a href="{address}">{address}</a></noscript>"""


class Server:
    """What shows a renderer's scene: until it is closed, or the renderer or the interpreter goes."""

    def __init__(self, renderer, loaded, asked):
        self.asked = asked
        self.address = loaded.show(*asked)
        self.close = weakref.finalize(renderer, loaded.hide)

    @property
    def is_open(self):
        return self.close.alive

    def refuse_others(self, port, title, controls):
        """One scene has one server: later callers cannot get another one."""
        has = urllib.parse.urlsplit(self.address).port, *self.asked[1:]
        wanted = zip(("port", "title", "controls"), (port, title, controls), has, (0, "Program", []))
        for name, other, own, none in wanted:
            if other not in (own, none):
                raise InputError(f"{name}: found others than the open viewer has; expected the same, or close() before")

    def control(self, name):
        """The name of a control that there is."""
        name = text("control", name)
        names = [control[0] for control in self.asked[2]]
        if name not in names:
            expected = f"one of {', '.join(names)}" if names else "none: show() was given none"
            raise InputError(f"control: found {name!r}; expected {expected}" + nearest(name, names))
        return name


class Viewer:
    """A scene that is being shown. It ends with close(), or when nobody holds the Renderer or a Viewer of it.

    address: open it in a browser on this host. It holds a secret, so that nobody else can look.
    In a notebook it shows the page itself. height: of that, in pixels.
    """

    def __init__(self, renderer, server, height, proxy):
        self.address, self.height, self._proxy = server.address, height, proxy
        self._renderer, self._server = renderer, server  # The renderer holds no viewer: they go at once.

    @property
    def is_open(self):
        """Whether the server runs."""
        return self._server.is_open

    def value(self, control):
        """What a viewer has set this control to: a number; 0 or 1 of a switch; of a button how often it was pressed."""
        return self._loaded().control(self._server.control(control))

    def set_value(self, control, value):
        """Sets a control, for all viewers to see. A number is kept within its range."""
        loaded, name, value = self._loaded(), self._server.control(control), number("value", value)
        if math.isnan(value):
            raise InputError("value: found nan; expected a number")
        loaded.set_control(name, value)

    def close(self):
        """Ends the server. Pages that are open say so."""
        self._server.close()

    def _loaded(self):
        if not self.is_open:
            raise RuntimeError("the viewer is closed")
        return self._renderer._loaded

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def __repr__(self):
        return f"<aeolic.Viewer at {self.address}>" if self.is_open else "<aeolic.Viewer, closed>"

    def _repr_html_(self):
        if not self.is_open:
            return "closed"
        url = urllib.parse.urlsplit(self.address)
        path = self._proxy.replace("{port}", str(url.port))
        return FRAME.format(id=f"aeolic-{url.port}-{os.urandom(4).hex()}", height=int(self.height), path=html.escape(path),
                            address=html.escape(self.address))


def proxy_text(given):
    """Where a notebook has the ports of this host: as given, or in a JupyterHub with jupyter-server-proxy. Empty:
    nowhere."""
    if given:
        return text("proxy", given)
    prefix = os.environ.get("JUPYTERHUB_SERVICE_PREFIX")
    return f"{prefix.rstrip('/')}/proxy/{{port}}/" if prefix else ""
