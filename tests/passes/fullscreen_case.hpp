// SPDX-License-Identifier: Apache-2.0
// The full-screen triangle with a fragment shader that writes where it is.
#pragma once

#include "comparison.hpp"

namespace passes {

// What each pixel wrote, from the fullscreen pass's vertex shader, against its centre. A pixel that the
// triangle does not cover keeps its NaN.
Comparison comparePositions(int width, int height);

} // namespace passes
