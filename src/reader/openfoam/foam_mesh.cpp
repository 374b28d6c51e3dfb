#include "reader/openfoam/foam_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace aeolic {
namespace {

constexpr double kFarthestPoint = 1e30;
constexpr std::size_t kMostReserved = std::size_t{1} << 30;

/// Follows numbers 0, 1, 2 … past the runs of wanted ones.
class Runs {
public:
    /// Null: all are wanted.
    explicit Runs(const std::vector<FoamPatch>* patches) : patches_(patches) {}

    bool wantsAll() const { return !patches_; }

    bool wants(std::uint64_t number)
    {
        if (!patches_) return true;
        while (at_ < patches_->size() && number >= (*patches_)[at_].firstFace + (*patches_)[at_].faces) ++at_;
        return at_ < patches_->size() && number >= (*patches_)[at_].firstFace;
    }

private:
    const std::vector<FoamPatch>* patches_;
    std::size_t at_ = 0;
};

/// Reads the faces that are wanted, whose corners are numbers of the mesh's points.
class FaceReader {
public:
    FaceReader(const FoamPath& file, const std::vector<FoamPatch>* patches) : in_(file), runs_(patches)
    {
        if (in_.className() == "faceCompactList")
            readCompact();
        else
            readOneByOne();
        in_.finish();
    }

    MeshFaces faces;  // Without the cells on both sides.
    std::vector<std::uint64_t> numbers;
    std::uint64_t inMesh = 0;

    /// Throws unless all corners are below the number of points.
    void requireCorners(std::uint64_t points) const
    {
        for (const std::uint32_t corner : faces.corners)
            if (corner >= points)
                in_.fail(fmt::format("a face has point {}, and there are {}", corner, points),
                         "corners below the number of points");
    }

private:
    void takeCorners(std::span<const std::int64_t> points)
    {
        for (const std::int64_t point : points)
            if (std::uint64_t(point) > MeshFaces::kMost)
                in_.fail(fmt::format("a face has corner {}", point), "the number of a point");
        faces.corners.insert(faces.corners.end(), points.begin(), points.end());
    }

    void endFace(std::uint64_t number, std::size_t end)
    {
        const std::size_t corners = end - (faces.ends.empty() ? 0 : faces.ends.back());
        if (corners < 3) in_.fail(fmt::format("face {} has {} corners", number, corners), "at least 3");
        if (!runs_.wantsAll()) numbers.push_back(number);
        faces.ends.push_back(end);
    }

    /// Each face with the number of its corners: text, or binary face by face.
    void readOneByOne()
    {
        const std::uint64_t size = in_.count("number of faces");
        in_.expect("(", "faces");
        for (; in_.peekToken() != ")"; ++inMesh) {
            if (inMesh == size) in_.fail("more faces than it says", std::to_string(size));
            const bool wanted = runs_.wants(inMesh);
            in_.labels(fmt::format("face {}", inMesh), [&](std::uint64_t, std::span<const std::int64_t> points) {
                if (wanted) takeCorners(points);
            });
            if (wanted) endFace(inMesh, faces.corners.size());
        }
        if (inMesh != size) in_.fail(fmt::format("{} faces", inMesh), fmt::format("{}, as it says", size));
    }

    /// Where each face begins, then all corners.
    void readCompact()
    {
        std::vector<std::array<std::int64_t, 2>> ranges;  // Of the wanted faces' corners.
        std::int64_t last = 0;
        const auto takeOffset = [&](std::uint64_t i, std::int64_t offset) {
            if (offset < last || (i == 0 && offset != 0))
                in_.fail(fmt::format("face {} begins at {}, behind {}", i, offset, last),
                         "offsets that increase from 0");
            if (i > 0 && runs_.wants(i - 1)) {
                endFace(i - 1, (faces.ends.empty() ? 0 : faces.ends.back()) + std::size_t(offset - last));
                if (ranges.empty() || ranges.back()[1] != last) ranges.push_back({last, last});
                ranges.back()[1] = offset;
            }
            last = offset;
        };
        const std::uint64_t offsets = in_.labels("where faces begin", [&](std::uint64_t first, auto some) {
            for (const std::int64_t offset : some) takeOffset(first++, offset);
        });
        faces.corners.reserve(faces.ends.empty() ? 0 : std::min(faces.ends.back(), kMostReserved));
        std::size_t at = 0;
        const std::uint64_t found = in_.labels("corners of faces", [&](std::uint64_t first, auto some) {
            const auto begin = std::int64_t(first), end = begin + std::int64_t(some.size());
            while (at < ranges.size() && ranges[at][1] <= begin) ++at;
            for (std::size_t r = at; r < ranges.size() && ranges[r][0] < end; ++r) {
                const std::int64_t from = std::max(begin, ranges[r][0]), to = std::min(end, ranges[r][1]);
                takeCorners(some.subspan(std::size_t(from - begin), std::size_t(to - from)));
            }
        });
        if (found != std::uint64_t(last)) in_.fail(fmt::format("{} corners of faces", found), std::to_string(last));
        inMesh = offsets == 0 ? 0 : offsets - 1;
    }

