#include "output/streamline_files.h"

#include <fmt/format.h>

#include <cstdint>
#include <vector>

#include "output/polydata_text.h"

namespace aeolic {

std::string streamlinesVtp(const EvenSurfaceLines& lines)
{
    SurfacePolydata data;
    std::vector<double> lengths;
    std::vector<std::int64_t> closed;
    for (const SurfaceStreamline& line : lines.lines) {
        data.addLine(line.places);
        lengths.push_back(line.length);
        closed.push_back(line.closed ? 1 : 0);
    }
    data.addWhole("closed", closed);
    data.addNumbers("length", lengths);
    return data.text(lines.scalar);
}

std::string streamlinesCsv(const EvenSurfaceLines& lines)
{
    std::string text = "line,length,closed" + csvPlaceNames(lines.scalar) + "\n";
    for (std::size_t i = 0; i < lines.lines.size(); ++i) {
        const SurfaceStreamline& line = lines.lines[i];
        for (const SurfaceValues& place : line.places)
            text += fmt::format("{},{},{}{}\n", i, line.length, line.closed ? 1 : 0,
                                csvPlace(place, !lines.scalar.empty()));
    }
    return text;
}

}  // namespace aeolic
