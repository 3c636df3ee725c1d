// SPDX-License-Identifier: Apache-2.0
// Forms as the documents print them: what the compiler says to them.
#pragma once

#include "function_runner.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace functions {

// Empty where the function compiles and runs. Textures need no rows of their own.
inline std::string compileError(const Function& function) {
    try {
        run(function, {Row(static_cast<size_t>(function.inputs), vec4(0.0f))}, {.extent = {1, 1}});
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return {};
}

// `says`: what the message names, so that another mistake in the text is not taken for the printed one.
inline void expectDoesNotCompile(const Function& function, const std::string& says) {
    const std::string message = compileError(function);
    EXPECT_NE(message, "") << function.name << " compiles";
    EXPECT_NE(message.find(says), std::string::npos) << message;
}

} // namespace functions
