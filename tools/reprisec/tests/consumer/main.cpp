// SPDX-License-Identifier: Apache-2.0
// Finds its modules where reprise_add_pack put them.
#include "reprise/pack_table.hpp"

#include <cstdio>

int main(int argc, char** argv) {
    if (argc != 2) return 2;
    const auto variant = reprise::makeVariant(reprise::packPasses(), "camera_velocity");
    if (!variant) return 3;
    const auto words = reprise::spirvFromDirectory(argv[1])(*variant, reprise::Stage::fragment);
    if (!words) {
        std::puts(words.error().message.c_str());
        return 1;
    }
    return words->empty() ? 4 : 0;
}
