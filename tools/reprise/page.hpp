// SPDX-License-Identifier: Apache-2.0
// The report as one HTML file without external resources.
#pragma once

#include "results.hpp"

#include <span>
#include <string>
#include <string_view>

namespace report {

std::string pageHtml(const Report& report);
std::string base64(std::span<const uint8_t> bytes);
// Letters, digits, _ and -: what a file name and an id may hold.
std::string fileName(std::string_view text);

} // namespace report
