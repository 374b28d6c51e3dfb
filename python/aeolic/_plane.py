"""Line integral convolution of plane arrays."""
import numpy

from . import _core
from ._checks import nearest, refuse_unknown, text
from ._data import InputError, _numbers
from ._options import TABLE, documented, texts

# Noise is as coarse as the arrays, and pixels without streaks are not finite.
PLANE_OPTIONS = [name for name, row in TABLE.items()
                 if row["group"] == "lic" and name not in ("noise_scale", "mask_below")]


def _plane(name, value, shape=None):
    array = _numbers(f"lic2d: {name}", value)
    if array.ndim != 2 or (shape is not None and array.shape != shape):
        raise InputError(f"lic2d: {name}: found shape {array.shape}; expected {'(ny, nx)' if shape is None else shape}")
    with numpy.errstate(over="ignore"):  # What float cannot hold counts as not finite.
        return numpy.ascontiguousarray(array, dtype="f4")


def _one_of(name, value, names):
    if text(f"lic2d: {name}", value) not in names:
        raise InputError(f"lic2d: {name}: found {value!r}; expected one of {', '.join(names)}" + nearest(value, names))
    return value


def _steps(spacing):
    """(dy, dx), of two numbers or of one for both."""
    steps = _numbers("lic2d: spacing", spacing).astype("f8")
    steps = numpy.repeat(steps, 2) if steps.ndim == 0 else steps
    if steps.shape != (2,):
        raise InputError(f"lic2d: spacing: found shape {steps.shape}; expected (dy, dx), or one number for both")
    for step in steps:
        if step == 0 or not numpy.isfinite(step):
            raise InputError(f"lic2d: spacing: found {step}; expected finite numbers other than 0")
    return steps


def _in_pixels(u, v, steps):
    """The flow as it runs over pixels, where one of them is so high and so wide. The factors are 1 at most, so that nothing
    grows beyond a float."""
    least = numpy.abs(steps).min()
    down, right = numpy.sign(steps) * least / numpy.abs(steps)
    return u if right == 1 else u * numpy.float32(right), v if down == 1 else v * numpy.float32(down)


@documented(PLANE_OPTIONS)
def lic2d(u, v, *, spacing=(1, 1), texture=None, boundary="closed", uv_mode="velocity", **options):
    """The line integral convolution of a flow in the plane: float32 (ny, nx) of zero mean and about unit variance.

    u, v: (ny, nx) numbers, the flow along rows (towards higher columns) and across them (towards higher rows). Where one
        of them is not finite, as on land, nothing flows: streaks end there, and the value is NaN.
    spacing: (dy, dx), how far apart rows and columns are, in the unit of length of u and v; negative where a coordinate
        falls, such as a latitude from north to south. One number for both. Streaks then run at the flow's own angle in a
        picture of those proportions: imshow(value, origin="lower", aspect=abs(dy / dx)).
    texture: (ny, nx) numbers, the noise; its least value counts as black and its greatest as white. None: white noise
        from seed=.
    boundary: "closed": streaks end at the ends of the arrays; "periodic": they go on at the other end. Then memory and
        time grow with the square of steps times step, however small the arrays are.
    uv_mode: "velocity", or "polarization", where (u, v) and (-u, -v) are the same: signs may jump from one number to the
        next. Then lic="direct" is the default, and the only one.

    Ctrl-C ends it. Contiguous arrays of float32 are not copied. Raises InputError for arrays of other shapes and values out of range.
    """
    refuse_unknown("lic2d", options, ["u", "v", "spacing", "texture", "boundary", "uv_mode", *PLANE_OPTIONS])
    periodic = _one_of("boundary", boundary, ["closed", "periodic"]) == "periodic"
    axial = _one_of("uv_mode", uv_mode, ["velocity", "polarization"]) == "polarization"
    if axial and options.get("lic") is None:
        options["lic"] = "direct"
    right = _plane("u", u)
    down = _plane("v", v, right.shape)
    right, down = _in_pixels(right, down, _steps(spacing))
    noise = None if texture is None else _plane("texture", texture, right.shape)
    return _core.lic2d(right, down, noise, periodic, axial, texts(options))
