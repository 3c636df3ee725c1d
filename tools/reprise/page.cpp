// SPDX-License-Identifier: Apache-2.0
#include "page.hpp"
#include "page_template.hpp" // made by CMake from page/

namespace report {
namespace {

// Inside a script element only "</" and "<!--" could end it early.
std::string forScript(const std::string& json) {
    std::string text;
    for (char c : json)
        c == '<' ? text += "\\u003c" : text += c;
    return text;
}

Json picturesJson(const Report& report) {
    Json json = Json::object();
    for (const Pictures& pictures : report.pictures) {
        Json scene = {{"frame", pictures.frame}, {"images", Json::object()}};
        for (const auto& [name, png] : pictures.png)
            scene["images"][name] = "data:image/png;base64," + base64(png);
        json[pictures.scene] = std::move(scene);
    }
    return json;
}

void replace(std::string& text, std::string_view mark, std::string_view with) {
    const size_t at = text.find(mark);
    if (at != std::string::npos) text.replace(at, mark.size(), with);
}

} // namespace

std::string base64(std::span<const uint8_t> bytes) {
    static constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (size_t i = 0; i < bytes.size(); i += 3) {
        const size_t left = bytes.size() - i;
        const uint32_t group = static_cast<uint32_t>(bytes[i]) << 16 |
                               (left > 1 ? static_cast<uint32_t>(bytes[i + 1]) << 8 : 0u) |
                               (left > 2 ? static_cast<uint32_t>(bytes[i + 2]) : 0u);
        text += digits[group >> 18];
        text += digits[(group >> 12) & 63u];
        text += left > 1 ? digits[(group >> 6) & 63u] : '=';
        text += left > 2 ? digits[group & 63u] : '=';
    }
    return text;
}

std::string pageHtml(const Report& report) {
    std::string html(pageTemplate);
    replace(html, "/*style*/", pageStyle);
    replace(html, "/*charts*/", pageCharts);
    replace(html, "/*script*/", pageScript);
    replace(html, "/*pictures*/", forScript(picturesJson(report).dump()));
    replace(html, "/*data*/", forScript(toJson(report).dump()));
    return html;
}

} // namespace report
