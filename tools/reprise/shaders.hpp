// SPDX-License-Identifier: Apache-2.0
// SPIR-V and reflection of every variant that a report runs: the committed one, or compiled on demand.
#pragma once

#include "reprisec.hpp"

#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace report {

// Where the pack is: beside the program in an installed or copied folder, else in the source tree.
struct Assets {
    std::filesystem::path packToml, generated;
};
Assets findAssets(); // throws a sentence when there is no pack

class Shaders {
public:
    explicit Shaders(const Assets& assets); // throws a sentence with file and line when the table is wrong

    using Request = std::pair<reprise::Variant, reprise::Stage>;
    // Compiles what is missing, on all cores.
    void prepare(std::span<const Request> requests);
    const reprisec::Compiled& get(const reprise::Variant& variant, reprise::Stage stage);
    const std::vector<uint32_t>& fullscreenVertex();
    reprise::SpirvSource source(); // must not outlive the Shaders
    const reprisec::Pack& pack() const { return pack_; }

private:
    reprisec::Compiled compileOne(const reprise::Variant& variant, reprise::Stage stage) const;

    reprisec::Pack pack_;
    reprise::SpirvSource committed_;
    std::map<std::string, reprisec::Compiled> compiled_; // by file name
};

// Any HLSL text; throws what the compiler says.
reprisec::Compiled compileText(const std::string& name, const std::string& text, reprise::Stage stage);

} // namespace report
