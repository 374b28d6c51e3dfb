#pragma once

#include <cstdint>
#include <vector>

namespace aeolic {

/// What the pixels of a picture show, as numbers: rows from top to bottom, no padding. NaN where there is nothing to
/// tell: the background, and for flow and LIC value where no streaks show.
struct PictureBuffers {
    int width = 0, height = 0;
    std::vector<float> depth;   ///< [pixels] World units from the eye along the direction of view.
    std::vector<float> normal;  ///< [pixels * 3] Of the facet seen, towards the viewer; unit length.
    std::vector<float> flow;    ///< [pixels * 2] The way of one integration step, pixels to the right and downwards.
    std::vector<float> lic;     ///< [pixels] The streaks before contrast and light: mean 0, variance about 1.
    std::vector<float> scalar;  ///< [pixels] What is coloured by, in the data's unit; empty where there is nothing.
    /// [pixels] Which of the scene's surfaces, in the order of the description, from 0; -1 on the background.
    std::vector<std::int32_t> surface;
};

}  // namespace aeolic
