#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace aeolic {

/// A place on a streamline of a surface.
struct LineSample {
    glm::vec3 at{0}, normal{0};
    std::uint32_t chain = 0;  ///< Which streamline it is of.
    float arc = 0;            ///< Along it, from its seed on; less than 0 upstream.
};

/// Sheets that face different ways, as the two sides of a plate, are not near each other.
inline bool faceTheSameWay(const glm::vec3& normal, const glm::vec3& other)
{
    constexpr float leastCosine = 0.2f;
    return glm::dot(normal, other) >= leastCosine;
}

/// Where streamlines run, for the question whether a place keeps its distance from them: those that face the same
/// way.
class NearSamples {
public:
    /// For distances of about `reach`. `expected`: about how many samples there will be.
    NearSamples(float reach, std::size_t expected);

    void add(const LineSample& sample);

    /// No sample is within `radius`, but for those of its own chain that are within `ownArc` along it. Cost: that of
    /// the samples within twice the reach.
    bool isFree(const LineSample& place, float radius, float ownArc) const;

    std::size_t count() const { return samples_.size(); }

    /// Takes out those that were added last, until so many are left.
    void shrinkTo(std::size_t count);

private:
    struct Kept {
        LineSample sample;
        std::uint32_t next;  // Of the same bucket.
    };
    glm::ivec3 cellOf(const glm::vec3& at) const;
    std::size_t bucketOf(const glm::ivec3& cell) const;

    float cell_;
    std::vector<std::uint32_t> first_;  // [buckets], a power of two
    std::vector<Kept> samples_;
};

}  // namespace aeolic
