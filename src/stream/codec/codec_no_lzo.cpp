#include <stdexcept>

#include "stream/codec/codec_kinds.h"

namespace aeolic::stream {

// codec.cpp asks available() first; these only complete builds without AEOLIC_LZO.
void encodeLzo(const Pixels&, std::vector<std::uint8_t>&)
{
    throw std::logic_error("lzo: not in this build");
}

void decodeLzo(std::span<const std::uint8_t>, const PixelRoom&)
{
    throw std::logic_error("lzo: not in this build");
}

}  // namespace aeolic::stream
