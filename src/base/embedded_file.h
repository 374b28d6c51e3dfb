#pragma once

#include <cstddef>
#include <string_view>

namespace aeolic {

/// A file as bytes in the program. cmake/embed.cmake makes tables of them, which end with a null name.
struct EmbeddedFile {
    const char *name, *begin, *end;

    std::string_view bytes() const { return {begin, std::size_t(end - begin)}; }
};

}  // namespace aeolic
