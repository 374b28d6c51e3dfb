#pragma once

/// What to draw, as plain structs with defaults and units. The command line, the scene JSON and the C++ interface all
/// fill these same structs. A Renderer checks every value before it reads a file, and throws InputError for a wrong
/// one.

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace aeolic {

using Vec3 = std::array<double, 3>;

/// What becomes of values that a surface has on its polygons: brought to the points, or one value for each.
enum class CellValues { smooth, steps };

/// Which faces of the surface are drawn: all, or only those turned to the viewer, whose corners run counterclockwise
/// there.
enum class Faces { both, front };

/// Where the surface comes from. `spec` follows the command line's `--surface`; SurfaceSpec makes it of its parts:
/// a file name | teapot[:TRIANGLES] | sphere | torus | plane | wave | slice:OX,OY,OZ:NX,NY,NZ | isosurface:ARRAY=VALUE
/// | boundary. A file name may be one of a series in time (docs/file-formats.md).
struct SurfaceSource {
    std::string spec = "teapot";
    double featureAngle = 20;  ///< Edges sharper than this stay sharp when normals are computed. Degrees, [0, 180].
    CellValues cells = CellValues::smooth;  ///< smooth does not cross those edges.
    Faces faces = Faces::both;
};

/// One of several surfaces in a picture. What is not set is as for all surfaces.
struct SurfaceItem {
    std::string spec;                                 ///< As SurfaceSource::spec, but not `image`.
    std::optional<std::string> vectors;               ///< An array of this surface's own, also where there is a field.
    std::optional<std::string> colorBy;               ///< As ShadingOptions::colorBy; empty: a plain surface.
    std::optional<std::string> colormap, legend;      ///< As in ShadingOptions.
    std::optional<std::array<double, 2>> colorRange;  ///< As in ShadingOptions.
    bool streaks = true;                              ///< false: without streaks. Such a surface needs no vectors.
    bool shown = true;  ///< false: loaded, but not drawn. Camera fit and default ranges go by those that are shown.
};

/// How the vectors of a field are kept in memory: as float or as IEEE half. "float" and "half" in texts.
enum class FieldPrecision { float32, float16 };

/// Where the vectors come from: a 3D field sampled at every pixel, or an array of the surface itself.
struct FieldSource {
    std::string spec;  ///< A file or series | abc | tornado | rotation | uniform | gyre[:NX,NY,NZ]; empty: the
                       ///< surface's own array.
    FieldPrecision precision = FieldPrecision::float32;
    std::string vectors;  ///< Array name, with a field also wallShear(NAME), without one reversed(NAME); empty: the
                          ///< file's active vectors, or its only 3-component array.
    std::optional<double> offset;  ///< World units: how far off the surface a field is sampled, on the side of the
                                   ///< field or, where it is on both, along the normal. Not set ("auto" in texts): on
                                   ///< the surface where there is flow, else where the nearest cells have theirs
                                   ///< (docs/file-formats.md). [-1e30, 1e30]
    std::optional<double> resampleSpacing;  ///< World units; non-uniform grids are resampled to this. Default: they
                                            ///< are sampled in their own cells.
};

enum class LicMethod { none, direct, hierarchical };
enum class Integrator { euler, rk2, rk4 };
enum class Kernel { box, hann };
/// How much the noise along a streamline counts: all the same, or by the width of the stream tube.
enum class Streaks { plain, even };

/// What streaks are made of. dense: noise all over. oriented: grains with room between them, each drawn out into a
/// streak that grows brighter towards its head, and so tells which way the flow goes (docs/concepts.md). These take a
/// sixth of `steps`, no `kernel`, and `phase` only where they flow.
enum class Style { dense, oriented };

/// Whether streaks run along the flow. loop: the frames of an animation are phases of one cycle, which closes: after
/// the last one comes the first. Dense streaks have the Hann kernel then, whatever `kernel` says. Oriented ones become
/// comets, each at its own time (docs/decisions/0034-flow-loop.md).
enum class FlowMotion { off, loop };

/// The line integral convolution (paper, section 3, "LIC stage").
/// How streaks tell how fast the flow along the surface is. `contrast`: where it is slow they fade, by the root of the
/// vector's length along the surface as a part of the longest vector's. `length`: steps are in proportion to the
/// vector's magnitude, whatever `normalize` says.
enum class Magnitude { none, contrast, length };

struct LicOptions {
    LicMethod method = LicMethod::hierarchical;
    Style style = Style::dense;
    Integrator integrator = Integrator::rk2;  ///< How `direct` traces.
    int steps = 128;                          ///< Integration steps in each direction, [1, 65536].
    double step = 1.0;  ///< Length of a step, in pixels of an unforeshortened surface at the focal point, (0, 8].
    Kernel kernel = Kernel::box;
    Streaks streaks = Streaks::even;  ///< plain: the paper's.
    double phase = 0;                 ///< Radians. Moves the Hann kernel along the streamline; 2 pi is a full cycle.
    FlowMotion flow = FlowMotion::off;
    bool normalize = true;  ///< false: steps in proportion to the vector's magnitude, the largest taking `step`.
    Magnitude magnitude = Magnitude::none;
    double noiseScale = 1.0;  ///< Noise texels per pixel at the focal point, [0.01, 16].
    std::uint32_t seed = 1;
    double maskBelow = 0;  ///< No streaks show where the vector is shorter, in its own unit; 0: everywhere they do.
};

/// Which values a range goes from and to: the least and the greatest, or the 2nd and the 98th percentile by area.
enum class RangeOf { data, robust };

/// Colours, light and how strongly the LIC shows (paper, "blending stage").
struct ShadingOptions {
    /// [surface:|field:][point:|cell:]NAME[:mag|:x|:y|:z|:normal|:tangential]: a scalar array, or a part of vectors.
    /// Without a prefix the array beside the vectors, else the other's, on points rather than on cells. Empty: a plain
    /// surface.
    std::string colorBy;
    /// viridis | turbo | coolwarm | gray | plasma | inferno | magma | cividis | twilight | RdBu | vik | a file
    /// (docs/file-formats.md)
    std::string colormap = "viridis";
    std::optional<std::array<double, 2>> colorRange;  ///< Default: what `colorRangeOf` says.
    RangeOf colorRangeOf =
        RangeOf::data;  ///< The range on the surface at the first moment, where `colorRange` is not set.
    /// linear | log | bands:N, N equal parts of one colour each. With log the range is above 0: a low end of the
    /// array's own that is not becomes a thousandth of the high end.
    std::string colorScale = "linear";
    /// RRGGBB: of values that are not numbers or masked, of values below the range and above it. Empty: as a colour
    /// map's file says, else gray, the map's first colour and its last.
    std::string nanColor, belowColor, aboveColor;
    bool scalarBar = true;   ///< The legend; drawn only when colouring.
    std::string legend;      ///< Its title, unit included, UTF-8. Empty: the array's name.
    std::string title;       ///< Above the picture, UTF-8. Empty: none.
    bool axes = false;       ///< How the world's axes are turned, in the lower left corner.
    bool timeStamp = false;  ///< The moment shown, in the lower right corner; drawn only where something changes.
    double textScale = 1.0;  ///< The size of legend, title, axes and time stamp, times the usual one, [0.5, 4].
    double contrast = 1.0;   ///< Slope of the LIC's tone curve, [0, 10].
    double blend = 0.8;      ///< 0: the lit surface alone … 1: full LIC modulation.
    std::string background = "ffffff";  ///< RRGGBB | transparent
    bool lighting = true;
    bool antialias = true;   ///< Silhouettes, creases and lines where surfaces cross are smoothed.
    bool occlusion = false;  ///< Corners and hollows are darker. Without effect where `lighting` is off.
    /// Lines and marks over the streaks: "none", or some of these with ',' between (docs/overlays.md). "streamlines" or
    /// "streamlines:PX": evenly spaced ones with arrow heads, PX pixels apart in a picture of 800x800, [4, 1000].
    /// "topology": the critical points of the flow along the surface, and the lines of separation and attachment that
    /// leave its saddles. "edges": the sides of the triangles. "outline": silhouettes, creases and borders.
    std::string overlay = "none";
    /// A saddle and a point that it is joined with are left out where they are no farther apart along their line than
    /// this part of the surface's size, the diagonal of its box: noise of the data makes such pairs. [0, 1]
    double persistence = 0.01;
};

/// A view, either relative to a fit of the whole surface or absolute.
struct CameraOptions {
    double azimuth = 30, elevation = 20, roll = 0;  ///< Degrees.
    /// (0, 1e6]; 1 shows the whole surface with a small margin, N an N-th of it. The eye comes closer and stays outside
    /// the surface's bounding sphere; beyond that the field of view narrows.
    double zoom = 1;
    double fov = 30;  ///< Vertical field of view, degrees, [1e-6, 170]; at least 1 where `position` is not set.
    std::optional<Vec3> position, focal,
        up;  ///< World coordinates. `position` set: absolute; angles and zoom are then ignored.
};

/// A moment of data that change in time, by its place among all.
enum class MomentOf { first, last };

/// Which moments of data that change in time are shown. In the data's own unit of time; without meaning where nothing
/// changes. Between two steps the data are interpolated, outside of all steps the nearest end is shown.
struct TimeOptions {
    std::optional<double> moment;  ///< The moment of a still picture. Default: what `momentOf` says. [-1e30, 1e30]
    std::optional<std::array<double, 2>> range;  ///< The moments of the first and the last frame; may run backwards.
                                                 ///< Frame i of N shows range[0] + (range[1] - range[0]) i / (N - 1).
    MomentOf momentOf = MomentOf::first;         ///< Which of the data's steps, where neither is set.
};

/// One still or an animation.
struct OutputOptions {
    int width = 800, height = 800;  ///< Pixels, [1, 32768].
    int frames = 1;                 ///< [1, 100000]; more than one: the file name gets -%04d.
    double fps = 25;                ///< Frames per second of an animation in one file, [0.1, 240].
    /// The turn over the whole animation, degrees. Default: 360; with a range in time, and where streaks flow, 0.
    std::optional<double> orbit;
};

/// Which backend draws. `automatic` ("auto" in texts): the GPU where there is a real one, else the processor.
enum class BackendChoice { automatic, cpu, gl };

/// How the rows of a picture are dealt to the ranks. `equal` ("static" in texts): the same number to each; `timing`: by
/// the times of the last frame; `pixels`: by the pixels that this frame's surface covers; `hybrid`: by pixels and
/// speeds.
enum class Balance { equal, timing, pixels, hybrid };

/// Whether the field, or a surface in pieces, is split among the ranks. `automatic` ("auto"): where one has no room.
enum class BrickChoice { on, off, automatic };

/// How many guard rows a stripe gets: as many as the worst case needs, or as many as the vectors that are there need.
enum class GuardChoice { bound, estimate };

/// Where guard rows come from: drawn again, or received from the ranks that own them. `automatic` ("auto"): whichever
/// is cheaper.
enum class GuardRowsChoice { project, receive, automatic };

/// How the machine is used; never changes the picture.
struct RunOptions {
    BackendChoice backend = BackendChoice::automatic;
    /// Threads of this rank, [0, 4096], at most 8 a core; 0: all cores, shared by a host's ranks. Ranks may differ.
    int threads = 0;
    int device = -1;  ///< GPU index, [-1, 255]; -1: by rank.

    Balance balance = Balance::hybrid;
    BrickChoice bricks = BrickChoice::automatic;
    GuardChoice guard = GuardChoice::estimate;
    GuardRowsChoice guardRows = GuardRowsChoice::automatic;
};

struct SceneDescription {
    SurfaceSource surface;
    /// Where this is not empty, these surfaces are drawn together, and `surface.spec` is not. At most 200, one of them
    /// with streaks. Those with the same array, colour map and range have one legend; at most 7 differ in that.
    std::vector<SurfaceItem> surfaces;
    FieldSource field;
    TimeOptions time;
    LicOptions lic;
    ShadingOptions shading;
    CameraOptions camera;
    OutputOptions output;
    RunOptions run;
};

}  // namespace aeolic
