#pragma once

#include <cstdint>

#include "aeolic/picture.h"

namespace aeolic {

/// Rows of a picture that may be elsewhere as a whole. Coordinates are the whole picture's. Does not own the pixels.
struct PictureRows {
    int width = 0, height = 0;  ///< The whole picture's.
    int channels = 3;
    int firstRow = 0, rows = 0;  ///< Those that are here.
    std::uint8_t* pixels = nullptr;

    PictureRows(Picture& rowsOf, int wholeHeight, int first)
        : width(rowsOf.width),
          height(wholeHeight),
          channels(rowsOf.channels),
          firstRow(first),
          rows(rowsOf.height),
          pixels(rowsOf.pixels.data())
    {
    }
    PictureRows(Picture& whole) : PictureRows(whole, whole.height, 0) {}  // NOLINT: a picture is all of its rows.
};

}  // namespace aeolic
