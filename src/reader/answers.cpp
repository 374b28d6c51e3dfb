#include "reader/answers.h"

#include <algorithm>

#include "base/text.h"
#include "data/named_file.h"
#include "data/reading/message_parts.h"
#include "data/reading/packet_socket.h"
#include "reader/ensight/ensight_case.h"
#include "reader/openfoam/foam_surface.h"
#include "reader/series_json.h"
#include "reader/vtk/color_map_xml.h"
#include "reader/vtk/file_checks.h"
#include "reader/vtk/foam_patches.h"
#include "reader/vtk/pvd_file.h"
#include "reader/vtk/summarize.h"
#include "reader/vtk/surface_header.h"

namespace aeolic {
namespace {

std::vector<std::uint64_t> bytesOfPieces(const std::string& path)
{
    if (namesFoamCase(path)) return std::vector<std::uint64_t>(findFoamCase(path).folders.size(), 1);
    checkReadableFile(path);
    std::vector<std::uint64_t> bytes;
    for (const std::string& piece : pieceFilesOf(path)) bytes.push_back(checkReadableFile(piece));
    return bytes;
}

bool isOneRegion(const std::string& path, const std::vector<std::string>& parts)
{
    const FoamCase foam = findFoamCase(path);
    const auto chosen = chooseFoamParts(foam, foamParts(foam, firstFoamTime(foam)), parts);
    return std::all_of(chosen.begin(), chosen.end(),
                       [&](const FoamPart& part) { return part.region == chosen.front().region; });
}

}  // namespace

void addAnswer(ByteWriter& message, const LookRequest& request, const ProgressReport& progress)
{
    const std::string& path = request.path;
    switch (request.question) {
        case Question::listedFiles:
            checkReadableFile(path);
            return add(message, lowerExtension(path) == ".pvd" ? readPvdFile(path) : readSeriesFile(path));
        case Question::timesOfCase:
            // Even where the folder's name ends like an EnSight case.
            if (namesFoamCase(path)) return message.add(findFoamCase(path).times);
            checkReadableFile(path);
            return message.add(readEnSightCase(path).times());
        case Question::firstStep:
            return message.add(std::uint64_t(firstFoamStepWith(findFoamCase(path), request.words)));
        case Question::pieces:
            return message.add(bytesOfPieces(path));
        case Question::isOneRegion:
            return message.add(std::uint8_t(isOneRegion(path, request.words)));
        case Question::surfaceCounts:
            return addMaybe(message, countsInHeader(path));
        case Question::summary:
            return add(message, summaryOf(path, progress));
        case Question::colorPoints:
            return add(message, colorPointsInXml(request.words.at(0), path));
    }
    throw LostPeer();
}

}  // namespace aeolic
