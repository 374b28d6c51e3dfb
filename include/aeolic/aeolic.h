#pragma once

/// Everything a program needs to draw flow on surfaces with Aeolic. See docs/library.md for a ten-line example.

#include "aeolic/buffers.h"
#include "aeolic/data.h"
#include "aeolic/error.h"
#include "aeolic/live.h"
#include "aeolic/pick.h"
#include "aeolic/picture.h"
#include "aeolic/plane.h"
#include "aeolic/renderer.h"
#include "aeolic/scene_description.h"
#include "aeolic/streamlines.h"
#include "aeolic/surface_spec.h"
#include "aeolic/topology.h"
