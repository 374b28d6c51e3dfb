#pragma once

/// The one table of a scene's options: what each is called in the JSON and on the command line, what it may be, and
/// what `--help` says about it. Reading, writing, checking, `--help`, the command line and the page are all made from
/// it. A new option is a field in aeolic/scene_description.h and a row here.

#include <limits>
#include <numbers>
#include <string_view>

#include "aeolic/scene_description.h"
#include "description/choices.h"
#include "description/color_scale.h"
#include "description/colormap.h"
#include "description/option_rules.h"
#include "description/overlays.h"

namespace aeolic {

/// Options that stand together: in one object of the JSON, and under one heading of `--help`. `own`: the key of the
/// option that has the group's name. "--lic" sets "method" of "lic".
struct OptionGroup {
    const char* key;
    const char* heading;
    const char* own = "";
};

/// A row of the table, but for the rule. `name` is that of the command line. A name of two words is an item of a
/// compound option: "--camera zoom" is set by `--camera zoom=2`. A row "--time word" has the words that `--time` takes
/// in the place of numbers.
///
/// An option has one name in all languages. What the command line calls "--noise-scale" is noise_scale in Python
/// (pythonName()), and noiseScale among its group in the JSON and in C++.
struct Option {
    OptionGroup group;
    const char* key;  ///< In the JSON, and of the struct's member: it follows from `name`.
    const char* name;
    const char* value;       ///< What stands for the value in `--help`; empty: the names it can have.
    const char* help;        ///< Without the range and the default, which the rule and the field tell.
    const char* unset = "";  ///< In words what holds where the field has no value of its own.
};

/// An option of the command line that is no row of the table.
struct TypedOption {
    const char* name;
    const char* value;
    const char* heading;
    const char* help;
    bool hasItems = false;  ///< They are typed by their names: "zoom=2".
};

/// Stands behind `--surface`, which may be repeated, too.
inline constexpr TypedOption contextOption{
    "--context", "SURFACE", "Data",
    "one more surface, drawn plain and without streaks, for orientation; may be repeated"};

/// Options that set several fields of the description at once.
inline constexpr TypedOption compoundOptions[] = {
    {"--size", "WxH", "View", "the picture in pixels"},
    {"--camera", "ITEMS", "View",
     "the view: front, back, left, right, top or bottom, and NAME=VALUE, several with ',' or ';' between them. Angles "
     "and zoom are relative to a view of the whole surface; position=X,Y,Z;focal=X,Y,Z;up=X,Y,Z are a place in the "
     "world",
     true},
};

/// What follows an option's name in the name of the row that has its words.
inline constexpr std::string_view wordSuffix = " word";

/// A view by its name: from where the eye looks at the surface, in degrees. The front is where y is least, the right
/// where x is greatest.
struct NamedView {
    std::string_view name;
    double azimuthDeg, elevationDeg;
};

inline constexpr NamedView namedViews[] = {{"front", 0, 0},  {"back", 180, 0}, {"left", -90, 0},
                                           {"right", 90, 0}, {"top", 0, 90},   {"bottom", 0, -90}};

namespace options {

inline constexpr OptionGroup surface{"surface", "Data", "spec"}, field{"field", "Data", "spec"},
    time{"time", "Time", "moment"}, lic{"lic", "Line integral convolution", "method"},
    shading{"shading", "Colours and light"}, camera{"camera", "View"}, output{"output", "View"},
    machine{"run", "Machine"}, ranks{"run", "Several ranks (mpirun -n N aeolic ...); never changes the picture"};

inline constexpr double largest = std::numeric_limits<double>::max();
inline constexpr NumberRule angle{-1e6, 1e6};         // Beyond, a double's turns are no longer exact to a pixel.
inline constexpr NumberRule coordinate{-1e30, 1e30};  // Squares must stay finite in float.
inline constexpr NumberRule scalar{-1e37, 1e37};      // Differences must stay finite in float.
inline constexpr NumberRule side{1, 32768};           // A side of a picture, in pixels.
inline constexpr NumberRule textScale{0.5, 4};
inline constexpr std::size_t mostSurfaces = 200;  // In one picture: a byte says which a point is of.

inline bool isColor(std::string_view text)
{
    return text == "transparent" ||
           (text.size() == 6 && text.find_first_not_of("0123456789abcdefABCDEF") == std::string_view::npos);
}

inline constexpr TextRule anyName{"text", "a name", [](std::string_view) { return true; }};
inline constexpr TextRule anyText{"text", "text", [](std::string_view) { return true; }};
inline constexpr TextRule someName{"text", "a file or a built-in surface",
                                   [](std::string_view text) { return !text.empty(); }};
inline constexpr TextRule color{"color", "six hexadecimal digits RRGGBB or transparent", isColor};
inline constexpr TextRule opaqueColor{"opaque", "six hexadecimal digits RRGGBB", [](std::string_view text) {
                                          return text.empty() || (isColor(text) && text != "transparent");
                                      }};

template <class Choice>
inline constexpr NameRule choice{choiceNames<Choice>};

}  // namespace options

/// Calls visit(Option, value&, rule) for every field of a SceneDescription (const or not), in the order of the structs.
template <class Scene, class Visit>
void forEachOption(Scene&& scene, Visit&& visit)
{
    using namespace options;

    visit(
        Option{surface, "spec", "--surface", "SURFACE",
               "a file ({surfaces}), FILE:PART,PART of one with parts (names, groups, patterns with *; of an OpenFOAM "
               "case alone all walls), a series of files in time; teapot, sphere, torus, plane or wave (it moves), "
               "each also with :TRIANGLES; or cut out of the field's data set: slice:OX,OY,OZ:NX,NY,NZ, "
               "isosurface:ARRAY=VALUE, boundary, image (a field of one layer as it is, each sample a pixel or "
               "more); may be repeated, for several surfaces in one picture"},
        scene.surface.spec, someName);
    visit(Option{surface, "featureAngle", "--feature-angle", "DEGREES",
                 "edges sharper than this stay sharp when normals are computed"},
          scene.surface.featureAngle, NumberRule{0, 180});
    visit(Option{surface, "cells", "--cells", "",
                 "vectors and colours that a surface has on its cells; smooth: brought to the points, but not across "
                 "sharp edges; steps: as they are"},
          scene.surface.cells, choice<CellValues>);
    visit(Option{surface, "faces", "--faces", "",
                 "front: only faces turned to the viewer; of faces in the same place that one shows in either case"},
          scene.surface.faces, choice<Faces>);

    visit(Option{field, "spec", "--field", "FIELD",
                 "a 3D vector field to sample on the surface: a file ({fields}), FILE:PART,PART of one with parts, or "
                 "a series in time of them (.pvd, "
                 ".vti.series …, wave_%04d.vti, 'wave_*.vti'), or abc, tornado, rotation, uniform, gyre (it changes in "
                 "time)[:NX,NY,NZ] on a grid that spans the surface",
                 "abc on a built-in surface, else none: the surface's own vectors"},
          scene.field.spec, anyName);
    visit(Option{field, "precision", "--field-precision", "", "how the field is kept in memory"}, scene.field.precision,
          choice<FieldPrecision>);
    visit(Option{field, "vectors", "--vectors", "NAME|wallShear(NAME)|reversed(NAME)",
                 "vector array to show; without --field one of the surface's points or cells, also turned round; with "
                 "it also the wall shear of one: how much it changes with the distance from the surface",
                 "the file's active vectors, or its only ones"},
          scene.field.vectors, anyName);
    visit(
        Option{field, "offset", "--offset", "auto|LENGTH",
               "where a 3D field is sampled: so far off the surface, world units along its normal, towards the field; "
               "auto: on the surface where there is flow, else where the nearest cells have theirs, as at walls "
               "without slip",
               "auto"},
        scene.field.offset, coordinate.orAuto());
    visit(Option{field, "resampleSpacing", "--resample-spacing", "LENGTH",
                 "cell size a field that is not on a uniform grid is resampled to, world units, instead of being "
                 "sampled in its own cells",
                 "not resampled"},
          scene.field.resampleSpacing, NumberRule{0, largest, true});

    visit(Option{time, "moment", "--time", "T|first|last",
                 "moment shown of data that change, interpolated between their steps; see aeolic info", "first"},
          scene.time.moment, coordinate);
    visit(Option{time, "momentOf", "--time word", "", ""}, scene.time.momentOf, choice<MomentOf>);
    visit(Option{time, "range", "--time-range", "T0,T1",
                 "with --frames: the moments of the first and the last picture; T1 may be earlier",
                 "all pictures show --time"},
          scene.time.range, coordinate);

    visit(Option{lic, "method", "--lic", "", "method"}, scene.lic.method, choice<LicMethod>);
    visit(
        Option{lic, "style", "--style", "",
               "dense: noise all over; oriented: grains drawn out into streaks that grow brighter towards their head, "
               "downstream; they take a sixth of --steps, and no --kernel"},
        scene.lic.style, choice<Style>);
    visit(Option{lic, "integrator", "--integrator", "", "how direct traces"}, scene.lic.integrator, choice<Integrator>);
    visit(Option{lic, "steps", "--steps", "N", "integration steps in each direction"}, scene.lic.steps,
          NumberRule{1, 65536}.usually(1, 1024));
    visit(Option{lic, "step", "--step", "PX",
                 "length of a step, in pixels of an unforeshortened surface at the focal point"},
          scene.lic.step, NumberRule{0, 8, true}.usually(0.1, 8));
    visit(Option{lic, "kernel", "--kernel", "", "weights along the streamline"}, scene.lic.kernel, choice<Kernel>);
    visit(
        Option{lic, "streaks", "--streaks", "",
               "even: noise counts by the width of the stream tube, so that merging flow makes no blotches; plain: all "
               "the same"},
        scene.lic.streaks, choice<Streaks>);
    visit(Option{lic, "phase", "--phase", "RADIANS", "moves the hann kernel along the flow; 6.2832 is a full cycle"},
          scene.lic.phase, angle.usually(0, 2 * std::numbers::pi));
    visit(
        Option{
            lic, "flow", "--flow", "",
            "loop: streaks run along the flow, and after the last picture of the animation, which has 48 unless told "
            "otherwise, comes the first; dense ones with the hann kernel, oriented ones as comets; with "
            "--normalize off they run as fast as the vectors are long"},
        scene.lic.flow, choice<FlowMotion>);
    visit(Option{lic, "normalize", "--normalize", "",
                 "off: steps in proportion to the vectors, the largest taking --step"},
          scene.lic.normalize, SwitchRule{});
    visit(Option{lic, "magnitude", "--magnitude", "",
                 "how streaks tell how fast the flow is; contrast: where it is slow they fade; length: there they are "
                 "shorter, as with --normalize off"},
          scene.lic.magnitude, choice<Magnitude>);
    visit(Option{lic, "noiseScale", "--noise-scale", "S", "noise texels per pixel at the focal point"},
          scene.lic.noiseScale, NumberRule{0.01, 16}.usually(0.05, 8));
    visit(Option{lic, "seed", "--seed", "N", "another number, another noise"}, scene.lic.seed,
          NumberRule{0, 4294967295.0}.usually(1, 9999));

    visit(Option{lic, "maskBelow", "--mask-below", "LENGTH",
                 "no streaks show where the vector is shorter, in its own unit; they stay as they are elsewhere"},
          scene.lic.maskBelow, NumberRule{0, largest});

    visit(
        Option{
            shading, "colorBy", "--color-by", "[surface:|field:]NAME[:PART]",
            "array to colour by. PART of vectors: mag is their length; x, y and z are components; normal and "
            "tangential "
            "are what goes through the surface and what lies in it, of the vectors that the streaks follow. Without a "
            "prefix it is the field's, else the surface's; point: and cell: in front of NAME choose where both have "
            "such an array",
            "a plain surface"},
        scene.shading.colorBy, anyName);
    visit(Option{shading, "colormap", "--colormap", "NAME|FILE", "colours from the low values to the high ones"},
          scene.shading.colormap, NameRule{colorMapNames(), "a file .json, .xml or .csv", isColorMapFile});
    visit(
        Option{shading, "colorRange", "--color-range", "LO,HI|data|robust",
               "values at the ends of the colour map; data: the array's range on the surface; robust: from its 2nd to "
               "its 98th percentile by area",
               "data"},
        scene.shading.colorRange, scalar);
    visit(Option{shading, "colorRangeOf", "--color-range word", "", ""}, scene.shading.colorRangeOf, choice<RangeOf>);
    visit(Option{shading, "colorScale", "--color-scale", "SCALE",
                 "how values are spread over the colour map; bands:N are N equal parts of one colour each"},
          scene.shading.colorScale, NameRule{colorScaleNames, bandsText, isBands, bandsPattern});
    visit(Option{shading, "nanColor", "--nan-color", "RRGGBB", "where the value is not a number, or masked",
                 "what the colour map's file says, else gray"},
          scene.shading.nanColor, opaqueColor);
    visit(Option{shading, "belowColor", "--below-color", "RRGGBB", "values below the range",
                 "what the colour map's file says, else its lowest colour"},
          scene.shading.belowColor, opaqueColor);
    visit(Option{shading, "aboveColor", "--above-color", "RRGGBB", "values above the range",
                 "what the colour map's file says, else its highest colour"},
          scene.shading.aboveColor, opaqueColor);
    visit(Option{shading, "scalarBar", "--scalar-bar", "",
                 "the legend, in a corner where the surface is not; drawn only with --color-by"},
          scene.shading.scalarBar, SwitchRule{});
    visit(Option{shading, "legend", "--legend", "TEXT", "the legend's title, unit included", "the array's name"},
          scene.shading.legend, anyText);
    visit(Option{shading, "title", "--title", "TEXT", "a title above the surface", "none"}, scene.shading.title,
          anyText);
    visit(Option{shading, "axes", "--axes", "", "how x, y and z are turned, in the lower left corner"},
          scene.shading.axes, SwitchRule{});
    visit(Option{shading, "timeStamp", "--time-stamp", "",
                 "the moment shown, in the lower right corner, where data change in time"},
          scene.shading.timeStamp, SwitchRule{});
    visit(Option{shading, "textScale", "--text-scale", "S",
                 "size of legend, title, axes and time, times the usual one, which grows with the picture"},
          scene.shading.textScale, textScale);
    visit(Option{shading, "contrast", "--contrast", "C", "slope of the LIC's tone curve"}, scene.shading.contrast,
          NumberRule{0, 10}.usually(0, 4));
    visit(Option{shading, "blend", "--blend", "B", "0: the lit surface alone, 1: full LIC modulation"},
          scene.shading.blend, NumberRule{0, 1});
    visit(Option{shading, "background", "--background", "RRGGBB|transparent", "what shows beside the surface"},
          scene.shading.background, color);
    visit(Option{shading, "lighting", "--lighting", "",
                 "off, with --blend 1 and no --color-by: the LIC value itself as gray"},
          scene.shading.lighting, SwitchRule{});
    visit(Option{shading, "antialias", "--antialias", "", "smooth silhouettes, creases and lines where surfaces cross"},
          scene.shading.antialias, SwitchRule{});
    visit(Option{shading, "occlusion", "--occlusion", "",
                 "ambient occlusion: corners and hollows are darker; nothing where --lighting is off"},
          scene.shading.occlusion, SwitchRule{});
    visit(
        Option{shading, "overlay", "--overlay", "WHAT[,WHAT ...]",
               "over the streaks; streamlines: evenly spaced lines with arrow heads, as many pixels apart as PX of "
               "streamlines:PX says, else 24; topology: critical points of the flow along the surface, and its lines "
               "of separation and attachment; separation: lines of both kinds that begin at no saddle; edges: the "
               "sides of the triangles, but for those of a few pixels; "
               "outline: silhouettes, creases and borders; through:X:Y:Z: the streamline through the place nearest to "
               "this position"},
        scene.shading.overlay, NameRule{overlayNames, overlayListText, isOverlayList, overlayListPattern});
    visit(Option{shading, "persistence", "--persistence", "SHARE",
                 "pairs of critical points that are closer together than this part of the surface's size are left out, "
                 "as noise makes them"},
          scene.shading.persistence, NumberRule{0, 1}.usually(0, 0.2));

    visit(Option{camera, "azimuth", "--camera azimuth", "", "degrees around the vertical axis"}, scene.camera.azimuth,
          angle);
    visit(Option{camera, "elevation", "--camera elevation", "", "degrees above the horizon"}, scene.camera.elevation,
          angle);
    visit(Option{camera, "roll", "--camera roll", "", "degrees around the line of sight"}, scene.camera.roll, angle);
    visit(Option{camera, "zoom", "--camera zoom", "",
                 "1 shows the whole surface, N an N-th of it; the eye comes closer, but stays outside"},
          scene.camera.zoom, NumberRule{0, 1e6, true});
    visit(Option{camera, "fov", "--camera fov", "", "degrees, vertical; below 1 only with a position"},
          scene.camera.fov, NumberRule{1e-6, 170}.usually(5, 120));
    visit(Option{camera, "position", "--camera position", "", "where the eye is", "where the angles say"},
          scene.camera.position, coordinate);
    visit(Option{camera, "focal", "--camera focal", "", "what the eye looks at; a point anywhere on that line will do",
                 "the middle of the surface"},
          scene.camera.focal, coordinate);
    visit(Option{camera, "up", "--camera up", "", "upward direction of the picture", "z"}, scene.camera.up, coordinate);

    visit(Option{output, "width", "--size width", "", ""}, scene.output.width, side);
    visit(Option{output, "height", "--size height", "", ""}, scene.output.height, side);
    visit(Option{output, "frames", "--frames", "N",
                 "pictures of an animation; more than one: OUT-0000.png, OUT-0001.png …"},
          scene.output.frames, NumberRule{1, 100000});
    visit(Option{output, "fps", "--fps", "N", "pictures a second of an animation in one file"}, scene.output.fps,
          NumberRule{0.1, 240});
    visit(Option{output, "orbit", "--orbit", "DEGREES", "the turn over the whole animation",
                 "360; with --time-range or --flow loop 0"},
          scene.output.orbit, angle);

    visit(Option{machine, "backend", "--backend", "", "auto takes gl only on a real GPU"}, scene.run.backend,
          choice<BackendChoice>);
    visit(Option{machine, "threads", "--threads", "N",
                 "of each rank, at most 8 a core; 0: all cores, shared by the ranks of a host"},
          scene.run.threads, NumberRule{0, 4096});
    visit(Option{machine, "device", "--device", "N", "GPU index; -1: the ranks of a host share its GPUs"},
          scene.run.device, NumberRule{-1, 255});
    visit(Option{ranks, "balance", "--balance", "",
                 "which rows each rank draws: equal, by last frame's times, by this frame's pixels, by pixels and "
                 "speeds"},
          scene.run.balance, choice<Balance>);
    visit(Option{ranks, "bricks", "--bricks", "",
                 "splits the field, or a surface in pieces, among the ranks; auto: when it does not fit one"},
          scene.run.bricks, choice<BrickChoice>);
    visit(Option{ranks, "guard", "--guard", "",
                 "rows needed around a stripe: from the worst case, or from the vectors really there"},
          scene.run.guard, choice<GuardChoice>);
    visit(Option{ranks, "guardRows", "--guard-rows", "",
                 "where they come from: drawn again, from the ranks that own them, or whichever is cheaper"},
          scene.run.guardRows, choice<GuardRowsChoice>);
}

/// The same for every field of one of several surfaces. `key`: what stands for its place in the JSON, "surfaces[1]".
template <class Item, class Visit>
void forEachItemOption(Item&& item, const char* key, Visit&& visit)
{
    using namespace options;
    const OptionGroup group{key, "Data"};
    const auto row = [&](const char* name) { return Option{group, name, "", "", "", ""}; };
    visit(row("spec"), item.spec, someName);
    visit(row("vectors"), item.vectors, anyName);
    visit(row("colorBy"), item.colorBy, anyName);
    visit(row("colormap"), item.colormap, NameRule{colorMapNames(), "a file .json, .xml or .csv", isColorMapFile});
    visit(row("colorRange"), item.colorRange, scalar);
    visit(row("legend"), item.legend, anyText);
    visit(row("streaks"), item.streaks, SwitchRule{});
    visit(row("shown"), item.shown, SwitchRule{});
}

}  // namespace aeolic
