// SPDX-License-Identifier: Apache-2.0
// A copy of hlsl/ with texts replaced, as a pack of its own: wrong forms that a test must catch, and forms
// for a device that is not there.
#pragma once

#include "reprisec.hpp"

namespace passes {

struct TextChange {
    std::string_view file, original, replacement;
};

class ChangedPack {
public:
    explicit ChangedPack(std::span<const TextChange> changes);
    ~ChangedPack();
    ChangedPack(const ChangedPack&) = delete;
    ChangedPack& operator=(const ChangedPack&) = delete;

    // Empty, or the text that is no longer there: the change has to follow.
    const std::string& missing() const { return missing_; }
    const reprisec::Pack& pack() const { return *pack_; }
    const std::filesystem::path& directory() const { return directory_; }

private:
    std::filesystem::path directory_;
    std::string missing_;
    std::optional<reprisec::Pack> pack_;
};

} // namespace passes
