#include "data/fingerprint.h"

#include <fmt/format.h>

#include <cstring>

namespace aeolic {
namespace {

/// FNV-1a, a word at a time.
class Hash {
public:
    template <class T>
    void add(const std::vector<T>& values)
    {
        const auto* bytes = reinterpret_cast<const char*>(values.data());
        static_assert(sizeof(T) % sizeof(std::uint32_t) == 0);
        for (std::size_t i = 0; i < values.size() * sizeof(T); i += sizeof(std::uint32_t)) {
            std::uint32_t word;
            std::memcpy(&word, bytes + i, sizeof word);
            value_ = (value_ ^ word) * 1099511628211u;
        }
    }
    std::uint64_t value() const { return value_; }

private:
    std::uint64_t value_ = 14695981039346656037u;
};

}  // namespace

std::string fingerprint(const Scene& scene)
{
    const SurfaceMesh& mesh = scene.surface;
    Hash hash;
    hash.add(mesh.positions);
    hash.add(mesh.triangles);
    hash.add(mesh.pointVectors);
    hash.add(mesh.cellVectors);
    hash.add(mesh.pointScalars);
    hash.add(mesh.cellScalars);
    std::string text = fmt::format("{} triangles, hash {:016x}, largest vector {}", mesh.triangles.size(), hash.value(),
                                   scene.maxVector);
    if (scene.field)
        text += fmt::format(", field of {}x{}x{}", scene.field->dims[0], scene.field->dims[1], scene.field->dims[2]);
    if (scene.hasScalar) text += fmt::format(", scalar {} to {}", scene.scalarRange[0], scene.scalarRange[1]);
    return text;
}

}  // namespace aeolic
