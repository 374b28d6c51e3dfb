#include "cli/scene_options.h"

#include <fmt/format.h>

#include <algorithm>

#include "aeolic/error.h"
#include "description/scene_json.h"
#include "description/scene_text.h"
#include "description/validate.h"
#include "render/colormap.h"

namespace aeolic {

namespace {

/// An option as `--help` shows it. `initial` is the default where the field itself has none to show.
struct OptionHelp {
    const char* option;
    const char* value;
    const char* group;
    std::string text;
    const char* initial = "";
};

std::vector<OptionHelp> optionHelp()
{
    return {
        {"--surface", "SURFACE", "Data",
         "a file (.vtp .vtk .stl .ply .obj .vtm) or a series in time of them, teapot[:TRIANGLES], sphere, torus, plane "
         "or wave (it moves); or cut out of the field's data set: slice:OX,OY,OZ:NX,NY,NZ, isosurface:ARRAY=VALUE, "
         "boundary"},
        {"--field", "FIELD", "Data",
         "a 3D vector field to sample on the surface: a VTK grid file or a series in time of them (.pvd, .vti.series "
         "…, wave_%04d.vti, 'wave_*.vti'), or abc, tornado, rotation, uniform, gyre (it changes in time)[:NX,NY,NZ] on "
         "a grid that spans the surface",
         "abc on a built-in surface, else none: the surface's own vectors"},
        {"--field-precision", "float|half", "Data", "how the field is kept in memory"},
        {"--vectors", "NAME", "Data", "vector array to show; without --field one of the surface's points or cells",
         "the file's active vectors, or its only ones"},
        {"--resample-spacing", "LENGTH", "Data",
         "cell size a field that is not on a uniform grid is resampled to, world units", "about its mean cell size"},
        {"--feature-angle", "DEGREES", "Data",
         "edges sharper than this stay sharp when normals are computed, 0 to 180"},

        {"--time", "T", "Time", "moment shown of data that change, interpolated between their steps; see aeolic info",
         "the first"},
        {"--times", "T0,T1", "Time", "with --frames: the moments of the first and the last picture; T1 may be earlier",
         "all pictures show --time"},

        {"--lic", "none|direct|hierarchical", "Line integral convolution", "method"},
        {"--integrator", "euler|rk2|rk4", "Line integral convolution", "how direct traces"},
        {"--steps", "N", "Line integral convolution", "integration steps in each direction, 1 to 65536"},
        {"--step", "PX", "Line integral convolution",
         "length of a step, in pixels of an unforeshortened surface at the focal point, up to 8"},
        {"--kernel", "box|hann", "Line integral convolution", "weights along the streamline"},
        {"--phase", "RADIANS", "Line integral convolution",
         "moves the hann kernel along the flow; 6.2832 is a full cycle"},
        {"--normalize", "on|off", "Line integral convolution",
         "off: steps in proportion to the vectors, the largest taking --step"},
        {"--noise-scale", "S", "Line integral convolution", "noise texels per pixel at the focal point, 0.01 to 16"},
        {"--seed", "N", "Line integral convolution", "another number, another noise"},

        {"--color-by", "NAME", "Colours and light", "scalar array to colour by, or NAME:mag for a vector's length",
         "a plain surface"},
        {"--colormap", "NAME", "Colours and light", fmt::format("{}", fmt::join(colorMapNames(), ", "))},
        {"--color-range", "LO,HI", "Colours and light", "values at the ends of the colour map",
         "the array's range on the surface"},
        {"--scalar-bar", "on|off", "Colours and light", "the colour legend; drawn only with --color-by"},
        {"--contrast", "C", "Colours and light", "slope of the LIC's tone curve, 0 to 10"},
        {"--blend", "B", "Colours and light", "0: the lit surface alone, 1: full LIC modulation"},
        {"--background", "RRGGBB|transparent", "Colours and light", "what shows beside the surface"},
        {"--lighting", "on|off", "Colours and light",
         "off, with --blend 1 and no --color-by: the LIC value itself as gray"},

        {"--size", "WxH", "View", "the picture in pixels, up to 32768 each", "800x800"},
        {"--camera", "ITEMS", "View",
         "azimuth=,elevation=,roll= (degrees), zoom= relative to a view of the whole surface; or "
         "position=X,Y,Z;focal=X,Y,Z;"
         "up=X,Y,Z; and fov= (degrees, vertical)",
         "azimuth=30,elevation=20,roll=0,zoom=1,fov=30"},
        {"--frames", "N", "View", "pictures of an animation, 1 to 100000; more than one: OUT-0000.png, OUT-0001.png …"},
        {"--orbit", "DEGREES", "View", "the turn over the whole animation", "360; with --times 0"},

        {"--backend", "auto|cpu|gl", "Machine", "auto takes gl only on a real GPU"},
        {"--threads", "N", "Machine", "of each rank; 0: all cores, shared by the ranks of a host"},
        {"--device", "N", "Machine", "GPU index; -1: the ranks of a host share its GPUs"},

        {"--balance", "static|timing|pixels|hybrid",
         "Several ranks (mpirun -n N aeolic ...); never changes the picture",
         "which rows each rank draws: equal, by last frame's times, by this frame's pixels, by pixels and speeds"},
        {"--bricks", "on|off|auto", "Several ranks (mpirun -n N aeolic ...); never changes the picture",
         "splits the field, or a surface in pieces, among the ranks; auto: when it does not fit one"},
        {"--guard", "bound|estimate", "Several ranks (mpirun -n N aeolic ...); never changes the picture",
         "rows needed around a stripe: from the worst case, or from the vectors really there"},
        {"--guard-rows", "project|receive|auto", "Several ranks (mpirun -n N aeolic ...); never changes the picture",
         "where they come from: drawn again, from the ranks that own them, or whichever is cheaper"},
    };
}

/// The text in lines that stay beside CLI11's column of names.
std::string wrapped(const std::string& text)
{
    constexpr std::size_t widest = 84;
    std::string lines;
    std::size_t lineStart = 0;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t space = std::min(text.find(' ', at + 1), text.size());
        if (lines.size() - lineStart + (space - at) > widest) {
            lines += '\n';
            lineStart = lines.size();
            ++at;  // The line break stands for the space.
        }
        lines += text.substr(at, space - at);
        at = space;
    }
    return lines;
}

void applyOption(SceneDescription& scene, const std::string& option, const std::string& text)
{
    if (option == "--size")
        setSize(scene, text);
    else if (option == "--camera")
        setCamera(scene, text);
    else
        setField(scene, option, text);
}

}  // namespace

