#pragma once

#include "stream/codec.h"

namespace aeolic::stream {

/// What one frame took on its way to the screen.
struct FrameTiming {
    double drawMs = 0;  ///< From the request to the job until the last byte was passed on.
    double showMs = 0;  ///< From then until the viewer had shown it.
    double pixels = 0;  ///< Drawn.
    double bytes = 0;   ///< Encoded.
    bool moving = false;
};

/// How large and how exact the next picture of a viewer in motion is, so that frames keep coming at `targetMs`; and
/// how a picture at rest is packed. Remembers what the last frames took. Pure: no clock, no network.
class Pace {
public:
    void add(const FrameTiming& timing);

    /// Of the sides asked for: one of a few steps from 1 down to 1/4, so that sizes do not flicker.
    double scale() const;
    /// Of jpeg: lower where the network, rather than the drawing, takes the time.
    int quality() const { return quality_; }
    /// For pictures at rest: LZ4, where `lz4` says that it can be decoded and the line takes its bytes sooner than PNG
    /// packs smaller ones; else PNG.
    Codec lossless(bool lz4) const;

    static constexpr double targetMs = 42;  ///< 24 frames a second: some room above the 20 that are promised.

private:
    bool shrink();
    bool grow();
    void forget();

    int step_ = 0;
    int quality_ = 80;
    int calm_ = 0, calmNeeded_ = 6;  ///< Frames in a row that would have allowed the next larger step.
    int sinceGrowth_ = 1000;         ///< Frames.
    static constexpr double kUnknownMs = 0.8 * targetMs;
    double drawMs_ = kUnknownMs, showMs_ = kUnknownMs;  ///< Running means.
    double bytesPerMs_ = 0;                             ///< 0: not known.
};

}  // namespace aeolic::stream
