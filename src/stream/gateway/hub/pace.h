#pragma once

#include "stream/codec/codec.h"

namespace aeolic::stream {

/// What one frame took on its way to the screen.
struct FrameTiming {
    double drawMs = 0;  ///< From the request to the job until the last byte was passed on.
    double showMs = 0;  ///< From the last byte until the viewer had shown the frame.
    double bytes = 0;   ///< Bytes of the encoded frame.
    bool moving = false;
};

/// Says how large and how exact the next picture of a viewer in motion is, so that frames keep coming at `targetMs`,
/// and how a picture at rest is packed. Remembers the times of the last frames. Knows no clock and no network.
class Pace {
public:
    void add(const FrameTiming& timing);

    /// The part of the asked sides that is drawn: one of a few steps from 1 down to 1/4, so that sizes do not flicker.
    double scale() const;
    /// The quality of jpeg: lower where the network, rather than the drawing, takes the time.
    int quality() const { return quality_; }
    /// The codec for pictures at rest: LZ4 if the viewer can decode it (`lz4`) and the line takes its bytes sooner than
    /// PNG makes fewer bytes; else PNG.
    Codec lossless(bool lz4) const;

    static constexpr double targetMs = 42;  ///< 24 frames a second. 20 are promised; the rest is room.

private:
    bool shrink();
    bool grow();
    /// The measured times belong to another size. Until there are new ones, this size counts as right.
    void forget() { drawMs_ = showMs_ = kUnknownMs; }

    int step_ = 0;
    int quality_ = 80;
    int calm_ = 0, calmNeeded_ = 6;  ///< Frames in a row that would have allowed the next larger step.
    int sinceGrowth_ = 1000;         ///< Frames since the last growth.
    static constexpr double kUnknownMs = 0.8 * targetMs;
    double drawMs_ = kUnknownMs, showMs_ = kUnknownMs;  ///< Running means.
    double bytesPerMs_ = 0;                             ///< 0: not known.
};

}  // namespace aeolic::stream
