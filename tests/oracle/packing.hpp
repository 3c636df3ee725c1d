// SPDX-License-Identifier: Apache-2.0
// Numbers in few bits, with integers: two values in a binary16, depth in 8-bit digits.
#pragma once

#include "binary16.hpp"
#include "exponential_history.hpp"

#include <array>
#include <cstdint>

namespace oracle {

// Levels of the integer part and of the fraction that 11 significant bits leave: (range + 1) * levels = 2^11.
inline double fractionStep(int range) {
    return binary16Step(range);
}

// `whole` to the nearest of range + 1 levels; `part` from 0 to the last multiple of the step below 1.
inline double packPair(double whole, double part, int range = 31) {
    return std::floor(held(whole, 0.0, 1.0) * range + 0.5) + held(part, 0.0, 1.0) * (1.0 - fractionStep(31));
}

// Key in [0,1] to the nearest of 2^16 codes.
inline int key16Code(double key) {
    return static_cast<int>(std::floor(held(key, 0.0, 1.0) * 65535.0 + 0.5));
}

// Digits of base 256, the highest first.
template <size_t Count> std::array<double, Count> digits(uint64_t code) {
    std::array<double, Count> result{};
    for (size_t i = Count; i-- > 0; code /= 256)
        result[i] = static_cast<double>(code % 256);
    return result;
}

inline double linearKey(double depth, double nearM, double farM) {
    return held((depth - nearM) / (farM - nearM), 0.0, 1.0);
}

inline double logarithmicKey(double depth, double nearM, double farM) {
    return held(std::log(std::max(depth, nearM) / nearM) / std::log(farM / nearM), 0.0, 1.0);
}

inline double depthOfLogarithmicKey(double key, double nearM, double farM) {
    return nearM * std::pow(farM / nearM, key);
}

} // namespace oracle
