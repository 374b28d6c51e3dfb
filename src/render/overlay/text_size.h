#pragma once

namespace aeolic {

/// The usual size of text in a picture of that size, pixels of the em square. Everything drawn over a picture is in
/// proportion to it.
double textSize(int width, int height);

/// The text scale of a picture that is shown stretched to the size of a full one, which has `textScale`: text is as
/// large there, but not smaller than can be read. At most `textScale`.
double textScaleOfSmaller(double textScale, int smallWidth, int smallHeight, int fullWidth, int fullHeight);

}  // namespace aeolic
