#include "render/cpu/project/raster/clip.h"

#include <cmath>

#include "render/cpu/project/raster/transform.h"

namespace aeolic::cpu {

int clipTriangle(const std::array<glm::dvec3, 3>& corners, double nearDepth, double slopeX, double slopeY,
                 std::array<glm::dvec3, kMaxClippedCorners>& out)
{
    const glm::dvec4 planes[5] = {
        {0, 0, 1, -nearDepth}, {1, 0, slopeX, 0}, {-1, 0, slopeX, 0}, {0, 1, slopeY, 0}, {0, -1, slopeY, 0}};
    std::array<glm::dvec3, kMaxClippedCorners> in;
    int count = 3;
    for (int i = 0; i < 3; ++i) out[std::size_t(i)] = corners[std::size_t(i)];
    for (const glm::dvec4& plane : planes) {
        in = out;
        const int before = count;
        count = 0;
        for (int i = 0; i < before; ++i) {
            const glm::dvec3 p = in[std::size_t(i)], q = in[std::size_t((i + 1) % before)];
            const double dp = glm::dot(glm::dvec3(plane), p) + plane.w, dq = glm::dot(glm::dvec3(plane), q) + plane.w;
            if (dp >= 0) out[std::size_t(count++)] = p;
            if ((dp >= 0) != (dq >= 0)) {
                const glm::dvec3 inner = dp >= 0 ? p : q, outer = dp >= 0 ? q : p;
                const double di = dp >= 0 ? dp : dq, dou = dp >= 0 ? dq : dp;
                out[std::size_t(count++)] = inner + (outer - inner) * (di / (di - dou));
            }
        }
        if (count < 3) return 0;
    }
    return count;
}

std::vector<ClippedTriangle> clippedPieces(const SurfaceMesh& mesh, const View& view, std::uint32_t id)
{
    const double halfX = view.centerX / view.focalPx, halfY = view.centerY / view.focalPx;
    const double guardX = halfX + 65536.0 / view.focalPx, guardY = halfY + 65536.0 / view.focalPx;
    std::array<glm::dvec3, 3> eye;
    for (std::size_t k = 0; k < 3; ++k) {
        const glm::dvec3 p =
            glm::dvec3(mesh.positions[mesh.triangles[id][k]]) / view.unitWorld - glm::dvec3(view.eyeLocal);
        eye[k] = {glm::dot(p, glm::dvec3(view.right)), glm::dot(p, glm::dvec3(view.up)),
                  glm::dot(p, glm::dvec3(view.forward))};
    }
    std::array<glm::dvec3, kMaxClippedCorners> corners;
    const int count = clipTriangle(eye, view.nearDepth, guardX, guardY, corners);
    std::vector<ClippedTriangle> pieces;
    for (int k = 2; k < count; ++k) {
        const auto corner = [&](int i) {
            const glm::dvec3& p = corners[std::size_t(i)];
            return Corner{std::lround((view.centerX + view.focalPx * p.x / p.z) * kSubpixels),
                          std::lround((view.centerY - view.focalPx * p.y / p.z) * kSubpixels), float(1.0 / p.z)};
        };
        pieces.push_back({{corner(0), corner(k - 1), corner(k)}, id});
    }
    return pieces;
}

}  // namespace aeolic::cpu
