// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hlsl_functions.hpp"

namespace functions {

inline constexpr uint32_t inputBinding = 1, textureBinding = 4, samplerDistance = 32, outputBinding = 16;
inline constexpr uint32_t rowLength = 64, groupSide = 8;

// Entry mainCompute or mainFragment.
std::string shaderText(const std::filesystem::path& hlsl, const Function& function, const Mutation& mutation);

} // namespace functions
