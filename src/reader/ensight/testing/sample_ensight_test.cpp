#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <numeric>

#include "data/vtk/testing/sample_files.h"
#include "reader/ensight/testing/sample_ensight.h"

namespace aeolic::test {
namespace {

constexpr std::size_t kRecord = 80;

template <class Get>
auto column(const SamplePart& part, const Get& get)
{
    std::vector<float> values;
    for (const glm::vec3& point : part.points) values.push_back(get(point));
    return values;
}

std::vector<int> numbersTo(std::size_t count)
{
    std::vector<int> numbers(count);
    for (std::size_t i = 0; i < count; ++i) numbers[i] = int(i) + 1;
    return numbers;
}

void writeElements(EnSightBytes& out, const SampleElements& elements, bool ids)
{
    out.text(elements.kind).whole({int(elements.cells.size())});
    if (ids) out.whole(numbersTo(elements.cells.size()));
    std::vector<int> sizes, faces, corners;
    const bool polyhedra = std::string(elements.kind) == "nfaced";
    for (const std::vector<int>& cell : elements.cells) {
        if (!polyhedra) {
            sizes.push_back(int(cell.size()));
            corners.insert(corners.end(), cell.begin(), cell.end());
            continue;
        }
        sizes.push_back(0);
        for (std::size_t at = 0; at < cell.size(); at += 1 + std::size_t(cell[at])) {
            ++sizes.back();
            faces.push_back(cell[at]);
            corners.insert(corners.end(), cell.begin() + std::ptrdiff_t(at) + 1,
                           cell.begin() + std::ptrdiff_t(at) + 1 + cell[at]);
        }
    }
    if (polyhedra || std::string(elements.kind) == "nsided") out.whole(sizes);
    if (polyhedra) out.whole(faces);
    out.whole(corners);
}

void writePart(EnSightBytes& out, int number, const SamplePart& part, bool ids)
{
    out.text("part").whole({number}).text(part.name).text("coordinates").whole({int(part.points.size())});
    if (ids) out.whole(numbersTo(part.points.size()));
    for (int axis = 0; axis < 3; ++axis) out.reals(column(part, [&](const glm::vec3& p) { return p[axis]; }));
    for (const SampleElements& elements : part.elements) writeElements(out, elements, ids);
}

/// The points of blocks: a bent slab of 3 x 1 x 4, and a cube of 3 x 3 x 3.
SamplePart slabPoints()
{
    SamplePart slab{"slab", {}, {}};
    for (int k = 0; k < 4; ++k)
        for (int i = 0; i < 3; ++i) slab.points.emplace_back(i, -2.0F - 0.1F * float(i * k), k);
    return slab;
}

SamplePart cubePoints()
{
    SamplePart cube{"cube", {}, {}};
    for (int k = 0; k < 3; ++k)
        for (int j = 0; j < 3; ++j)
            for (int i = 0; i < 3; ++i) cube.points.emplace_back(20 + i, j, k);
    return cube;
}

void writeBlocks(EnSightBytes& out, int number)
{
    const SamplePart slab = slabPoints();
    out.text("part").whole({number}).text("slab").text("block curvilinear").whole({3, 1, 4});
    for (int axis = 0; axis < 3; ++axis) out.reals(column(slab, [&](const glm::vec3& p) { return p[axis]; }));
    out.text("part").whole({number + 1}).text("cube").text("block uniform").whole({3, 3, 3});
    out.reals({20, 0, 0}).reals({1, 1, 1});
}

void writeNodes(EnSightBytes& vectors, EnSightBytes& scalars, const SamplePart& part, int step, bool block, bool undef)
{
    const std::string where = block ? "block" : "coordinates";
    vectors.text(where);
    for (int axis = 0; axis < 3; ++axis)
        vectors.reals(column(part, [&](const glm::vec3& p) { return sampleFlow(p, step)[axis]; }));
    std::vector<float> q = column(part, [](const glm::vec3& p) { return p.x + 10 * p.y; });
    if (undef) q[0] = -999;
    scalars.text(undef ? where + " undef" : where);
    if (undef) scalars.reals({-999});
    scalars.reals(q);
}

void writeCells(EnSightBytes& out, const std::string& kind, std::size_t count, bool partial)
{
    std::vector<float> numbers(count);
    for (std::size_t i = 0; i < count; ++i) numbers[i] = float(i);
    if (partial)
        out.text(kind + " partial").whole({1}).whole({2}).reals({1});
    else
        out.text(kind).reals(numbers);
}

}  // namespace

void EnSightBytes::word(std::uint32_t bits)
{
    if (format_.swapped) bits = __builtin_bswap32(bits);
    bytes_.append(reinterpret_cast<const char*>(&bits), 4);
}

void EnSightBytes::record(const void* data, std::size_t size)
{
    const bool fortran = format_.encoding == EnSightEncoding::fortran;
    if (fortran) word(std::uint32_t(size));
    bytes_.append(static_cast<const char*>(data), size);
    if (fortran) word(std::uint32_t(size));
}

EnSightBytes& EnSightBytes::text(const std::string& line)
{
    if (format_.encoding == EnSightEncoding::ascii) {
        bytes_ += line + "\n";
        return *this;
    }
    std::string padded = line;
    padded.resize(kRecord, ' ');
    record(padded.data(), kRecord);
    return *this;
}

EnSightBytes& EnSightBytes::whole(const std::vector<int>& values)
{
    std::string packed;
    for (const int value : values) {
        char digits[16];
        std::snprintf(digits, sizeof digits, "%10d\n", value);
        const std::uint32_t bits = format_.swapped ? __builtin_bswap32(std::uint32_t(value)) : std::uint32_t(value);
        if (format_.encoding == EnSightEncoding::ascii)
            bytes_ += digits;
        else
            packed.append(reinterpret_cast<const char*>(&bits), 4);
    }
    if (format_.encoding != EnSightEncoding::ascii) record(packed.data(), packed.size());
    return *this;
}

EnSightBytes& EnSightBytes::reals(const std::vector<float>& values)
{
    std::string packed;
    for (const float value : values) {
        char digits[32];
        std::snprintf(digits, sizeof digits, "%16.9e\n", double(value));  // So many that no bit is lost.
        std::uint32_t bits = 0;
        std::memcpy(&bits, &value, 4);
        if (format_.swapped) bits = __builtin_bswap32(bits);
        if (format_.encoding == EnSightEncoding::ascii)
            bytes_ += digits;
        else
            packed.append(reinterpret_cast<const char*>(&bits), 4);
    }
    if (format_.encoding != EnSightEncoding::ascii) record(packed.data(), packed.size());
    return *this;
}

SamplePart sampleFluid()
{
    constexpr int n = kSampleCells;
    SamplePart part{"fluid", {}, {{"hexa8", {}}}};
    const auto at = [](int i, int j, int k) { return 1 + i + (n + 1) * (j + (n + 1) * k); };
    for (int k = 0; k <= n; ++k)
        for (int j = 0; j <= n; ++j)
            for (int i = 0; i <= n; ++i) part.points.emplace_back(i, j, k);
    for (int k = 0; k < n; ++k)
        for (int j = 0; j < n; ++j)
            for (int i = 0; i < n; ++i)
                part.elements[0].cells.push_back({at(i, j, k), at(i + 1, j, k), at(i + 1, j + 1, k), at(i, j + 1, k),
                                                  at(i, j, k + 1), at(i + 1, j, k + 1), at(i + 1, j + 1, k + 1),
                                                  at(i, j + 1, k + 1)});
    return part;
}

SamplePart sampleWalls()
{
    constexpr int n = kSampleCells;
    SamplePart part{"walls", {}, {{"quad4", {}}}};
    const auto at = [](int i, int j) { return 1 + i + (n + 1) * j; };
    for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i) part.points.emplace_back(i, j, 0.1F * float(i * j));
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i)
            part.elements[0].cells.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
    return part;
}

