// SPDX-License-Identifier: Apache-2.0
// Outcomes as lines and as JSON.
#include "check.hpp"

#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace check {
namespace {

using Json = nlohmann::ordered_json;

const char* unitText(Unit unit) {
    switch (unit) {
    case Unit::exact:
        return "exact";
    case Unit::absolute:
        return "absolute";
    case Unit::relative:
        return "relative";
    case Unit::ulp:
        return "ulp";
    case Unit::roundings:
        return "roundings";
    case Unit::finite:
        break;
    }
    return "finite";
}

// JSON has no NaN and no infinity: those are words.
Json number(double value) {
    if (std::isfinite(value)) return value;
    return std::isnan(value) ? "nan" : value > 0.0 ? "inf" : "-inf";
}

// The fewest digits that give the number back.
Json number(float value) {
    if (!std::isfinite(value)) return number(static_cast<double>(value));
    return Json::parse(fmt::format("{}", value));
}

Json inputJson(const Row& input) {
    Json rows = Json::array();
    for (const vec4& in : input)
        rows.push_back({number(in.x), number(in.y), number(in.z), number(in.w)});
    return rows;
}

Json worstJson(const Worst& worst) {
    if (worst.input.empty()) return nullptr;
    return {{"value", number(worst.value)},
            {"input", inputJson(worst.input)},
            {"output", number(worst.actual)},
            {"expected", number(worst.expected)}};
}

bool hasShare(const Bound& bound) {
    return bound.unit != Unit::exact && bound.unit != Unit::finite;
}

Json rowJson(const Case& checked, const std::string& form, const Tally& tally) {
    const Bound& bound = checked.bound;
    Json row = {
        {"function", checked.function()},
        {"header", checked.header()},
        {"sweep", checked.sweep},
        {"form", form},
        {"inputs", tally.inputs},
        {"open", tally.open},
        {"nan", tally.nan},
        {"infinity", tally.infinity},
        {"first_not_finite", tally.firstNotFinite.empty() ? Json(nullptr) : inputJson(tally.firstNotFinite)},
        {"absolute", worstJson(tally.absolute)},
        {"relative", worstJson(tally.relative)},
        {"ulp", worstJson(tally.ulp)},
        {"bound", {{"unit", unitText(bound.unit)}, {"value", bound.value}, {"reason", bound.reason}}},
        {"share_of_bound", hasShare(bound) ? number(tally.share.value) : Json(nullptr)},
        {"holds", tally.nan == 0 && tally.infinity == 0 && tally.share.value <= 1.0}};
    return row;
}

std::string cell(const Worst& worst) {
    return worst.input.empty() ? "-" : worst.value == 0.0 ? "0" : fmt::format("{:.2g}", worst.value);
}

// Trailing zeros of a float4 are what the row did not use; long rows end in dots.
std::string inputText(const Row& input) {
    std::string text;
    for (const vec4& in : input) {
        int used = 4;
        while (used > 1 && in[used - 1] == 0.0f)
            --used;
        text += text.empty() ? "(" : " (";
        for (int c = 0; c < used; ++c)
            text += fmt::format("{}{:.6g}", c > 0 ? ", " : "", in[c]);
        text += ")";
    }
    constexpr size_t most = 72;
    return text.size() <= most ? text : text.substr(0, most) + "...";
}

const Row& whereWorst(const Tally& tally) {
    if (!tally.firstNotFinite.empty()) return tally.firstNotFinite;
    return tally.share.value > 0.0 ? tally.share.input : tally.ulp.input;
}

std::string line(const std::string& function, const std::string& header, const std::string& sweep,
                 const Tally& tally, const std::string& share) {
    return fmt::format("{:<26} {:<22} {:<52} {:>7} {:>6} {:>8} {:>8} {:>8} {:>7} {:>5} {:>5}  {}", function,
                       header, sweep, tally.inputs, tally.open, cell(tally.absolute), cell(tally.relative),
                       cell(tally.ulp), share, tally.nan, tally.infinity, inputText(whereWorst(tally)));
}

} // namespace

std::string boundText(const Bound& bound) {
    switch (bound.unit) {
    case Unit::exact:
    case Unit::finite:
        break;
    case Unit::absolute:
    case Unit::relative:
        return fmt::format("{:.3g} {}", bound.value, unitText(bound.unit));
    case Unit::ulp:
        return fmt::format("{:.3g} ULP", bound.value);
    case Unit::roundings:
        return fmt::format("{:.3g} roundings", bound.value);
    }
    return unitText(bound.unit);
}

std::string failure(const Outcome& outcome) {
    const Case& checked = *outcome.checked;
    const Tally& tally = outcome.pack;
    std::string what;
    if (tally.nan > 0) what += fmt::format("NaN for {} inputs", tally.nan);
    if (tally.infinity > 0)
        what += fmt::format("{}infinity for {} inputs", what.empty() ? "" : ", ", tally.infinity);
    if (tally.share.value > 1.0)
        what += fmt::format("{}an error above its bound ({})", what.empty() ? "" : ", ",
                            boundText(checked.bound));
    return what.empty() ? what : fmt::format("{} ({}): {}", checked.function(), checked.sweep, what);
}

std::string tableHead() {
    return fmt::format("{:<26} {:<22} {:<52} {:>7} {:>6} {:>8} {:>8} {:>8} {:>7} {:>5} {:>5}  {}", "function",
                       "header", "sweep", "inputs", "open", "absolute", "relative", "ULP", "/bound", "NaN",
                       "inf", "worst at");
}

std::vector<std::string> tableLines(const Outcome& outcome) {
    const Case& checked = *outcome.checked;
    const std::string header = std::filesystem::path(checked.header()).stem().string();
    const std::string share = hasShare(checked.bound) ? fmt::format("{:.2g}", outcome.pack.share.value)
                              : checked.bound.unit == Unit::exact
                                  ? (outcome.pack.share.value > 0.0 ? "above" : "exact")
                                  : "finite";
    std::vector<std::string> lines{line(checked.function(), header, checked.sweep, outcome.pack, share)};
    if (outcome.printed)
        lines.push_back(line("  printed", header, checked.printed->where, *outcome.printed, "-"));
    return lines;
}

std::string jsonText(const DeviceInfo& device, const std::vector<Outcome>& outcomes, bool quick) {
    std::vector<std::string> rows;
    for (const Outcome& outcome : outcomes) {
        rows.push_back(rowJson(*outcome.checked, "pack", outcome.pack).dump());
        if (!outcome.printed) continue;
        Json row = rowJson(*outcome.checked, "printed", *outcome.printed);
        row["printed_in"] = outcome.checked->printed->where;
        rows.push_back(row.dump());
    }
    const Json head = {{"name", device.name}, {"driver", device.driver}, {"type", device.type}};
    return fmt::format("{{\"schema\": 1, \"device\": {}, \"quick\": {},\n\"rows\": [\n{}\n]}}\n", head.dump(),
                       quick, fmt::join(rows, ",\n"));
}

} // namespace check
