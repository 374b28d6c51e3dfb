#include "render/cpu/project/clip.h"

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

}  // namespace aeolic::cpu
