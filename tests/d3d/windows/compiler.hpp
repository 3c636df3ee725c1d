// SPDX-License-Identifier: Apache-2.0
// Microsoft's HLSL compiler, d3dcompiler_47.dll.
#pragma once

#include "jobs.hpp"

#include <d3dcompiler.h>
#include <wrl/client.h>

namespace d3d {

using Microsoft::WRL::ComPtr;

// Throws a Failure that says what could not be done.
void check(HRESULT result, const std::string& what);

// Throws a Failure with the compiler's messages.
ComPtr<ID3DBlob> compile(const ShaderJob& job);
ComPtr<ID3DBlob> compileText(const ShaderJob& job, const std::string& text);
// The text with includes and macros expanded; lines "#line N "FILE"" say where what follows stands.
std::string preprocess(const HeaderJob& job);

// Calls every function that the header defines, each from a shader of its own. One line a function:
// "NAME ok" or "NAME failed MESSAGE".
std::vector<std::string> compileFunctions(const HeaderJob& job);

} // namespace d3d
