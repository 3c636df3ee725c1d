// SPDX-License-Identifier: Apache-2.0
// Every function of hlsl/reprise again in double precision, written from the documents' mathematics and the
// contracts of the headers. Tests compare with it; it includes nothing of the project.
#pragma once

#include "bilateral_upsampling.hpp"
#include "binary16.hpp"
#include "blend.hpp"
#include "cache_resampling.hpp"
#include "colour.hpp"
#include "directional_bilateral.hpp"
#include "exponential_history.hpp"
#include "image.hpp"
#include "jitter.hpp"
#include "miss_detection.hpp"
#include "neighbourhood.hpp"
#include "packing.hpp"
#include "refresh.hpp"
#include "reprojection.hpp"
#include "reprojection_cache.hpp"
#include "resampling.hpp"
#include "tone_mapping.hpp"
