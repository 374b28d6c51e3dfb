#include "reader/openfoam/foam_mesh.h"

#include <fmt/format.h>

#include <algorithm>

#include "aeolic/error.h"
#include "reader/openfoam/foam_stream.h"

namespace aeolic {
namespace {

/// Follows numbers 0, 1, 2 … past runs of wanted ones.
class Runs {
public:
    explicit Runs(const std::vector<FoamPatch>& patches) : patches_(patches) {}

    bool wants(std::uint64_t number)
    {
        while (at_ < patches_.size() && number >= patches_[at_].firstFace + patches_[at_].faces) ++at_;
        return at_ < patches_.size() && number >= patches_[at_].firstFace;
    }

private:
    const std::vector<FoamPatch>& patches_;
    std::size_t at_ = 0;
};

using PointIds = std::vector<std::uint64_t>;

void takeCorner(const FoamStream& in, std::int64_t point, PointIds& corners)
{
    if (point < 0) in.fail(fmt::format("a face has corner {}", point), "the number of a point");
    corners.push_back(std::uint64_t(point));
}

void endFace(const FoamStream& in, std::uint64_t number, const PointIds& corners, FoamFaces& faces)
{
    if (corners.size() - faces.begins.back() < 3)
        in.fail(fmt::format("face {} has {} corners", number, corners.size() - faces.begins.back()), "at least 3");
    faces.numbers.push_back(number);
    faces.begins.push_back(corners.size());
}

/// Each face with the number of its corners: text, or binary face by face.
std::uint64_t readFaceList(FoamStream& in, const std::vector<FoamPatch>& patches, FoamFaces& faces, PointIds& corners)
{
    Runs runs(patches);
    const std::uint64_t size = in.count("number of faces");
    in.expect("(", "faces");
    std::uint64_t number = 0;
    for (; in.peekToken() != ")"; ++number) {
        if (number == size) in.fail("more faces than it says", std::to_string(size));
        const bool wanted = runs.wants(number);
        in.labels(fmt::format("face {}", number), [&](std::uint64_t, std::int64_t point) {
            if (wanted) takeCorner(in, point, corners);
        });
        if (wanted) endFace(in, number, corners, faces);
    }
    if (number != size) in.fail(fmt::format("{} faces", number), fmt::format("{}, as it says", size));
    in.token();
    return size;
}

/// Where each face begins, then all corners.
std::uint64_t readCompactFaces(FoamStream& in, const std::vector<FoamPatch>& patches, FoamFaces& faces,
                               PointIds& corners)
{
    struct Face {
        std::uint64_t number = 0;
        std::int64_t begin = 0, end = 0;
    };
    std::vector<Face> wanted;
    Runs runs(patches);
    std::int64_t last = 0;
    const std::uint64_t offsets = in.labels("where faces begin", [&](std::uint64_t i, std::int64_t offset) {
        if (offset < last || (i == 0 && offset != 0))
            in.fail(fmt::format("face {} begins at {}, behind {}", i, offset, last), "offsets that increase from 0");
        if (i > 0 && runs.wants(i - 1)) wanted.push_back({i - 1, last, offset});
        last = offset;
    });
    std::size_t at = 0;
    const std::uint64_t found = in.labels("corners of faces", [&](std::uint64_t i, std::int64_t point) {
        while (at < wanted.size() && std::int64_t(i) >= wanted[at].end) {
            endFace(in, wanted[at].number, corners, faces);
            ++at;
        }
        if (at < wanted.size() && std::int64_t(i) >= wanted[at].begin) takeCorner(in, point, corners);
    });
    if (found != std::uint64_t(last)) in.fail(fmt::format("{} corners of faces", found), std::to_string(last));
    for (; at < wanted.size(); ++at) endFace(in, wanted[at].number, corners, faces);
    return offsets == 0 ? 0 : offsets - 1;
}

/// Numbers the points that are used in the order in which the corners come to them, and reads those.
void readPoints(const std::string& path, const PointIds& corners, FoamFaces& faces)
{
    PointIds used = corners;
    std::sort(used.begin(), used.end());
    used.erase(std::unique(used.begin(), used.end()), used.end());
    constexpr std::uint32_t none = ~std::uint32_t{0};
    if (used.size() >= none) throw InputError(path, fmt::format("{} points", used.size()), "fewer than 2^32");
    std::vector<std::uint32_t> newId(used.size(), none);
    std::uint32_t count = 0;
    for (const std::uint64_t corner : corners) {
        auto& id = newId[std::size_t(std::lower_bound(used.begin(), used.end(), corner) - used.begin())];
        if (id == none) id = count++;
        faces.corners.push_back(id);
    }
    faces.points.resize(used.size());
    std::size_t at = 0;
    FoamStream in(path);
    const std::uint64_t points = in.values(3, "points", [&](std::uint64_t i, const double* p) {
        if (at < used.size() && used[at] == i) faces.points[newId[at++]] = {p[0], p[1], p[2]};
    });
    in.finish();
    if (at < used.size())
        throw InputError(path, fmt::format("a face has point {}, and there are {}", used.back(), points),
                         "corners below the number of points");
}

}  // namespace

glm::dvec3 FoamFaces::normal(std::size_t face) const
{
    glm::dvec3 sum{0};
    const glm::dvec3& first = points[corners[begins[face]]];
    for (std::size_t k = begins[face] + 1; k + 1 < begins[face + 1]; ++k)
        sum += glm::cross(points[corners[k]] - first, points[corners[k + 1]] - first);
    const double length = glm::length(sum);
    return length > 0 ? sum / length : glm::dvec3{0};
}

FoamFaces readFoamFaces(const std::string& folder, const std::string& region, double time,
                        const std::vector<FoamPatch>& patches)
{
    FoamFaces faces;
    faces.begins.push_back(0);
    PointIds corners;
    FoamStream in(foamMeshFile(folder, region, time, "faces"));
    const std::uint64_t count = in.className() == "faceCompactList" ? readCompactFaces(in, patches, faces, corners)
                                                                    : readFaceList(in, patches, faces, corners);
    in.finish();
    faces.inMesh = count;
    readPoints(foamMeshFile(folder, region, time, "points"), corners, faces);
    return faces;
}

std::vector<std::int64_t> readFoamLabels(const std::string& path, const std::vector<std::uint64_t>& faces)
{
    std::vector<std::int64_t> labels;
    labels.reserve(faces.size());
    FoamStream in(path);
    const std::uint64_t found = in.labels("labels", [&](std::uint64_t i, std::int64_t label) {
        if (labels.size() < faces.size() && faces[labels.size()] == i) labels.push_back(label);
    });
    in.finish();
    if (labels.size() < faces.size())
        in.fail(fmt::format("{} numbers, none for face {}", found, faces[labels.size()]), "one for each face");
    return labels;
}

}  // namespace aeolic
