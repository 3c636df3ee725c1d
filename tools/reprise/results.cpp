// SPDX-License-Identifier: Apache-2.0
#include "results.hpp"
#include "page.hpp"

#include <algorithm>
#include <fstream>
#include <stdexcept>

#include <fmt/format.h>
#include <unistd.h>

namespace report {
namespace fs = std::filesystem;

Timing timingOf(std::vector<double> samples) {
    std::sort(samples.begin(), samples.end());
    const size_t n = samples.size();
    const double median = n % 2 == 1 ? samples[n / 2] : 0.5 * (samples[n / 2 - 1] + samples[n / 2]);
    return {samples.front(), median, samples.back(), static_cast<uint32_t>(n)};
}

namespace {

bool comparable(const Row& a, const Row& b) {
    return a.technique == b.technique && a.scene == b.scene && a.stage == b.stage;
}

// The error that a front is of: FLIP of colours, RMSE of scalars.
std::optional<double> frontError(const Row& row) {
    return row.error.flip ? row.error.flip : row.errorUnit == "visibility" ? row.error.rmse : std::nullopt;
}

bool dominates(const Row& a, const Row& b) {
    const double ta = a.gpu->median, tb = b.gpu->median, ea = *frontError(a), eb = *frontError(b);
    return ta <= tb && ea <= eb && (ta < tb || ea < eb);
}

template <class T> Json orNull(const std::optional<T>& value) {
    return value ? Json(*value) : Json(nullptr);
}

Json orNull(const std::string& text) {
    return text.empty() ? Json(nullptr) : Json(text);
}

Json timingJson(const Timing& t) {
    return {{"min", t.min}, {"median", t.median}, {"max", t.max}, {"samples", t.samples}};
}

Json rowJson(const Row& row) {
    Json passes = Json::array();
    for (const PassTime& pass : row.passes)
        passes.push_back({{"name", pass.name}, {"gpu_ms", pass.gpuMs}});
    Json json;
    json["technique"] = row.technique;
    json["variant"] = row.variant;
    json["file"] = orNull(row.file);
    json["scene"] = row.scene;
    json["stage"] = orNull(row.stage);
    json["jitter"] = orNull(row.jitter);
    json["width"] = row.width;
    json["height"] = row.height;
    json["error_width"] = row.errorWidth;
    json["error_height"] = row.errorHeight;
    json["frames"] = row.frames;
    json["gpu_ms"] = row.gpu ? timingJson(*row.gpu) : Json(nullptr);
    json["floor_ms"] = orNull(row.floorMs);
    json["efficiency"] = orNull(row.efficiency);
    json["per_nine_taps"] = orNull(row.perNineTaps);
    json["per_copy"] = orNull(row.perCopy);
    json["passes"] = std::move(passes);
    json["memory_bytes"] = orNull(row.memoryBytes);
    json["trailing_frames"] = orNull(row.trailingFrames);
    json["rejected_frames"] = orNull(row.rejectedFrames);
    json["reads_per_pixel"] = orNull(row.readsPerPixel);
    json["error"] = {{"flip", orNull(row.error.flip)},
                     {"rmse", orNull(row.error.rmse)},
                     {"max", orNull(row.error.max)},
                     {"flicker", orNull(row.error.flicker)}};
    json["error_unit"] = orNull(row.errorUnit);
    json["not_finite"] = row.notFinite;
    json["reference"] = orNull(row.reference);
    json["per_frame"] = {{"flip", row.flipPerFrame}, {"rmse", row.rmsePerFrame}};
    json["pareto"] = orNull(row.pareto);
    return json;
}

Json claimJson(const Claim& claim) {
    return {{"id", claim.id},
            {"document", claim.document},
            {"claim", claim.claim},
            {"published", orNull(claim.published)},
            {"measured", claim.measured},
            {"holds", orNull(claim.holds)}};
}

std::string csvText(const std::string& text) {
    if (text.find_first_of(",\"\n") == std::string::npos) return text;
    std::string quoted = "\"";
    for (char c : text)
        quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
    return quoted + '"';
}

template <class T> std::string csvNumber(const std::optional<T>& value) {
    return value ? fmt::format("{}", *value) : std::string();
}

std::string csvRow(const Row& r) {
    std::optional<double> min, median, max;
    if (r.gpu) min = r.gpu->min, median = r.gpu->median, max = r.gpu->max;
    return fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n",
                       csvText(r.technique), csvText(r.variant), csvText(r.scene), r.stage, r.jitter, r.width,
                       r.height, r.frames, csvNumber(min), csvNumber(median), csvNumber(max),
                       csvNumber(r.floorMs), csvNumber(r.efficiency), csvNumber(r.memoryBytes),
                       csvNumber(r.readsPerPixel), csvNumber(r.error.flip), csvNumber(r.error.rmse),
                       csvNumber(r.error.max), csvNumber(r.error.flicker), csvNumber(r.trailingFrames),
                       r.notFinite, r.pareto ? (*r.pareto ? "1" : "0") : "");
}

// A directory beside the final one, so that the rename stays on one file system.
fs::path besides(const fs::path& out, std::string_view suffix) {
    fs::path full = fs::absolute(out).lexically_normal();
    if (!full.has_filename()) full = full.parent_path();
    return full.parent_path() / fmt::format(".{}.{}-{}", full.filename().string(), suffix, ::getpid());
}

// Only a directory that an earlier report made may be replaced: anything else is somebody's work.
bool replaceable(const fs::path& out) {
    return fs::exists(out / "report.json") || fs::is_empty(out);
}

void writeAll(const Report& report, const fs::path& folder) {
    writeFile(folder / "report.json", toJson(report).dump(1) + "\n");
    writeFile(folder / "report.csv", toCsv(report));
    writeFile(folder / "index.html", pageHtml(report));
    for (const Pictures& pictures : report.pictures)
        for (const auto& [name, png] : pictures.png)
            writeFile(folder / fmt::format("{}-{}.png", fileName(pictures.scene), fileName(name)),
                      {reinterpret_cast<const char*>(png.data()), png.size()});
}

} // namespace

