// SPDX-License-Identifier: Apache-2.0
// Functions of the HLSL headers on the device that the tests of this program share.
#pragma once

#include "hlsl_functions.hpp"
#include "oracle.hpp"

namespace functions {

// As in hlsl_functions.hpp, on the shared device.
std::vector<Row> run(const Function& function, const std::vector<Row>& inputs,
                     const RunOptions& options = {});
std::string mismatches(const Comparison& comparison, const Mutation& mutation = {});
std::string hlslText(const std::string& file);

// GoogleTest: the oracle agrees; the oracle tells a mutation.
void expectAgrees(const Comparison& comparison);
void expectCaught(const Comparison& comparison, const Mutation& mutation);

} // namespace functions
