#pragma once

#include <array>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "base/byte_message.h"
#include "data/part_info.h"
#include "data/piece_run.h"
#include "data/vtk/arrays.h"
#include "description/file_kinds.h"

namespace aeolic {

/// Which file is to be opened (PacketKind::open).
struct OpenRequest {
    std::string folder;  ///< That relative names start from.
    std::string path;
    FileUse use = FileUse::any;
    std::optional<double> time;  ///< One of its times; none: the first.
};

template <PerhapsConst<OpenRequest> Request, class Visit>
void withMembers(Request& request, const Visit& visit)
{
    visit(request.folder, request.path, request.use, request.time);
}

/// What the file says of itself before any value of it is read: the answer to an OpenRequest.
struct FileFacts {
    bool announcesArrays = false;
    bool arraysByParts = false;     ///< Which arrays there are depends on the parts: an ArraysRequest tells.
    std::vector<ArrayInfo> arrays;  ///< Where they are announced and do not depend on the parts.
    std::vector<PartInfo> parts;
    std::vector<double> timeSteps;
    std::optional<std::array<int, 6>> wholeExtent;  ///< Of an image.
    glm::dvec3 spacingWorld{1};                     ///< Likewise.
};

template <PerhapsConst<FileFacts> Facts, class Visit>
void withMembers(Facts& facts, const Visit& visit)
{
    visit(facts.announcesArrays, facts.arraysByParts, facts.arrays, facts.parts, facts.timeSteps, facts.wholeExtent,
          facts.spacingWorld);
}

/// Which parts are meant (PacketKind::arrays). The answer is their arrays.
struct ArraysRequest {
    std::vector<std::string> parts;
    std::vector<std::string> atTime;  ///< Arrays that it must have at the time that is read, if it has them at any.
};

template <PerhapsConst<ArraysRequest> Request, class Visit>
void withMembers(Request& request, const Visit& visit)
{
    visit(request.parts, request.atTime);
}

/// What is to be read (PacketKind::read).
struct ReadRequest {
    std::vector<std::string> parts;
    std::optional<std::vector<ArrayInfo>> arrays;  ///< None: all.
    bool polyhedra = false;                        ///< Whole, not cut into simpler cells.
    std::optional<PieceRun> pieces;                ///< Only these of its pieces.
    std::optional<std::array<int, 6>> extent;      ///< Only these samples of an image.
};

template <PerhapsConst<ReadRequest> Request, class Visit>
void withMembers(Request& request, const Visit& visit)
{
    visit(request.parts, request.arrays, request.polyhedra, request.pieces, request.extent);
}

}  // namespace aeolic
