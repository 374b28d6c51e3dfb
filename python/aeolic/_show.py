"""A scene that is shown in a browser, from a server in this process."""
import html
import os
import sys
import urllib.parse
import weakref


def in_notebook():
    """Whether this process is the kernel of a notebook."""
    shell = sys.modules.get("IPython")
    shell = shell and shell.get_ipython()
    return shell is not None and getattr(shell, "kernel", None) is not None


def control_texts(controls):
    """[(name, kind, lo, hi, value)] of {name: (lo, hi[, value]) | bool | "button"}."""
    made = []
    for name, what in (controls or {}).items():
        if isinstance(what, bool):
            made.append((name, "toggle", 0.0, 1.0, float(what)))
        elif what == "button":
            made.append((name, "button", 0.0, 1.0, 0.0))
        elif isinstance(what, (tuple, list)) and len(what) in (2, 3):
            lo, hi = float(what[0]), float(what[1])
            made.append((name, "number", lo, hi, float(what[2]) if len(what) == 3 else lo))
        else:
            raise TypeError(f"controls: found {name!r}: {what!r}; expected (lowest, highest, value), True, False or 'button'")
    return made


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


class Viewer:
    """A scene that is being shown. It ends with close(), or when nobody holds this object.

    address: open it in a browser on this host. It holds a secret, so that nobody else can look.
    In a notebook it shows the page itself. height: of that, in pixels.
    """

    def __init__(self, renderer, loaded, address, height, proxy):
        self.address, self.height, self._proxy = address, height, proxy
        self._renderer, self._loaded = renderer, loaded
        self._end = weakref.finalize(self, loaded.hide)

    @property
    def is_open(self):
        """Whether the server runs."""
        return self._end.alive

    def value(self, control):
        """What a viewer has set this control to: a number; 0 or 1 of a switch; of a button how often it was pressed."""
        return self._loaded.control(self._name(control))

    def set_value(self, control, value):
        """Sets a control, for all viewers to see. A number is kept within its range."""
        self._loaded.set_control(self._name(control), float(value))

    def close(self):
        """Ends the server. Pages that are open say so."""
        self._end()

    def _name(self, control):
        if not self.is_open:
            raise RuntimeError("the viewer is closed")
        return control

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
        path = (self._proxy or "").format(port=url.port)
        return FRAME.format(id=f"aeolic-{url.port}-{os.urandom(4).hex()}", height=int(self.height), path=html.escape(path),
                            address=html.escape(self.address))


def proxy_of_hub():
    """Where JupyterHub has the ports of this host, if this is a kernel of one with jupyter-server-proxy."""
    prefix = os.environ.get("JUPYTERHUB_SERVICE_PREFIX")
    return f"{prefix.rstrip('/')}/proxy/{{port}}/" if prefix else None
