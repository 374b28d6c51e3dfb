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

/// What the file says of itself before any value of it is read: the answer to an OpenRequest.
struct FileFacts {
    std::string kind;
    bool announcesArrays = false;
    bool readsFloats = false;       ///< Values are made floats when they are read.
    bool arraysByParts = false;     ///< Which arrays there are depends on the parts: an ArraysRequest tells.
    std::vector<ArrayInfo> arrays;  ///< Where they are announced and do not depend on the parts.
    std::vector<PartInfo> parts;
    std::vector<double> timeSteps;
    std::optional<std::array<int, 6>> wholeExtent;  ///< Of an image.
    glm::dvec3 spacingWorld{1};                     ///< Likewise.
};

/// Which parts are meant (PacketKind::arrays). The answer is their arrays.
struct ArraysRequest {
    std::vector<std::string> parts;
    std::vector<std::string> atTime;  ///< Arrays that it must have at the time that is read, if it has them at any.
};

/// What is to be read (PacketKind::read).
struct ReadRequest {
    std::vector<std::string> parts;
    std::optional<std::vector<ArrayInfo>> arrays;  ///< None: all.
    bool polyhedra = false;                        ///< Whole, not cut into simpler cells.
    std::optional<PieceRun> pieces;                ///< Only these of its pieces.
    std::optional<std::array<int, 6>> extent;      ///< Only these samples of an image.
};

void add(ByteWriter& message, const OpenRequest& request);
void add(ByteWriter& message, const FileFacts& facts);
void add(ByteWriter& message, const ArraysRequest& request);
void add(ByteWriter& message, const ReadRequest& request);
void add(ByteWriter& message, const std::vector<ArrayInfo>& arrays);
void read(ByteReader& message, OpenRequest& request);
void read(ByteReader& message, FileFacts& facts);
void read(ByteReader& message, ArraysRequest& request);
void read(ByteReader& message, ReadRequest& request);
void read(ByteReader& message, std::vector<ArrayInfo>& arrays);

}  // namespace aeolic
