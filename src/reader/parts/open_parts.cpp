#include "reader/parts/open_parts.h"

#include "reader/ensight/ensight_parts.h"
#include "reader/fluent/fluent_parts.h"
#include "reader/tecplot/tecplot_parts.h"
#include "reader/vtk/modules/modules.h"

namespace aeolic {
namespace {

struct Opener {
    const char* extension;
    std::unique_ptr<PartSource> (*open)(const std::string& path, std::optional<double> time);
};

std::unique_ptr<PartSource> openCgns(const std::string& path, std::optional<double> time)
{
    return hdf5Module().openCgns(path, time);
}

std::unique_ptr<PartSource> openExodus(const std::string& path, std::optional<double> time)
{
    return hdf5Module().openExodus(path, time);
}

constexpr Opener openers[] = {{".case", openEnSightCase}, {".encas", openEnSightCase}, {".cgns", openCgns},
                              {".e", openExodus},         {".exo", openExodus},        {".ex2", openExodus},
                              {".exii", openExodus},      {".tec", openTecplotFile},   {".dat", openTecplotFile},
                              {".cas", openFluentFile},   {".msh", openFluentFile}};

}  // namespace

std::unique_ptr<PartSource> openPartSource(const std::string& path, const std::string& extension,
                                           std::optional<double> time)
{
    for (const Opener& opener : openers)
        if (extension == opener.extension) return opener.open(path, time);
    return nullptr;
}

}  // namespace aeolic