SamplePart sampleMixed()
{
    SamplePart part{"mixed", {}, {}};
    // Two cubes, one on the other, and a tip above them. Quadratic elements get the corners again for the points
    // between them.
    for (int k = 0; k < 3; ++k)
        for (const auto& [x, y] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}}) part.points.emplace_back(10 + x, y, k);
    part.points.emplace_back(10.5F, 0.5F, 3);
    std::vector<int> hexa20{1, 2, 3, 4, 5, 6, 7, 8}, tetra10{9, 10, 11, 13};
    hexa20.resize(20, 1);
    tetra10.resize(10, 9);
    part.elements = {{"point", {{1}}},
                     {"bar2", {{1, 2}, {2, 3}}},
                     {"bar3", {{1, 3, 2}}},
                     {"tria3", {{1, 2, 3}}},
                     {"tria6", {{1, 3, 4, 2, 2, 2}}},
                     {"quad8", {{1, 2, 3, 4, 1, 1, 1, 1}}},
                     {"nsided", {{5, 6, 7}, {5, 6, 7, 8}}},
                     {"g_hexa8", {{1, 2, 3, 4, 5, 6, 7, 8}}},
                     {"hexa20", {hexa20}},
                     {"penta6", {{5, 6, 7, 9, 10, 11}}},
                     {"nfaced", {{3, 5, 7, 8, 3, 9, 11, 12, 4, 5, 7, 11, 9, 4, 7, 8, 12, 11, 4, 8, 5, 9, 12}}},
                     {"tetra10", {tetra10}},
                     {"tetra4", {{9, 11, 12, 13}}},
                     {"pyramid5", {{9, 10, 11, 12, 13}}}};
    return part;
}