    FoamStream in_;
    Runs runs_;
};

/// Numbers the points that are used in the order in which the corners come to them, and reads those.
void readPointsOf(const FoamPath& file, FoamFaces& faces)
{
    std::vector<std::uint32_t>& corners = faces.faces.corners;
    std::vector<std::uint32_t> used = corners;
    std::ranges::sort(used);
    used.erase(std::unique(used.begin(), used.end()), used.end());
    constexpr std::uint32_t none = ~std::uint32_t{0};
    std::vector<std::uint32_t> newId(used.size(), none);
    std::uint32_t count = 0;
    for (std::uint32_t& corner : corners) {
        std::uint32_t& id = newId[std::size_t(std::lower_bound(used.begin(), used.end(), corner) - used.begin())];
        if (id == none) id = count++;
        corner = id;
    }
    faces.points.resize(used.size());
    std::size_t at = 0;
    FoamStream in(file);
    const std::uint64_t points = in.values(3, "points", [&](std::uint64_t first, std::span<const double> some) {
        for (; at < used.size() && used[at] < first + some.size() / 3; ++at) {
            const double* p = &some[3 * std::size_t(used[at] - first)];
            faces.points[newId[at]] = {p[0], p[1], p[2]};
        }
    });
    in.finish();
    if (at < used.size())
        in.fail(fmt::format("a face has point {}, and there are {}", used.back(), points),
                "corners below the number of points");
}

std::vector<glm::dvec3> readPoints(const FoamPath& file)
{
    std::vector<glm::dvec3> points;
    FoamStream in(file);
    in.values(3, "points", [&](std::uint64_t, std::span<const double> some) {
        for (const double x : some)
            if (!(std::abs(x) <= kFarthestPoint))
                in.fail(fmt::format("a coordinate of point {} is {:.6g}", points.size(), x),
                        fmt::format("at most {}", kFarthestPoint));
        for (std::size_t i = 0; i < some.size(); i += 3)
            points.emplace_back(nearestFloat(some[i]), nearestFloat(some[i + 1]), nearestFloat(some[i + 2]));
    });
    in.finish();
    return points;
}

/// The cell of each face that the file has, numbered from 1; `cells` becomes the largest number at least.
std::vector<std::uint32_t> readSides(const FoamPath& file, std::size_t faces, bool owner, std::size_t& cells)
{
    std::vector<std::uint32_t> sides;
    sides.reserve(faces);
    FoamStream in(file);
    const std::uint64_t count = in.labels("cells", [&](std::uint64_t first, std::span<const std::int64_t> some) {
        for (const std::int64_t cell : some) {
            const bool none = !owner && cell == -1;  // Older cases fill the list up.
            if (!none && std::uint64_t(cell) >= faces)
                in.fail(fmt::format("face {} has cell {}", first, cell), "cells below the number of faces");
            sides.push_back(std::uint32_t(cell + 1));
            cells = std::max(cells, std::size_t(cell + 1));
            ++first;
        }
    });
    in.finish();
    if (owner ? count != faces : count > faces)
        in.fail(fmt::format("{} numbers for {} faces", count, faces), "one for each");
    sides.resize(faces, 0);
    return sides;
}

}  // namespace

glm::dvec3 FoamFaces::normal(std::size_t face) const
{
    const auto corners = faces.face(face);
    const auto point = [&](std::size_t k) { return points[corners[k]]; };
    glm::dvec3 sum{0};
    for (std::size_t k = 1; k + 1 < corners.size(); ++k)
        sum += glm::cross(point(k) - point(0), point(k + 1) - point(0));
    const double length = glm::length(sum);
    return length > 0 ? sum / length : glm::dvec3{0};
}

FoamFaces readFoamFaces(const FoamPath& folder, const std::string& region, double time,
                        const std::vector<FoamPatch>& patches)
{
    FoamFaces faces;
    {
        FaceReader reader(foamMeshFile(folder, region, time, "faces"), &patches);
        faces.numbers = std::move(reader.numbers);
        faces.faces = std::move(reader.faces);
        faces.inMesh = reader.inMesh;
    }
    readPointsOf(foamMeshFile(folder, region, time, "points"), faces);
    return faces;
}

std::vector<std::int64_t> readFoamLabels(const FoamPath& file, const std::vector<std::uint64_t>& faces)
{
    std::vector<std::int64_t> labels;
    labels.reserve(faces.size());
    FoamStream in(file);
    const std::uint64_t found = in.labels("labels", [&](std::uint64_t first, std::span<const std::int64_t> some) {
        for (; labels.size() < faces.size() && faces[labels.size()] < first + some.size();)
            labels.push_back(some[std::size_t(faces[labels.size()] - first)]);
    });
    in.finish();
    if (labels.size() < faces.size())
        in.fail(fmt::format("{} numbers, none for face {}", found, faces[labels.size()]), "one for each face");
    return labels;
}

FoamMesh readFoamMesh(const FoamPath& folder, const std::string& region, double time)
{
    const auto file = [&](const char* name) { return foamMeshFile(folder, region, time, name); };
    FoamMesh mesh;
    mesh.points = readPoints(file("points"));
    {
        FaceReader reader(file("faces"), nullptr);
        reader.requireCorners(mesh.points.size());
        mesh.faces = std::move(reader.faces);
    }
    mesh.faces.inside = readSides(file("owner"), mesh.faces.count(), true, mesh.cells);
    mesh.faces.outside = readSides(file("neighbour"), mesh.faces.count(), false, mesh.cells);
    return mesh;
}

}  // namespace aeolic
