#include "data/reading/questions.h"

#include "data/reading/message_parts.h"

namespace aeolic {

namespace {

void add(ByteWriter& message, const ArraySummary& array)
{
    message.addAll(array.name, array.association, array.type, array.components);
    addMaybe(message, array.range);
    message.addAll(array.masked, array.nonFinite, std::uint8_t(array.active), array.times);
}

void read(ByteReader& message, ArraySummary& array)
{
    message.readAll(array.name, array.association, array.type, array.components);
    readMaybe(message, array.range);
    message.readAll(array.masked, array.nonFinite);
    readFlag(message, array.active);
    message.read(array.times);
}

void add(ByteWriter& message, const PartSummary& part)
{
    message.addAll(part.name, part.type, part.groups, part.polygons, std::uint8_t(part.fillsSpace),
                   std::uint8_t(part.usual));
    addMaybe(message, part.sideAcross);
}

void read(ByteReader& message, PartSummary& part)
{
    message.readAll(part.name, part.type, part.groups, part.polygons);
    readFlag(message, part.fillsSpace);
    readFlag(message, part.usual);
    readMaybe(message, part.sideAcross);
    if (part.sideAcross && (*part.sideAcross < 0 || *part.sideAcross > 2)) throw std::runtime_error("no such axis");
}

}  // namespace

void add(ByteWriter& message, const LookRequest& request)
{
    message.addAll(request.folder, request.path, request.question, request.use, request.words);
}

void read(ByteReader& message, LookRequest& request)
{
    message.readAll(request.folder, request.path, request.question, request.use, request.words);
}

void add(ByteWriter& message, const std::vector<SeriesEntry>& entries)
{
    message.add(std::uint64_t(entries.size()));
    for (const SeriesEntry& entry : entries) message.addAll(entry.file, entry.time, entry.part);
}

void read(ByteReader& message, std::vector<SeriesEntry>& entries)
{
    for (std::uint64_t left = readCount(message); left > 0; --left) {
        SeriesEntry& entry = entries.emplace_back();
        message.readAll(entry.file, entry.time, entry.part);
    }
}

void add(ByteWriter& message, const FileSummary& summary)
{
    message.addAll(summary.kind, summary.dimension, summary.points, summary.cells, summary.blocks, summary.boundsWorld,
                   summary.timeSteps, summary.firstVectors);
    for (const bool flag : {summary.isSurface, summary.isOfFaces, summary.namesFiles, summary.isVolume})
        message.add(std::uint8_t(flag));
    addMaybe(message, summary.dims);
    addMaybe(message, summary.spacingWorld);
    addMaybe(message, summary.originWorld);
    addMaybe(message, summary.vectors);
    message.add(std::uint64_t(summary.parts.size()));
    for (const PartSummary& part : summary.parts) add(message, part);
    message.add(std::uint64_t(summary.arrays.size()));
    for (const ArraySummary& array : summary.arrays) add(message, array);
}

void read(ByteReader& message, FileSummary& summary)
{
    message.readAll(summary.kind, summary.dimension, summary.points, summary.cells, summary.blocks, summary.boundsWorld,
                    summary.timeSteps, summary.firstVectors);
    for (bool* flag : {&summary.isSurface, &summary.isOfFaces, &summary.namesFiles, &summary.isVolume})
        readFlag(message, *flag);
    readMaybe(message, summary.dims);
    readMaybe(message, summary.spacingWorld);
    readMaybe(message, summary.originWorld);
    readMaybe(message, summary.vectors);
    for (std::uint64_t left = readCount(message); left > 0; --left) read(message, summary.parts.emplace_back());
    for (std::uint64_t left = readCount(message); left > 0; --left) read(message, summary.arrays.emplace_back());
}

void add(ByteWriter& message, const ColorPoints& points)
{
    message.addAll(points.points, points.space);
    for (const auto* color : {&points.nan, &points.below, &points.above}) addMaybe(message, *color);
}

void read(ByteReader& message, ColorPoints& points)
{
    message.readAll(points.points, points.space);
    if (points.space > ColorSpace::diverging) throw std::runtime_error("no such space of colours");
    for (auto* color : {&points.nan, &points.below, &points.above}) readMaybe(message, *color);
}

}  // namespace aeolic
