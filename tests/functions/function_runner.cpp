// SPDX-License-Identifier: Apache-2.0
#include "function_runner.hpp"

#include <gtest/gtest.h>

namespace functions {

namespace {

const Bench& bench() {
    static harness::Gpu gpu(harness::DeviceOptions{.device = "", .validation = true});
    static const Bench shared{gpu, REPRISE_HLSL_DIRECTORY};
    return shared;
}

} // namespace

std::vector<Row> run(const Function& function, const std::vector<Row>& inputs, const RunOptions& options) {
    return run(bench(), function, inputs, options);
}

std::string mismatches(const Comparison& comparison, const Mutation& mutation) {
    return mismatches(bench(), comparison, mutation);
}

std::string hlslText(const std::string& file) {
    return hlslText(bench().hlsl, file);
}

void expectAgrees(const Comparison& comparison) {
    EXPECT_EQ(mismatches(comparison), "");
}

void expectCaught(const Comparison& comparison, const Mutation& mutation) {
    ASSERT_EQ(mismatches(comparison), "") << "the right form must agree for the wrong one to be told";
    EXPECT_NE(mismatches(comparison, mutation), "")
        << "\"" << mutation.replacement << "\" for \"" << mutation.find << "\" passes unnoticed";
}

} // namespace functions
