// SPDX-License-Identifier: Apache-2.0
// Figures that docs/documents.md quotes, and wrong forms that must not compile.
#pragma once

#include "function_runner.hpp"
#include "inputs.hpp"

#include "reprisec.hpp"

#include <gtest/gtest.h>

#include <cstdio>

namespace functions {

// Prints a figure and keeps it in the test's record.
inline void measured(const std::string& what, double value) {
    char text[32];
    std::snprintf(text, sizeof(text), "%.4g", value);
    std::printf("[ MEASURED ] %s: %s\n", what.c_str(), text);
    testing::Test::RecordProperty(what, text);
}

// Whether a text with `mainCompute` compiles.
inline bool compiles(const std::string& text) {
    return static_cast<bool>(reprisec::compileSource({.name = "listing",
                                                      .text = text,
                                                      .entry = "mainCompute",
                                                      .stage = reprise::Stage::compute,
                                                      .defines = {},
                                                      .includeDirectories = {REPRISE_HLSL_DIRECTORY}}));
}

// Rows of `inputs` float4 each, every channel taken from the list at random, after the list's values alone.
template <class List> std::vector<Row> hostileRows(const List& list, int inputs, int count, uint32_t seed) {
    Random random(seed);
    std::vector<Row> rows;
    for (float value : list)
        rows.push_back(Row(static_cast<size_t>(inputs), vec4(value)));
    for (int i = 0; i < count; ++i) {
        Row row;
        for (int k = 0; k < inputs; ++k)
            row.emplace_back(random.of(list), random.of(list), random.of(list), random.of(list));
        rows.push_back(row);
    }
    return rows;
}

// Each output of each row is a number.
inline void expectNumbers(const Function& function, const std::vector<Row>& rows) {
    expectAgrees({function, rows, [&function](const Row&) {
                      return std::vector(static_cast<size_t>(function.outputs), finite());
                  }});
}

} // namespace functions
