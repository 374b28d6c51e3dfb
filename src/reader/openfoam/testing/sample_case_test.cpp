#include "reader/openfoam/testing/sample_case.h"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <glm/glm.hpp>
#include <map>

namespace aeolic::test {
namespace {

namespace fs = std::filesystem;

constexpr int nx = 8, ny = 4, nz = 3;
const char* const patchNames[] = {"inlet", "outlet", "floor", "roof", "sides"};

struct Face {
    std::vector<int> points;
    int owner = 0, neighbour = -1, patch = -1;
};

int pointAt(int i, int j, int k)
{
    return i + (nx + 1) * (j + (ny + 1) * k);
}
/// The last cell has no patch and owns no face: it stands in 'neighbour' alone.
int cellAt(int i, int j, int k)
{
    constexpr int last = nx * ny * nz - 1, within = 1 + nx * (1 + ny);
    const int cell = i + nx * (j + ny * k);
    return cell == last ? within : cell == within ? last : cell;
}

std::vector<glm::dvec3> allPoints()
{
    std::vector<glm::dvec3> points;
    for (int k = 0; k <= nz; ++k)
        for (int j = 0; j <= ny; ++j)
            for (int i = 0; i <= nx; ++i) {
                const double x = 2.0 * i / nx, z = double(k) / nz, floor = 0.25 * std::exp(-10 * (x - 1) * (x - 1));
                points.emplace_back(x, floor + (1 - floor) * j / ny, z);
            }
    return points;
}

/// Inner faces by their owner, then the patches one behind the other. Corners turn out of the owner.
std::vector<Face> allFaces()
{
    std::vector<Face> faces;
    std::vector<std::vector<Face>> onPatch(5);
    const auto p = pointAt;
    for (int k = 0; k < nz; ++k)
        for (int j = 0; j < ny; ++j)
            for (int i = 0; i < nx; ++i) {
                const int cell = cellAt(i, j, k);
                const auto add = [&](std::vector<int> corners, int neighbour, int patch) {
                    Face face{std::move(corners), cell, neighbour, patch};
                    if (neighbour >= 0 && neighbour < cell) {
                        std::swap(face.owner, face.neighbour);
                        std::reverse(face.points.begin(), face.points.end());
                    }
                    (neighbour >= 0 ? faces : onPatch[std::size_t(patch)]).push_back(std::move(face));
                };
                const std::vector<int> right{p(i + 1, j, k), p(i + 1, j + 1, k), p(i + 1, j + 1, k + 1),
                                             p(i + 1, j, k + 1)};
                const std::vector<int> top{p(i, j + 1, k), p(i, j + 1, k + 1), p(i + 1, j + 1, k + 1),
                                           p(i + 1, j + 1, k)};
                const std::vector<int> front{p(i, j, k + 1), p(i + 1, j, k + 1), p(i + 1, j + 1, k + 1),
                                             p(i, j + 1, k + 1)};
                add(right, i + 1 < nx ? cellAt(i + 1, j, k) : -1, 1);
                add(top, j + 1 < ny ? cellAt(i, j + 1, k) : -1, 3);
                add(front, k + 1 < nz ? cellAt(i, j, k + 1) : -1, 4);
                if (i == 0) add({p(i, j, k), p(i, j, k + 1), p(i, j + 1, k + 1), p(i, j + 1, k)}, -1, 0);
                if (j == 0) add({p(i, j, k), p(i + 1, j, k), p(i + 1, j, k + 1), p(i, j, k + 1)}, -1, 2);
                if (k == 0) add({p(i, j, k), p(i, j + 1, k), p(i + 1, j + 1, k), p(i + 1, j, k)}, -1, 4);
            }
    for (const auto& patch : onPatch) faces.insert(faces.end(), patch.begin(), patch.end());
    return faces;
}

class Writer {
public:
    /// `block`: of files that processors have in common; -1: they have their own.
    Writer(const SampleCase& sample, fs::path folder, int block)
        : sample_(sample), folder_(std::move(folder)), block_(block)
    {
    }

    template <class Number>
    std::string bytesOf(Number value) const
    {
        std::string bytes(reinterpret_cast<const char*>(&value), sizeof value);
        if (sample_.bigEndian) std::reverse(bytes.begin(), bytes.end());
        return bytes;
    }
    std::string label(std::int64_t value) const
    {
        if (!sample_.binary) return std::to_string(value) + "\n";
        return sample_.longLabels ? bytesOf(value) : bytesOf(std::int32_t(value));
    }
    std::string vector(const glm::dvec3& v) const
    {
        return sample_.binary ? bytesOf(v.x) + bytesOf(v.y) + bytesOf(v.z) : fmt::format("({} {} {})\n", v.x, v.y, v.z);
    }
    std::string scalar(double v) const { return sample_.binary ? bytesOf(v) : fmt::format("{}\n", v); }
    static std::string list(std::size_t size, const std::string& values)
    {
        return fmt::format("{}\n({})\n", size, values);
    }
    std::string labels(const std::vector<std::int64_t>& values) const
    {
        std::string all;
        for (const std::int64_t value : values) all += label(value);
        return list(values.size(), all);
    }

