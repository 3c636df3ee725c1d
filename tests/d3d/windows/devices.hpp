// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "compiler.hpp"

#include <functional>
#include <memory>

namespace d3d {

// Compiled code of a shader job, by name; throws where it did not compile.
using Code = std::function<ID3DBlob*(const std::string& shader)>;

class Device {
public:
    virtual ~Device() = default;
    // What each target holds after the run.
    virtual std::vector<Texels> run(const RunJob& job, const Code& code) = 0;
    virtual std::string name() const = 0;
};

std::unique_ptr<Device> openDevice9();
std::unique_ptr<Device> openDevice11();

} // namespace d3d