void markPareto(std::vector<Row>& rows) {
    const auto complete = [](const Row& r) { return r.gpu && frontError(r); };
    for (Row& row : rows) {
        if (!complete(row)) continue;
        row.pareto = std::none_of(rows.begin(), rows.end(), [&](const Row& other) {
            return complete(other) && comparable(other, row) && dominates(other, row);
        });
    }
}

Json toJson(const Report& report) {
    Json json;
    json["schema"] = 1;
    json["device"] = report.device;
    json["settings"] = report.settings;
    json["floors"] = Json::array();
    for (const Floor& f : report.floors)
        json["floors"].push_back(
            {{"name", f.name}, {"gpu_ms", timingJson(f.gpu)}, {"ns_per_pixel", f.nsPerPixel}});
    json["rows"] = Json::array();
    for (const Row& row : report.rows)
        json["rows"].push_back(rowJson(row));
    json["claims"] = Json::array();
    for (const Claim& claim : report.claims)
        json["claims"].push_back(claimJson(claim));
    return json;
}

std::string toCsv(const Report& report) {
    std::string csv =
        "technique,variant,scene,stage,jitter,width,height,frames,gpu_ms_min,gpu_ms_median,gpu_ms_max,"
        "floor_ms,efficiency,memory_bytes,reads_per_pixel,flip,rmse,max,flicker,trailing_frames,not_finite,"
        "pareto\n";
    for (const Row& row : report.rows)
        csv += csvRow(row);
    return csv;
}

std::string fileName(std::string_view text) {
    std::string name;
    for (char c : text) {
        const bool plain =
            (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
        name += plain ? c : '-';
    }
    return name;
}

void writeFile(const fs::path& file, std::string_view bytes) {
    std::ofstream stream(file, std::ios::binary);
    stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    stream.close();
    if (!stream)
        throw std::runtime_error(fmt::format(
            "{} cannot be written: its directory is missing, not yours to write to, or full", file.string()));
}

void checkWritable(const fs::path& out) {
    std::error_code error;
    if (out.empty()) throw std::runtime_error("--out is empty; name a directory");
    if (fs::exists(out) && !fs::is_directory(out))
        throw std::runtime_error(fmt::format("--out {} is a file; name a directory", out.string()));
    if (fs::exists(out) && !replaceable(out))
        throw std::runtime_error(fmt::format(
            "--out {} holds files that are no report and would be lost; name a new directory", out.string()));
    const fs::path probe = besides(out, "probe");
    fs::create_directories(probe, error);
    if (error || ::access(probe.c_str(), W_OK) != 0)
        throw std::runtime_error(
            fmt::format("--out {} cannot be created: {}; name a directory you may write to", out.string(),
                        error ? error.message() : "permission denied"));
    fs::remove(probe, error);
}

void writeReport(const Report& report, const fs::path& out) {
    const fs::path fresh = besides(out, "new"), old = besides(out, "old");
    try {
        fs::create_directories(fresh);
        writeAll(report, fresh);
        if (fs::exists(out)) fs::rename(out, old);
        fs::rename(fresh, fs::absolute(out).lexically_normal());
        fs::remove_all(old);
    } catch (...) {
        std::error_code ignored;
        fs::remove_all(fresh, ignored);
        if (fs::exists(old) && !fs::exists(out)) fs::rename(old, out, ignored);
        throw;
    }
}

} // namespace report