glm::vec3 sampleFlow(const glm::vec3& point, int step)
{
    return {point.y - 2 + float(step), 2 - point.x, 0.5F};
}

void writeSampleEnSight(const std::string& folder, const SampleEnSight& sample)
{
    EnSightBytes geometry(sample.format);
    if (sample.format.encoding == EnSightEncoding::binary) geometry.text("C Binary");
    if (sample.format.encoding == EnSightEncoding::fortran) geometry.text("Fortran Binary");
    geometry.text("a box").text("").text(sample.ids ? "node id given" : "node id off");
    geometry.text(sample.ids ? "element id given" : "element id assign");
    if (sample.extents && sample.format.encoding == EnSightEncoding::ascii)
        for (int axis = 0; axis < 3; ++axis) geometry.text(axis ? "-1.00000e+00-2.00000e+00" : "extents\n-1-2");
    else if (sample.extents)
        geometry.text("extents").reals({0, 4, 0, 4, 0, 4});
    std::vector<SamplePart> parts{sampleFluid(), sampleWalls()};
    if (sample.mixed) parts.push_back(sampleMixed());
    for (std::size_t i = 0; i < parts.size(); ++i) writePart(geometry, int(i) + 1, parts[i], sample.ids);
    if (sample.blocks) writeBlocks(geometry, int(parts.size()) + 1);
    writeBytes(folder + "/box.geo", geometry.bytes());
    for (int step = 0; step < 2; ++step) {
        EnSightBytes vectors(sample.format), nodes(sample.format), cells(sample.format);
        for (EnSightBytes* file : {&vectors, &nodes, &cells}) file->text("a variable");
        const auto begin = [&](std::size_t number) {
            for (EnSightBytes* file : {&vectors, &nodes, &cells}) file->text("part").whole({int(number)});
        };
        for (std::size_t i = 0; i < parts.size(); ++i) {
            begin(i + 1);
            const bool gaps = sample.gaps && i == 1;
            writeNodes(vectors, nodes, parts[i], step, false, gaps);
            for (const SampleElements& elements : parts[i].elements)
                writeCells(cells, elements.kind, elements.cells.size(), gaps);
        }
        for (const SamplePart& block : {slabPoints(), cubePoints()}) {
            if (!sample.blocks) break;
            const bool slab = block.points.size() == 12;
            begin(parts.size() + (slab ? 1 : 2));
            writeNodes(vectors, nodes, block, step, true, false);
            writeCells(cells, "block", slab ? 6 : 8, false);
        }
        const std::string number = ".000" + std::to_string(step);
        writeBytes(folder + "/U" + number, vectors.bytes());
        writeBytes(folder + "/q" + number, nodes.bytes());
        writeBytes(folder + "/p" + number, cells.bytes());
    }
    writeBytes(
        folder + "/box.case",
        "FORMAT\ntype: ensight gold\n\nGEOMETRY\nmodel: box.geo\n\nVARIABLE\nconstant per case: 1 rho 1.2 1.2\n"
        "vector per node: 1 U U.****\nscalar per node: 1 q q.****\nscalar per element: 1 p p.****\n\nTIME\n"
        "time set: 1\nnumber of steps: 2\nfilename start number: 0\nfilename increment: 1\ntime values: 0\n1.5\n");
}

