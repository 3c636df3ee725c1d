// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "experiment.hpp"

namespace report {

// Claims about what the framework caches; none when the plan measures nothing of it.
std::vector<Claim> judgeLighting(const Report& report, const Plan& plan);

} // namespace report
