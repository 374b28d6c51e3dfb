#include "reader/openfoam/foam_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>

#include "reader/openfoam/foam_stream.h"

namespace aeolic {
namespace {

constexpr unsigned char kFewestFaces = 4;
/// VTK's octree of points, which joins the meshes of processors, divides itself without end where coordinates differ by
/// more than numbers can tell.
constexpr double kFarthestCoordinate = 1e30;

std::uint64_t countPoints(const std::string& path)
{
    FoamStream in(path);
    const std::uint64_t count = in.values(3, "points", [&](std::uint64_t i, const double* point) {
        if (!std::all_of(point, point + 3, [](double x) { return std::abs(x) <= kFarthestCoordinate; }))
            in.fail(fmt::format("point {} is at ({:.6g} {:.6g} {:.6g})", i, point[0], point[1], point[2]),
                    fmt::format("coordinates of at most {}", kFarthestCoordinate));
    });
    in.finish();
    return count;
}

std::uint64_t checkFaces(const std::string& path, std::uint64_t points)
{
    FoamStream in(path);
    const auto check = [&](std::uint64_t, std::int64_t point) {
        if (point < 0 || std::uint64_t(point) >= points)
            in.fail(fmt::format("a face has point {}, and there are {}", point, points),
                    "corners below the number of points");
    };
    std::uint64_t faces = 0;
    if (in.className() == "faceCompactList") {
        std::int64_t last = 0;
        const std::uint64_t offsets = in.labels("where faces begin", [&](std::uint64_t i, std::int64_t offset) {
            if (i == 0 ? offset != 0 : offset < last + 3)
                in.fail(fmt::format("face {} begins at {}, behind {}", i, offset, last), "faces of 3 corners or more");
            last = offset;
        });
        if (in.labels("corners of faces", check) != std::uint64_t(last))
            in.fail("another number of corners than its faces need", std::to_string(last));
        faces = offsets == 0 ? 0 : offsets - 1;
    } else {
        faces = in.count("number of faces");
        in.expect("(", "faces");
        for (std::uint64_t i = 0; i < faces; ++i) {
            const std::string item = fmt::format("face {}", i);
            if (in.labels(item, check) < 3) in.fail(item + " has fewer than 3 corners", "at least 3");
        }
        in.expect(")", "faces");
    }
    in.finish();
    return faces;
}

/// Counts the faces of each cell, as far as this file has them. Returns how many numbers it has.
std::uint64_t countFaces(const std::string& path, std::uint64_t faces, bool owner, std::vector<unsigned char>& cells)
{
    FoamStream in(path);
    const std::uint64_t count = in.labels("cells", [&](std::uint64_t i, std::int64_t cell) {
        if (!owner && cell == -1) return;  // Older cases fill the list up.
        if (cell < 0 || std::uint64_t(cell) >= faces)
            in.fail(fmt::format("face {} has cell {}", i, cell), "cells below the number of faces");
        if (std::uint64_t(cell) >= cells.size()) cells.resize(std::size_t(cell) + 1, 0);
        auto& held = cells[std::size_t(cell)];
        if (held < kFewestFaces) ++held;
    });
    in.finish();
    if (owner ? count != faces : count > faces)
        in.fail(fmt::format("{} numbers for {} faces", count, faces), "one for each");
    return count;
}

void checkCells(const std::string& path, const FoamField& field, std::uint64_t cells)
{
    FoamStream in(path);
    for (std::string key = in.token(); key != "internalField"; key = in.token()) {
        if (key.empty()) in.fail("it has no internalField", "the field's values in cells");
        in.skipEntry(key);
    }
    if (in.token() == "nonuniform") {
        if (in.peekToken().starts_with("List<")) in.token();
        const std::uint64_t found = in.values(field.components, "internalField", [](std::uint64_t, const double*) {});
        if (found != cells)
            in.fail(fmt::format("internalField has {} values", found), fmt::format("{}, one for each cell", cells));
    } else {
        in.skipEntry("internalField");
    }
    in.finish();
}

}  // namespace

std::uint64_t checkFoamVolume(const std::string& folder, const std::string& region, double time,
                              const std::vector<FoamField>& fields)
{
    const auto mesh = [&](const char* file) { return foamMeshFile(folder, region, time, file); };
    const std::uint64_t points = countPoints(mesh("points")), faces = checkFaces(mesh("faces"), points);
    std::vector<unsigned char> cells;
    countFaces(mesh("owner"), faces, true, cells);
    const std::uint64_t inner = countFaces(mesh("neighbour"), faces, false, cells);
    for (std::size_t i = 0; i < cells.size(); ++i)
        if (cells[i] < kFewestFaces)
            FoamStream(mesh("owner")).fail(fmt::format("cell {} has {} faces", i, cells[i]), "at least 4");
    for (const FoamPatch& patch : readFoamBoundary(mesh("boundary")))
        if (patch.faces > faces || patch.firstFace > faces - patch.faces ||
            (patch.faces > 0 && inner < faces && patch.firstFace < inner))
            FoamStream(mesh("boundary"))
                .fail(fmt::format("patch '{}' has faces {} to {}", patch.name, patch.firstFace,
                                  patch.firstFace + patch.faces),
                      fmt::format("faces within {} to {}", inner, faces));
    for (const FoamField& field : fields)
        checkCells((std::filesystem::path(foamTimeFolder(folder, time)) / region / field.name).string(), field,
                   cells.size());
    return cells.size();
}

}  // namespace aeolic
