// SPDX-License-Identifier: Apache-2.0
#include "check.hpp"

#include <algorithm>
#include <regex>
#include <set>
#include <sstream>

namespace check {

std::vector<PublicFunction> publicFunctions(const std::filesystem::path& hlsl) {
    // A type and a name before a parenthesis, at the start of a line: statements are indented, and a constant
    // has a second word before its name.
    static const std::regex definition(R"(^[A-Za-z_]\w*\s+([A-Za-z_]\w*)\()");
    std::set<std::string> files;
    for (const auto& entry : std::filesystem::directory_iterator(hlsl / "reprise"))
        if (entry.path().extension() == ".hlsli") files.insert(entry.path().filename().string());
    std::vector<PublicFunction> found;
    for (const std::string& file : files) {
        std::istringstream text(functions::hlslText(hlsl, "reprise/" + file));
        for (std::string line; std::getline(text, line);) {
            std::smatch match;
            if (!std::regex_search(line, match, definition)) continue;
            const PublicFunction function{"reprise/" + file, match[1]};
            if (std::find(found.begin(), found.end(), function) == found.end()) found.push_back(function);
        }
    }
    return found;
}

std::vector<PublicFunction> withoutCase(const std::vector<PublicFunction>& functions,
                                        const std::vector<Case>& cases) {
    std::vector<PublicFunction> missing;
    for (const PublicFunction& function : functions)
        if (std::none_of(cases.begin(), cases.end(), [&](const Case& each) {
                return PublicFunction{each.header(), each.function()} == function;
            }))
            missing.push_back(function);
    return missing;
}

} // namespace check
