// SPDX-License-Identifier: Apache-2.0
// SPIR-V and reflection of every variant that a report runs: the committed one, or compiled on demand.
#pragma once

#include "reprisec.hpp"

#include <filesystem>
#include <map>
#include <optional>
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
    // Throws a sentence with file and line when the table is wrong. fresh: committed modules are not used.
    explicit Shaders(const Assets& assets, bool fresh = false);
    using Request = std::pair<reprise::Variant, reprise::Stage>;
    // Compiles what is missing, on all cores.
    void prepare(std::span<const Request> requests);
    const reprisec::Compiled& get(const reprise::Variant& variant, reprise::Stage stage);
    const std::vector<uint32_t>& fullscreenVertex();
    reprise::SpirvSource source(); // must not outlive the Shaders
    const reprisec::Pack& pack() const { return pack_; }

private:
    reprisec::Compiled make(const reprise::Variant& variant, reprise::Stage stage) const;

    reprisec::Pack pack_;
    std::filesystem::path generated_;
    bool fresh_;
    std::map<std::string, reprisec::Compiled> compiled_; // by file name
};

// SPIR-V and reflection of a committed module; nothing when it is not there.
std::optional<reprisec::Compiled> readCommitted(const std::filesystem::path& generated,
                                                const reprise::Variant& variant, reprise::Stage stage);
// Any HLSL text; throws what the compiler says.
reprisec::Compiled compileText(const std::string& name, const std::string& text, reprise::Stage stage);

} // namespace report