SceneOptions::SceneOptions(CLI::App& command)
{
    command.add_option("SCENE.json", sceneFile_, "a scene file; the options override what it says")->type_name("");
    const SceneDescription defaults;
    for (const OptionHelp& help : optionHelp()) {
        std::string initial = help.initial[0] ? help.initial : fieldText(defaults, help.option);
        const std::string option = help.option;
        command
            .add_option_function<std::string>(
                option, [this, option](const std::string& text) { given_[option] = text; },
                wrapped(fmt::format("{} [{}]", help.text, initial)))
            ->type_name(help.value)
            ->group(help.group)
            ->take_last();
    }
}

SceneDescription SceneOptions::scene() const
{
    if (!sceneFile_.empty() && !sceneFile_.ends_with(".json"))
        throw InputError(sceneFile_, "not a scene file",
                         "a .json file; a surface or a field is given with --surface or --field");
    SceneDescription scene = sceneFile_.empty() ? SceneDescription{} : readSceneFile(sceneFile_);
    // What was typed wins over the file; of both typed validate() says that they do not go together.
    if (given_.contains("--time") && !given_.contains("--times")) scene.time.range.reset();
    if (given_.contains("--times") && !given_.contains("--time")) scene.time.moment.reset();
    for (const auto& [option, text] : given_) applyOption(scene, option, text);
    validate(scene, optionName);
    chooseDefaultField(scene);
    return scene;
}

}  // namespace aeolic
