#include "data/parts/open_parts.h"

#include "data/cgns/cgns_parts.h"
#include "data/ensight/ensight_parts.h"
#include "data/exodus/exodus_parts.h"
#include "data/fluent/fluent_parts.h"
#include "data/tecplot/tecplot_parts.h"

namespace aeolic {
namespace {

struct Opener {
    const char* extension;
    std::unique_ptr<PartSource> (*open)(const std::string& path, std::optional<double> time);
};

constexpr Opener openers[] = {{".case", openEnSightCase}, {".encas", openEnSightCase}, {".cgns", openCgnsFile},
                              {".e", openExodusFile},     {".exo", openExodusFile},    {".ex2", openExodusFile},
                              {".exii", openExodusFile},  {".tec", openTecplotFile},   {".dat", openTecplotFile},
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