void writeSampleEnSight6(const std::string& folder)
{
    const std::vector<SamplePart> parts{sampleFluid(), sampleWalls()};
    std::size_t count = 0;
    for (const SamplePart& part : parts) count += part.points.size();
    std::string geometry =
        fmt::format("a box\nof EnSight 6\nnode id given\nelement id off\ncoordinates\n{:8}\n", count);
    std::size_t id = 1;
    for (const SamplePart& part : parts)
        for (const glm::vec3& p : part.points)
            geometry += fmt::format("{:8}{:12.5e}{:12.5e}{:12.5e}\n", id++, p.x, p.y, p.z);
    std::size_t before = 0;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        geometry += fmt::format("part {:8}\n{}\n", i + 1, parts[i].name);
        for (const SampleElements& elements : parts[i].elements) {
            geometry += fmt::format("{}\n{:8}\n", elements.kind, elements.cells.size());
            for (const std::vector<int>& cell : elements.cells) {
                for (const int corner : cell) geometry += fmt::format("{:8}", corner + int(before));
                geometry += "\n";
            }
        }
        before += parts[i].points.size();
    }
    writeBytes(folder + "/box.geo", geometry);
    const auto numbers = [](const std::vector<float>& values) {
        std::string text;
        for (std::size_t i = 0; i < values.size(); ++i)
            text += fmt::format("{:12.5e}{}", values[i], i % 6 == 5 || i + 1 == values.size() ? "\n" : "");
        return text;
    };
    for (int step = 0; step < 2; ++step) {
        std::vector<float> vectors;
        std::string cells = "p\n";
        for (std::size_t i = 0; i < parts.size(); ++i) {
            for (const glm::vec3& p : parts[i].points)
                for (int c = 0; c < 3; ++c) vectors.push_back(sampleFlow(p, step)[c]);
            std::vector<float> own(parts[i].elements[0].cells.size());
            std::iota(own.begin(), own.end(), 0.0F);
            cells += fmt::format("part {:8}\n{}\n", i + 1, parts[i].elements[0].kind) + numbers(own);
        }
        writeBytes(folder + fmt::format("/U.000{}", step), "U\n" + numbers(vectors));
        writeBytes(folder + fmt::format("/p.000{}", step), cells);
    }
    writeBytes(folder + "/box.case",
               "FORMAT\ntype: ensight\n\nGEOMETRY\nmodel: box.geo\n\nVARIABLE\nvector per node: 1 U U.****\n"
               "scalar per element: 1 p p.****\n\nTIME\ntime set: 1\nnumber of steps: 2\nfilename start number: 0\n"
               "filename increment: 1\ntime values: 0\n1.5\n");
}

}  // namespace aeolic::test
