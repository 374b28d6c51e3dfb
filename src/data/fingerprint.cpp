#include "data/fingerprint.h"

#include <fmt/format.h>

#include <cstring>

#include "base/fnv.h"

namespace aeolic {
namespace {

/// A hash of arrays, a word at a time.
class Hash {
public:
    template <class T>
    void add(const std::vector<T>& values)
    {
        static_assert(sizeof(T) % sizeof(std::uint32_t) == 0);
        addWords(values.data(), values.size() * sizeof(T) / sizeof(std::uint32_t), 1);
        hash_.mix(std::uint32_t(values.size()));  // Values must not move from one array to the next unnoticed.
    }

    /// Takes every `stride`-th of `count` words.
    void addWords(const void* memory, std::size_t count, std::size_t stride)
    {
        for (std::size_t i = 0; i < count; i += stride) {
            std::uint32_t word;
            std::memcpy(&word, static_cast<const char*>(memory) + i * sizeof word, sizeof word);
            hash_.mix(word);
        }
    }
    std::uint64_t value() const { return hash_.value; }

private:
    Fnv hash_;
};

// Some of a large field's samples are enough to tell two files apart, and cost nothing beside reading it.
constexpr std::size_t kMostWords = std::size_t{1} << 16;

void addSamples(Hash& hash, const GridField& field)
{
    const std::size_t words = field.bytes() / sizeof(std::uint32_t);
    hash.addWords(field.samples.get(), words, words / kMostWords + 1);
}

std::string pointText(const glm::dvec3& p)
{
    return fmt::format("{},{},{}", p.x, p.y, p.z);
}

}  // namespace

std::string fingerprint(const Scene& scene)
{
    const SurfaceMesh& mesh = scene.surface;
    Hash hash;
    if (!scene.inPieces) {
        hash.add(mesh.positions);
        hash.add(mesh.normals);
        hash.add(mesh.triangles);
        hash.add(mesh.pointVectors);
        hash.add(mesh.cellVectors);
        hash.add(mesh.pointScalars);
        hash.add(mesh.cellScalars);
    }
    for (const auto& field : {scene.field, scene.scalarField})
        if (field && !field->brick) addSamples(hash, *field);
    std::string text = fmt::format("{} triangles about {}\n", scene.allTriangles, pointText(mesh.originWorld));
    if (const GridField* field = scene.field.get())
        text += fmt::format("a field of {}x{}x{} samples\nfrom {} by {}\n", field->dims[0], field->dims[1],
                            field->dims[2], pointText(field->originWorld), pointText(field->spacingWorld));
    text += fmt::format("vectors up to {}\n", scene.maxVector);
    if (scene.hasScalar)
        text += fmt::format("colours from {} to {}, robust from {} to {}\n", scene.scalarRange[0], scene.scalarRange[1],
                            scene.robustRange[0], scene.robustRange[1]);
    text += fmt::format("values with the hash {:016x}\n", hash.value());
    return text;
}

}  // namespace aeolic
