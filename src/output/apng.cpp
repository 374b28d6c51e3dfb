#include <zlib.h>

#include <cmath>
#include <cstdint>
#include <string_view>
#include <utility>

#include "output/animation.h"
#include "output/new_file.h"

// Animated PNG (PNG Specification, third edition, 2025, section 4.9): the chunks of the frames' PNG files, with others
// around them. Viewers that do not know them show the first frame.
namespace aeolic {
namespace {

constexpr std::size_t kSignatureBytes = 8, kChunkBytes = 12;  // A chunk: length, type, data, checksum.

std::string bigEndian(std::uint32_t value)
{
    return {char(value >> 24), char(value >> 16), char(value >> 8), char(value)};
}
std::string bigEndian16(unsigned value)
{
    return {char(value >> 8), char(value)};
}

std::uint32_t numberAt(std::string_view bytes, std::size_t at)
{
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) value = value << 8 | static_cast<unsigned char>(bytes[at + i]);
    return value;
}

std::string chunk(std::string_view type, std::string_view data)
{
    std::string checked(type);
    checked += data;
    const auto sum = crc32_z(0, reinterpret_cast<const Bytef*>(checked.data()), checked.size());
    return bigEndian(std::uint32_t(data.size())) + checked + bigEndian(std::uint32_t(sum));
}

/// Calls visit(type, data, whole chunk) for the chunks of a PNG file that we wrote ourselves.
template <class Visit>
void forEachChunk(std::string_view file, const Visit& visit)
{
    for (std::size_t at = kSignatureBytes; at + kChunkBytes <= file.size();) {
        const std::size_t bytes = numberAt(file, at);
        visit(file.substr(at + 4, 4), file.substr(at + 8, bytes), file.substr(at, bytes + kChunkBytes));
        at += bytes + kChunkBytes;
    }
}

/// How long a frame is shown, in seconds, as a fraction of 16-bit numbers.
std::string delayOf(double framesPerSecond)
{
    if (framesPerSecond == std::floor(framesPerSecond)) return bigEndian16(1) + bigEndian16(unsigned(framesPerSecond));
    return bigEndian16(unsigned(std::lround(1000 / framesPerSecond))) + bigEndian16(1000);
}

class Apng : public Animation {
public:
    explicit Apng(const AnimationPlan& plan) : plan_(plan), file_(plan.path) {}

    void add(const Picture& picture) override
    {
        const std::string png = pngOf(picture, plan_.path);
        const bool first = sequence_ == 0;
        if (first) {
            size_ = bigEndian(std::uint32_t(picture.width)) + bigEndian(std::uint32_t(picture.height));
            file_.write(std::string_view(png).substr(0, kSignatureBytes));
        }
        bool begun = false;
        forEachChunk(png, [&](std::string_view type, std::string_view data, std::string_view whole) {
            if (type == "IDAT") {
                if (!std::exchange(begun, true)) file_.write(frameControl());
                file_.write(first ? std::string(whole) : chunk("fdAT", bigEndian(sequence_++) + std::string(data)));
            } else if (first && type != "IEND") {
                file_.write(whole);
                if (type == "IHDR")  // 0: for ever.
                    file_.write(chunk("acTL", bigEndian(std::uint32_t(plan_.frames)) + bigEndian(0)));
            }
        });
    }

    void complete() override
    {
        file_.write(chunk("IEND", ""));
        file_.complete();
    }

private:
    /// The whole picture, in the place of the one before.
    std::string frameControl()
    {
        const std::string place = bigEndian(0) + bigEndian(0), replaces{'\0', '\0'};
        return chunk("fcTL", bigEndian(sequence_++) + size_ + place + delayOf(plan_.framesPerSecond) + replaces);
    }

    AnimationPlan plan_;
    NewFile file_;
    std::string size_;
    std::uint32_t sequence_ = 0;  // Of the chunks that frames after the first are made of.
};

}  // namespace

std::unique_ptr<Animation> makeApng(const AnimationPlan& plan)
{
    return std::make_unique<Apng>(plan);
}

}  // namespace aeolic
