#pragma once

/// What to draw, as plain structs with defaults and units. The command line, the scene JSON and the C++ interface all
/// fill these same structs; `validate()` in scene/validate.h is the one place that judges them.

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace aeolic {

using Vec3 = std::array<double, 3>;

/// Where the surface comes from. `spec` follows the command line's `--surface`:
/// a file name | teapot[:TRIANGLES] | sphere | torus | plane | wave | slice:OX,OY,OZ:NX,NY,NZ | isosurface:ARRAY=VALUE
/// | boundary. A file name may be one of a series in time (docs/file-formats.md).
struct SurfaceSource {
    std::string spec = "teapot";
    double featureAngleDeg = 20;  ///< Edges sharper than this stay sharp when normals are computed. Degrees, [0, 180].
};

/// Where the vectors come from: a 3D field sampled at every pixel, or an array of the surface itself.
struct FieldSource {
    std::string spec;  ///< A file or series | abc | tornado | rotation | uniform | gyre[:NX,NY,NZ]; empty: the
                       ///< surface's own array.
    std::string precision = "float";  ///< float | half: how the field is kept in memory.
    std::string vectors;              ///< Array name; empty: the file's active vectors, or its only 3-component array.
    std::optional<double> resampleSpacing;  ///< World units; non-uniform grids are resampled to this. Default: about
                                            ///< their own mean cell size.
};

enum class LicMethod { none, direct, hierarchical };
enum class Integrator { euler, rk2, rk4 };
enum class Kernel { box, hann };

/// The line integral convolution (paper, section 3, "LIC stage").
struct LicOptions {
    LicMethod method = LicMethod::hierarchical;
    Integrator integrator = Integrator::rk2;  ///< For `direct`.
    int steps = 128;                          ///< Integration steps in each direction, [1, 65536].
    double stepPx = 1.0;  ///< Length of a step, in pixels of an unforeshortened surface at the focal point, (0, 8].
    Kernel kernel = Kernel::box;
    double phaseRad = 0;      ///< Moves the Hann kernel along the streamline; 2 pi is a full cycle.
    bool normalize = true;    ///< false: steps in proportion to the vector's magnitude, the largest taking `stepPx`.
    double noiseScale = 1.0;  ///< Noise texels per pixel at the focal point, [0.01, 16].
    std::uint32_t seed = 1;
};

/// Colours, light and how strongly the LIC shows (paper, "blending stage").
struct ShadingOptions {
    std::string colorBy;                              ///< Scalar array, or NAME:mag; empty: a plain surface.
    std::string colorMap = "viridis";                 ///< viridis | turbo | coolwarm | gray
    std::optional<std::array<double, 2>> colorRange;  ///< Default: the array's own range on the surface.
    bool scalarBar = true;                            ///< Drawn only when colouring.
    double contrast = 1.0;                            ///< Slope of the LIC's tone curve, [0, 10].
    double blend = 0.8;                               ///< 0: the lit surface alone … 1: full LIC modulation.
    std::string background = "ffffff";                ///< RRGGBB | transparent
    bool lighting = true;
};

/// A view, either relative to a fit of the whole surface or absolute.
struct CameraOptions {
    double azimuthDeg = 30, elevationDeg = 20, rollDeg = 0;
    double zoom = 1;     ///< (0, 1e6]; 1 shows the whole surface with a small margin.
    double fovDeg = 30;  ///< Vertical field of view, [1, 170].
    std::optional<Vec3> position, focal,
        up;  ///< World coordinates. `position` set: absolute; the angles are then ignored.
};

/// Which moments of data that change in time are shown. In the data's own unit of time; without meaning where nothing
/// changes. Between two steps the data are interpolated, outside of all steps the nearest end is shown.
struct TimeOptions {
    std::optional<double> moment;                ///< Of a still picture. Default: the first. [-1e30, 1e30]
    std::optional<std::array<double, 2>> range;  ///< Of an animation's first and last frame; may run backwards. Frame i
                                                 ///< of N shows range[0] + (range[1] - range[0]) i / (N - 1).
};

/// One still or an animation.
struct OutputOptions {
    int width = 800, height = 800;   ///< Pixels, [1, 32768].
    int frames = 1;                  ///< [1, 100000]; more than one: the file name gets -%04d.
    std::optional<double> orbitDeg;  ///< The turn over the whole animation. Default: 360, with a range in time 0.
};

/// How the machine is used; never changes the picture.
struct RunOptions {
    std::string backend = "auto";  ///< auto | cpu | gl
    int threads = 0;               ///< Of each rank; 0: all cores, shared among the ranks of a host.
    int device = -1;               ///< GPU index; -1: by rank.

    std::string balance = "hybrid";  ///< static | timing | pixels | hybrid: stripes of the LIC stage.
    std::string bricks = "auto";     ///< on | off | auto: whether field or surface are split among the ranks.
    std::string guard = "estimate";  ///< bound | estimate: guard rows from the worst case, or from the vectors there.
    std::string guardRows = "auto";  ///< project | receive | auto: drawn again, or received from their owners.
};

struct SceneDescription {
    SurfaceSource surface;
    FieldSource field;
    TimeOptions time;
    LicOptions lic;
    ShadingOptions shading;
    CameraOptions camera;
    OutputOptions output;
    RunOptions run;
};

}  // namespace aeolic
