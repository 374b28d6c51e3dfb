#include "cluster/composite/triangle_messages.h"

#include <cstring>
#include <stdexcept>
#include <string>

#include "cluster/composite/pixel_messages.h"

namespace aeolic {
namespace {

using Indices = std::vector<std::uint32_t>;

/// Calls visit(array) for every array that has a value for each point.
template <class Mesh, class Visit>
void forEachPointArray(Mesh& mesh, const Visit& visit)
{
    visit(mesh.positions);
    visit(mesh.normals);
    visit(mesh.pointVectors);
    visit(mesh.pointScalars);
}

/// Appends how many values an array has at `ids`, and these values.
template <class Value>
void appendValues(Bytes& bytes, const std::vector<Value>& values, const Indices& ids)
{
    const std::uint64_t count = values.empty() ? 0 : ids.size();
    appendBytes(bytes, &count, 1);
    for (std::size_t i = 0; i < count; ++i) appendBytes(bytes, &values[ids[i]], 1);
}

/// Reads an array of a message, behind the values that are there.
template <class Value>
void takeValues(PixelReader& reader, std::vector<Value>& values)
{
    std::uint64_t count = 0;
    reader.read(&count, sizeof count);
    const std::byte* from = reader.skip(std::size_t(count) * sizeof(Value));
    const std::size_t before = values.size();
    values.resize(before + std::size_t(count));
    if (count > 0) std::memcpy(values.data() + before, from, std::size_t(count) * sizeof(Value));
}

/// Throws unless this rank's piece has the same arrays as those before, or nothing.
void requireComplete(const SurfaceMesh& mesh, int sender)
{
    const auto check = [&](std::size_t size, std::size_t all) {
        if (size != 0 && size != all)
            throw std::runtime_error("rank " + std::to_string(sender) +
                                     "'s piece of the surface has other arrays than those before");
    };
    forEachPointArray(mesh, [&](const auto& values) { check(values.size(), mesh.positions.size()); });
    forEachTriangleArray(mesh, [&](const auto& values) { check(values.size(), mesh.triangles.size()); });
}

}  // namespace

Bytes triangleMessage(const SurfaceMesh& mesh, const Indices& triangles, const Indices& points)
{
    Bytes bytes;
    if (triangles.empty() && points.empty()) return bytes;
    std::vector<std::uint32_t> number(mesh.positions.size(), 0);  // 1: the point travels.
    for (const std::uint32_t point : points) number[point] = 1;
    for (const std::uint32_t triangle : triangles)
        for (const std::uint32_t corner : mesh.triangles[triangle]) number[corner] = 1;
    Indices travelling;
    for (std::uint32_t point = 0; point < number.size(); ++point) {
        if (number[point] == 0) continue;
        number[point] = std::uint32_t(travelling.size());
        travelling.push_back(point);
    }
    const std::uint64_t count = triangles.size();
    appendBytes(bytes, &count, 1);
    for (const std::uint32_t triangle : triangles) {
        auto corners = mesh.triangles[triangle];
        for (std::uint32_t& corner : corners) corner = number[corner];
        appendBytes(bytes, corners.data(), corners.size());
    }
    forEachPointArray(mesh, [&](const auto& values) { appendValues(bytes, values, travelling); });
    forEachTriangleArray(mesh, [&](const auto& values) { appendValues(bytes, values, triangles); });
    return bytes;
}

void takeTriangles(const Message& message, SurfaceMesh& mesh)
{
    PixelReader reader(message.bytes, message.rank);
    const std::size_t triangles = mesh.triangles.size();
    const auto points = std::uint32_t(mesh.positions.size());
    takeValues(reader, mesh.triangles);
    forEachPointArray(mesh, [&](auto& values) { takeValues(reader, values); });
    forEachTriangleArray(mesh, [&](auto& values) { takeValues(reader, values); });
    reader.requireEnd();
    const std::size_t come = mesh.positions.size() - points;
    for (std::size_t i = triangles; i < mesh.triangles.size(); ++i)
        for (std::uint32_t& corner : mesh.triangles[i]) {
            if (corner >= come)
                throw std::runtime_error("rank " + std::to_string(message.rank) +
                                         "'s triangles refer to points that have not come");
            corner += points;
        }
    requireComplete(mesh, message.rank);
}

}  // namespace aeolic
