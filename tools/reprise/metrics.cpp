// SPDX-License-Identifier: Apache-2.0
#include "metrics.hpp"

#include <algorithm>
#include <cmath>

namespace report {

uint64_t countNotFinite(std::span<const float> values) {
    uint64_t count = 0;
    for (float v : values)
        count += std::isfinite(v) ? 0u : 1u;
    return count;
}

Difference difference(std::span<const float> reference, std::span<const float> test) {
    double sum = 0.0;
    float largest = 0.0f;
    for (size_t i = 0; i < reference.size(); ++i) {
        const float d = std::abs(test[i] - reference[i]);
        sum += static_cast<double>(d) * static_cast<double>(d);
        largest = std::max(largest, d);
    }
    const double n = static_cast<double>(std::max<size_t>(reference.size(), 1));
    return {std::sqrt(sum / n), static_cast<double>(largest)};
}

void Flicker::add(std::span<const float> previousReference, std::span<const float> reference,
                  std::span<const float> previousTest, std::span<const float> test) {
    for (size_t i = 0; i < reference.size(); ++i) {
        const float d = (test[i] - previousTest[i]) - (reference[i] - previousReference[i]);
        sum_ += static_cast<double>(d) * static_cast<double>(d);
    }
    count_ += reference.size();
}

double Flicker::value() const {
    return count_ == 0 ? 0.0 : std::sqrt(sum_ / static_cast<double>(count_));
}

} // namespace report
