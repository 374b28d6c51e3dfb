#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/byte_message.h"
#include "data/color_map/color_points.h"
#include "data/file_summary.h"
#include "data/series_entry.h"
#include "description/file_kinds.h"

namespace aeolic {

/// What a caller asks of a file that it need not open for it (PacketKind::look).
enum class Question : std::uint8_t {
    listedFiles = 1,  ///< Of a .pvd or .series: list of SeriesEntry.
    timesOfCase,      ///< `words`: arrays that the times must have, if any has them. List of double.
    pieces,           ///< `words`: parts that are meant. Bytes of each of its pieces: list of std::uint64_t.
    surfaceCounts,    ///< SurfaceCounts, or none.
    summary,          ///< FileSummary.
    colorPoints,      ///< `words`: the text of ParaView's XML, read already. ColorPoints.
};

struct LookRequest {
    std::string folder;  ///< That relative names start from.
    std::string path;
    Question question{};
    FileUse use = FileUse::any;  ///< What the answer is for.
    std::vector<std::string> words;
};

template <PerhapsConst<LookRequest> Request, class Visit>
void withMembers(Request& request, const Visit& visit)
{
    visit(request.folder, request.path, request.question, request.use, request.words);
}

/// How many points and polygons a file says it has. A polygon becomes one triangle or more, and points that no polygon
/// uses are left out later.
struct SurfaceCounts {
    std::uint64_t points = 0;  ///< 0: not told.
    std::uint64_t polygons = 0;
};

}  // namespace aeolic