    void file(const std::string& name, const std::string& type, const std::string& body) const
    {
        std::string text = block_ > 0 ? body : header(name, type, sample_.binary) + body;
        if (block_ >= 0)
            text = (block_ == 0 ? header(name, "decomposedBlockData", true) : "") +
                   fmt::format("\n// processor{}\n\n{}\n({})\n", block_, text.size(), text);
        const fs::path path = folder_ / name;
        fs::create_directories(path.parent_path());
        if (!sample_.gzip) {
            std::ofstream(path, block_ > 0 ? std::ios::binary | std::ios::app : std::ios::binary) << text;
            return;
        }
        gzFile out = gzopen((path.string() + ".gz").c_str(), block_ > 0 ? "ab" : "wb");
        gzwrite(out, text.data(), unsigned(text.size()));
        gzclose(out);
    }

private:
    std::string header(const std::string& name, const std::string& type, bool binary) const
    {
        const std::string arch =
            fmt::format("{};label={};scalar=64", sample_.bigEndian ? "MSB" : "LSB", sample_.longLabels ? 64 : 32);
        return fmt::format(
            "/* A case for tests */\nFoamFile\n{{ version 2.0; format {}; class {}; arch \"{}\"; object {}; }}\n// * "
            "//\n",
            binary ? "binary" : "ascii", type, arch, name);
    }

