// SPDX-License-Identifier: Apache-2.0
// 100,000 frames of feedback in one shader.
#pragma once

#include <string>

namespace check {

// The head of two loops, to be closed by two braces. Ten frames a turn: llvmpipe leaves its loops after
// 65,535 turns, all together.
inline constexpr int framesInAll = 100000;
inline const std::string tenThousandTurns = "[loop] for (int turn = 0; turn < 10000; ++turn) {\n"
                                            "    [unroll] for (int frame = 0; frame < 10; ++frame) {\n";

} // namespace check
