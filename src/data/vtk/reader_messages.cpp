#include "data/vtk/reader_messages.h"

#include "data/reading/message_parts.h"

namespace aeolic {

void add(ByteWriter& message, const OpenRequest& request)
{
    message.addAll(request.folder, request.path, request.use);
    addMaybe(message, request.time);
}

void read(ByteReader& message, OpenRequest& request)
{
    message.readAll(request.folder, request.path, request.use);
    readMaybe(message, request.time);
}

void add(ByteWriter& message, const std::vector<ArrayInfo>& arrays)
{
    message.add(std::uint64_t(arrays.size()));
    for (const ArrayInfo& array : arrays)
        message.addAll(array.name, std::uint8_t(array.onPoints), array.components, array.vtkType,
                       std::uint8_t(array.activeVectors), std::uint8_t(array.activeNormals));
}

void read(ByteReader& message, std::vector<ArrayInfo>& arrays)
{
    for (std::uint64_t left = readCount(message); left > 0; --left) {
        ArrayInfo& array = arrays.emplace_back();
        message.read(array.name);
        readFlag(message, array.onPoints);
        message.readAll(array.components, array.vtkType);
        readFlag(message, array.activeVectors);
        readFlag(message, array.activeNormals);
    }
}

void add(ByteWriter& message, const FileFacts& facts)
{
    message.addAll(facts.kind, std::uint8_t(facts.announcesArrays), std::uint8_t(facts.readsFloats),
                   std::uint8_t(facts.arraysByParts));
    add(message, facts.arrays);
    message.add(std::uint64_t(facts.parts.size()));
    for (const PartInfo& part : facts.parts)
        message.addAll(part.name, part.type, part.groups, part.dimension, std::uint8_t(part.usual),
                       std::uint8_t(part.derived));
    message.add(facts.timeSteps);
    addMaybe(message, facts.wholeExtent);
    message.add(facts.spacingWorld);
}

void read(ByteReader& message, FileFacts& facts)
{
    message.read(facts.kind);
    for (bool* flag : {&facts.announcesArrays, &facts.readsFloats, &facts.arraysByParts}) readFlag(message, *flag);
    read(message, facts.arrays);
    for (std::uint64_t left = readCount(message); left > 0; --left) {
        PartInfo& part = facts.parts.emplace_back();
        message.readAll(part.name, part.type, part.groups, part.dimension);
        readFlag(message, part.usual);
        readFlag(message, part.derived);
    }
    message.read(facts.timeSteps);
    readMaybe(message, facts.wholeExtent);
    message.read(facts.spacingWorld);
}

void add(ByteWriter& message, const ArraysRequest& request)
{
    message.addAll(request.parts, request.atTime);
}

void read(ByteReader& message, ArraysRequest& request)
{
    message.readAll(request.parts, request.atTime);
}

void add(ByteWriter& message, const ReadRequest& request)
{
    message.add(request.parts);
    message.add(std::uint8_t(request.arrays.has_value()));
    if (request.arrays) add(message, *request.arrays);
    message.add(std::uint8_t(request.polyhedra));
    addMaybe(message, request.pieces);
    addMaybe(message, request.extent);
}

void read(ByteReader& message, ReadRequest& request)
{
    message.read(request.parts);
    bool some = false;
    readFlag(message, some);
    if (some) read(message, request.arrays.emplace());
    readFlag(message, request.polyhedra);
    readMaybe(message, request.pieces);
    readMaybe(message, request.extent);
}

}  // namespace aeolic