    const SampleCase& sample_;
    fs::path folder_;
    int block_;
};

/// One folder's mesh: cells renumbered in their order, faces inner first, then by patch.
struct Part {
    std::vector<int> cells, points;
    std::vector<Face> faces;                ///< In this part's own numbers.
    std::vector<std::int64_t> globalFaces;  ///< Counted from 1; negative where the face is turned round.
    std::map<int, std::pair<std::size_t, std::size_t>> patches;  ///< Number: first face and count; 5 and more: others.
};

Part partOf(int number, int parts)
{
    const auto owner = [&](int cell) { return (cell % nx) * parts / nx; };
    const std::vector<Face> all = allFaces();
    Part part;
    std::map<int, int> cellIds, pointIds;
    for (int cell = 0; cell < nx * ny * nz; ++cell)
        if (owner(cell) == number) {
            cellIds.emplace(cell, int(part.cells.size()));
            part.cells.push_back(cell);
        }
    std::map<int, std::vector<std::pair<std::int64_t, Face>>> sorted;  // -1: inner.
    for (std::size_t f = 0; f < all.size(); ++f) {
        Face face = all[f];
        const bool mine = owner(face.owner) == number;
        const bool hasOther = face.neighbour >= 0, otherMine = hasOther && owner(face.neighbour) == number;
        if (!mine && !otherMine) continue;
        auto global = std::int64_t(f) + 1;
        int group = face.patch;
        if (mine && otherMine) group = -1;
        if (hasOther && mine != otherMine) {
            group = 5 + owner(mine ? face.neighbour : face.owner);
            if (!mine) {
                std::swap(face.owner, face.neighbour);
                std::reverse(face.points.begin(), face.points.end());
                global = -global;
            }
            face.neighbour = -1;
        }
        sorted[group].emplace_back(global, face);
    }
    for (auto& [group, faces] : sorted) {
        if (group >= 0) part.patches[group] = {part.faces.size(), faces.size()};
        for (auto& [global, face] : faces) {
            for (int& point : face.points) {
                const auto [at, isNew] = pointIds.emplace(point, int(pointIds.size()));
                if (isNew) part.points.push_back(point);
                point = at->second;
            }
            face.owner = cellIds.at(face.owner);
            if (face.neighbour >= 0) face.neighbour = cellIds.at(face.neighbour);
            part.faces.push_back(face);
            part.globalFaces.push_back(global);
        }
    }
    return part;
}

std::string boundaryOf(const Part& part, int number)
{
    std::string text;
    for (const auto& [patch, run] : part.patches) {
        const bool wall = patch == 2 || patch == 3;
        const std::string name = patch < 5 ? patchNames[patch] : fmt::format("procBoundary{}to{}", number, patch - 5);
        text += fmt::format("    {}\n    {{ type {};{} nFaces {}; startFace {}; }}\n", name,
                            wall        ? "wall"
                            : patch < 5 ? "patch"
                                        : "processor",
                            wall ? " inGroups List<word> 2(wall solid);" : "", run.second, run.first);
    }
    return fmt::format("{}\n(\n{})\n", part.patches.size(), text);
}

void writeMesh(const Writer& out, const Part& part, int number, const SampleCase& sample)
{
    const std::vector<glm::dvec3> all = allPoints();
    std::string points, faces;
    for (const int point : part.points) points += out.vector(all[std::size_t(point)]);
    out.file("polyMesh/points", "vectorField", out.list(part.points.size(), points));
    std::vector<std::int64_t> begins{0}, corners, owners, neighbours;
    for (const Face& face : part.faces) {
        corners.insert(corners.end(), face.points.begin(), face.points.end());
        begins.push_back(std::int64_t(corners.size()));
        faces += fmt::format("4({} {} {} {})\n", face.points[0], face.points[1], face.points[2], face.points[3]);
        owners.push_back(face.owner);
        if (face.neighbour >= 0) neighbours.push_back(face.neighbour);
    }
    if (sample.binary)
        out.file("polyMesh/faces", "faceCompactList", out.labels(begins) + out.labels(corners));
    else
        out.file("polyMesh/faces", "faceList", out.list(part.faces.size(), faces));
    out.file("polyMesh/owner", "labelList", out.labels(owners));
    out.file("polyMesh/neighbour", "labelList", out.labels(neighbours));
    out.file("polyMesh/boundary", "polyBoundaryMesh", boundaryOf(part, number));
    if (sample.processors > 0) out.file("polyMesh/faceProcAddressing", "labelList", out.labels(part.globalFaces));
}

glm::dvec3 centreOf(const Part& part, const Face& face)
{
    const std::vector<glm::dvec3> all = allPoints();
    glm::dvec3 sum{0};
    for (const int point : face.points) sum += all[std::size_t(part.points[std::size_t(point)])];
    return sum / double(face.points.size());
}

void writeFields(const Writer& out, const Part& part, int number, double time)
{
    std::string velocities, pressures, onU, onP, onStress;
    for (const int cell : part.cells) {
        const double x = cell % nx, y = (cell / nx) % ny, z = cell / (nx * ny);
        velocities += out.vector({1 + y, 0.1 * std::sin(x), 0.2 * z + time});
        pressures += out.scalar(x + 10 * y + 100 * z + time);
    }
    for (const auto& [patch, run] : part.patches) {
        const bool wall = patch == 2 || patch == 3;
        const std::string name = patch < 5 ? patchNames[patch] : fmt::format("procBoundary{}to{}", number, patch - 5);
        std::string values;
        for (std::size_t f = run.first; f < run.first + run.second; ++f) {
            const glm::dvec3 c = centreOf(part, part.faces[f]);
            values += out.vector(glm::dvec3(1 + c.x, 0, c.z) * (1 + time));
        }
        const std::string zero = patch < 5 ? "" : "value uniform (0 0 0);";
        onU += fmt::format("{}\n{{ type {}; {} }}\n", name,
                           wall         ? "noSlip"
                           : patch == 4 ? "slip"
                           : patch < 5  ? "zeroGradient"
                                        : "processor",
                           zero);
        onP += fmt::format("{}\n{{ type {}; {} }}\n", name, patch < 5 ? "zeroGradient" : "processor",
                           patch < 5 ? "" : "value uniform 0;");
        onStress += fmt::format("{}\n{{ type calculated; refValue nonuniform List<vector> {}; value {}; }}\n", name,
                                out.list(run.second, values),
                                wall ? "nonuniform List<vector> " + out.list(run.second, values) : "uniform (0 0 0)");
    }
    const auto body = [](const std::string& inner, const std::string& boundary) {
        return "dimensions [0 1 -1 0 0 0 0];\n" + inner + "boundaryField\n{\n" + boundary + "}\n";
    };
    const auto inner = [&](const char* type, const std::string& values) {
        return fmt::format("internalField nonuniform List<{}> {};\n", type, out.list(part.cells.size(), values));
    };
    out.file("U", "volVectorField", body(inner("vector", velocities), onU));
    out.file("p", "volScalarField", body(inner("scalar", pressures), onP));
    out.file("wallShearStress", "volVectorField", body("internalField uniform (0 0 0);\n", onStress));
}

}  // namespace

void writeSampleCase(const std::string& folder, const SampleCase& sample)
{
    const int parts = std::max(1, sample.processors);
    for (int number = 0; number < parts; ++number) {
        fs::path root(folder);
        const int block = sample.collated > 0 ? number % sample.collated : -1, first = number - block;
        if (sample.collated >= parts)
            root /= fmt::format("processors{}", parts);
        else if (sample.collated > 0)
            root /= fmt::format("processors{}_{}-{}", parts, first, std::min(first + sample.collated, parts) - 1);
        else if (sample.processors > 0)
            root /= fmt::format("processor{}", number);
        const Part part = partOf(number, parts);
        writeMesh(Writer(sample, root / "constant" / sample.region, block), part, number, sample);
        for (const std::string& time : sample.times)
            writeFields(Writer(sample, root / time / sample.region, block), part, number, std::stod(time));
    }
    fs::create_directories(fs::path(folder) / "system");
    std::ofstream(fs::path(folder) / "system/controlDict")
        << "FoamFile { version 2.0; format ascii; class dictionary; object controlDict; }\n"
           "startFrom startTime; startTime 0; endTime 1; deltaT 1; writeControl timeStep; writeInterval 1;\n"
           "timeFormat general; timePrecision 6;\n";
    std::ofstream(fs::path(folder) / "case.foam");
}

}  // namespace aeolic::test
