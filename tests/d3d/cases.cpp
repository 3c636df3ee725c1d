// SPDX-License-Identifier: Apache-2.0
#include "cases.hpp"

#include "internal.hpp"

#include <algorithm>
#include <cstring>
#include <limits>
#include <regex>
#include <set>

namespace d3d {

namespace {

using passes::pack;
using passes::Pixels;

const fs::path hlslRoot = "hlsl", ownRoot = "tests/d3d";

template <class T> T orThrow(reprise::Result<T> result) {
    if (!result) throw std::runtime_error(result.error().message);
    return std::move(*result);
}

std::map<std::string, int> macrosOf(const Platform& platform, const Variant* variant, Stage stage) {
    return orThrow(reprisec::definesOf(pack(), variant, stage, {{std::string(platform.macro), 1}}));
}

fs::path controlRoot(const fs::path& directory, const Control& control) {
    return directory / ("control_" + std::string(control.name));
}

std::vector<fs::path> rootsFor(const fs::path& directory, const Control* control) {
    std::vector<fs::path> roots = {hlslRoot, ownRoot};
    if (control) roots.insert(roots.begin(), controlRoot(directory, *control));
    return roots;
}

std::string suffixOf(const Control* control) {
    return control ? "." + std::string(control->name) : "";
}

// --- Shaders

Shader passShader(const Platform& platform, const Variant& variant, Stage stage, const fs::path& directory,
                  const Control* control) {
    const Variant own = reprise::forStage(variant, stage);
    const size_t index = static_cast<size_t>(own.pass - pack().passes().data());
    Shader shader;
    shader.name = std::string(platform.name) + "." + reprise::variantName(own) + "." +
                  std::string(reprise::stageName(stage)) + suffixOf(control);
    shader.profile = profileOf(platform, stage);
    shader.entry = reprisec::entryPoint(stage);
    shader.file = fs::relative(pack().storage->sources[index].file, hlslRoot).generic_string();
    shader.roots = rootsFor(directory, control);
    shader.macros = macrosOf(platform, &own, stage);
    return shader;
}

Shader ownShader(const Platform& platform, const std::string& file, Stage stage, const fs::path& directory,
                 const Control* control) {
    return {std::string(platform.name) + "." + file + "." + std::string(reprise::stageName(stage)) +
                suffixOf(control),
            std::string(profileOf(platform, stage)),
            std::string(reprisec::entryPoint(stage)),
            file + ".hlsl",
            rootsFor(directory, control),
            macrosOf(platform, nullptr, stage)};
}

Shader fullscreenVertex(const Platform& platform, const fs::path& directory, const Control* control) {
    return passShader(platform, passes::variantOf(pack(), "fullscreen"), Stage::vertex, directory, control);
}

// --- Constants of Direct3D 9: a vector a register, a matrix four

std::vector<float> registersOf(const reprisec::ParameterMember& member, std::span<const std::byte> block) {
    std::vector<float> values((member.bytes + 15) / 16 * 4, 0.0f);
    std::memcpy(values.data(), block.data() + member.offset, member.bytes);
    return values;
}

std::vector<Constant> constantsOf(const Variant& variant, const Scene& scene) {
    std::vector<Constant> constants;
    for (const Stage stage : variant.pass->stages) {
        if (stage == Stage::compute) continue;
        const auto compiled =
            orThrow(reprisec::compile(pack(), variant, stage, {.glsl = false, .platformSwitches = {}}));
        for (const auto& member : compiled.reflection.parameters)
            constants.push_back({stage == Stage::vertex, member.name, registersOf(member, scene.parameters)});
    }
    return constants;
}

std::vector<float> outputSize(const Scene& scene) {
    const auto width = static_cast<float>(scene.width), height = static_cast<float>(scene.height);
    return {width, height, 1.0f / width, 1.0f / height};
}

// --- Runs

std::vector<Pixels> targetsOf(const Scene& scene, size_t count) {
    if (scene.before) return {*scene.before};
    constexpr float unwritten = std::numeric_limits<float>::quiet_NaN();
    return std::vector<Pixels>(count,
                               passes::makePixels(passes::rgba32f, scene.width, scene.height, [](int, int) {
                                   return passes::Texel{unwritten, unwritten, unwritten, unwritten};
                               }));
}

const Pixels* imageOf(const Scene& scene, const reprise::ImageInfo& input) {
    for (const auto& image : scene.images)
        if (image.name == input.name || image.name == input.sameAs) return image.pixels;
    return nullptr;
}

std::vector<Texture> texturesOf(const Variant& variant, const Scene& scene) {
    std::vector<Texture> textures;
    const auto& bindings = variant.pass->bindings;
    for (const auto& input : variant.pass->inputs) {
        const Pixels* pixels = reprise::exists(variant, input) ? imageOf(scene, input) : nullptr;
        if (!pixels) continue;
        const auto texture = std::ranges::find(bindings, input.name, &reprise::BindingInfo::name);
        const auto sampler =
            std::ranges::find(bindings, std::string(input.name) + "_sampler", &reprise::BindingInfo::name);
        if (texture == bindings.end() || sampler == bindings.end()) continue;
        textures.push_back({texture->binding, sampler->kind == reprise::BindingKind::linearSampler, pixels});
    }
    return textures;
}

// The runtime's structs of parameters have the layout of a constant buffer.
Run startRun(const Case& which, const Scene& scene) {
    Run run;
    run.version = which.platform->version;
    run.name = std::string(which.platform->name) + "." + which.title + "." +
               std::string(reprise::stageName(which.stage)) + "." + scene.name + suffixOf(which.control);
    run.width = scene.width;
    run.height = scene.height;
    if (run.version > 9) run.parameters = scene.parameters;
    return run;
}

void addPalettes(Run& run, const Scene& scene) {
    uint32_t slot = 0;
    for (const NamedMatrices& palette : scene.palettes) {
        const auto bytes = std::as_bytes(std::span(palette.matrices));
        std::vector<float> registers(bytes.size() / sizeof(float));
        std::memcpy(registers.data(), bytes.data(), bytes.size());
        if (run.version == 9)
            run.constants.push_back({true, std::string(palette.name), registers});
        else
            run.palettes.push_back({slot++, sizeof(glm::mat4), {bytes.begin(), bytes.end()}});
    }
}

Run passRun(const Case& which, const Variant& variant, const Scene& scene) {
    Run run = startRun(which, scene);
    const auto outputs = static_cast<size_t>(std::ranges::count_if(
        variant.pass->outputs, [&](const auto& output) { return reprise::exists(variant, output); }));
    run.targets = targetsOf(scene, std::max<size_t>(outputs, 1));
    run.textures = texturesOf(variant, scene);
    run.shader = which.shaders.back().name;
    if (which.stage == Stage::compute) {
        const auto& pass = *variant.pass;
        const int extent[] = {scene.width, scene.height};
        for (size_t axis = 0; axis < 2; ++axis) {
            const uint32_t tile = reprise::threadsOf(variant)[axis] * pass.pixelsPerThread[axis];
            run.groups[axis] = (static_cast<uint32_t>(extent[axis]) + pass.overhang[axis] + tile - 1) / tile;
        }
        return run;
    }
    run.vertexShader = which.shaders.front().name;
    run.vertices = scene.vertices;
    if (run.version == 9) {
        if (run.vertices.bytes.empty()) run.vertices = fullscreenCorners();
        run.constants = constantsOf(variant, scene);
        run.constants.push_back({true, "gOutputSize", outputSize(scene)});
    }
    addPalettes(run, scene);
    return run;
}

// --- Cases

Case passCase(const Platform& platform, const Variant& variant, Stage stage, const fs::path& directory,
              const Control* control) {
    Case made{reprise::variantName(variant),
              &platform,
              stage,
              exceptionOf(platform, stage, variant),
              control,
              {},
              {}};
    const bool vertexOnly = variant.pass->stages.size() == 1 && stage == Stage::vertex;
    if (stage != Stage::compute) {
        const bool own = std::ranges::count(variant.pass->stages, Stage::vertex) > 0;
        made.shaders.push_back(own ? passShader(platform, variant, Stage::vertex, directory, control)
                                   : fullscreenVertex(platform, directory, control));
    }
    made.shaders.push_back(vertexOnly ? ownShader(platform, "position", Stage::fragment, directory, control)
                                      : passShader(platform, variant, stage, directory, control));
    if (made.exception) return made;
    for (Scene& scene : scenesOf(variant)) {
        made.runs.push_back({passRun(made, variant, scene), scene});
        if (control) break;
    }
    return made;
}

// The stage that a draw of the pass is named by, and compute.
std::vector<Stage> stagesOf(const reprise::PassInfo& pass, const Platform& platform) {
    std::vector<Stage> stages;
    const auto has = [&](Stage stage) { return std::ranges::count(pass.stages, stage) > 0; };
    if (has(Stage::fragment))
        stages.push_back(Stage::fragment);
    else if (has(Stage::vertex))
        stages.push_back(Stage::vertex);
    if (has(Stage::compute) && !platform.computeProfile.empty()) stages.push_back(Stage::compute);
    return stages;
}

bool contains(const std::vector<Variant>& variants, const Variant& variant) {
    return std::ranges::any_of(variants, [&](const Variant& each) { return each.values == variant.values; });
}

// The committed variants, and for each that the platform cannot express its sister that it can.
std::vector<Variant> variantsFor(const Platform& platform, const reprise::PassInfo& pass, Stage stage) {
    std::vector<Variant> variants = pack().committedVariants(pass);
    for (size_t i = 0, committed = variants.size(); i < committed; ++i) {
        const Exception* exception = exceptionOf(platform, stage, variants[i]);
        if (!exception) continue;
        Variant sister = variants[i];
        const auto info =
            std::ranges::find(pass.switches, exception->condition.switchName, &reprise::SwitchInfo::name);
        const auto done = reprise::setSwitch(sister, info->name, info->values[info->defaultValue]);
        if (!done) throw std::runtime_error(done.error().message);
        if (!contains(variants, sister)) variants.push_back(sister);
    }
    return variants;
}

// A shader that is none of the table's, with one texture read with a linear filter.
Case ownCase(const Platform& platform, const Shader& vertex, const Shader& fragment, const std::string& title,
             const Scene& scene, const Control* control) {
    Case made{title, &platform, Stage::fragment, nullptr, control, {vertex, fragment}, {}};
    Run run = startRun(made, scene);
    run.vertexShader = vertex.name;
    run.shader = fragment.name;
    run.targets = targetsOf(scene, 1);
    run.textures = {{0, true, scene.images[0].pixels}};
    run.vertices = scene.vertices;
    if (run.version == 9) {
        if (run.vertices.bytes.empty()) run.vertices = fullscreenCorners();
        run.constants = {{true, "gOutputSize", outputSize(scene)}};
    }
    made.runs.push_back({run, scene});
    return made;
}

Case screenCopyCase(const Platform& platform, const fs::path& directory, const Control* control) {
    return ownCase(platform, ownShader(platform, "screen_copy", Stage::vertex, directory, control),
                   ownShader(platform, "screen_copy", Stage::fragment, directory, control), "screen_copy",
                   screenCopyScene(), control);
}

// Passes that take the position for that of a whole texel, and read texels alone: half a pixel does not show.
bool showsHalfAPixel(std::string_view pass) {
    return pass != "depth_hierarchy" && pass != "obscurance_filter" && pass != "combine_lighting";
}

void addControls(std::vector<Case>& cases, const Platform& platform, const fs::path& directory) {
    for (const Control& control : controls()) {
        if (control.version != platform.version) continue;
        cases.push_back(screenCopyCase(platform, directory, &control));
        for (const auto& pass : pack().passes()) {
            if (control.name == "uncorrected" && !showsHalfAPixel(pass.name)) continue;
            const std::vector<Stage> stages = stagesOf(pass, platform);
            if (stages.empty() || stages.front() == Stage::compute) continue; // nothing is drawn
            cases.push_back(passCase(platform, passes::variantOf(pack(), pass.name), stages.front(),
                                     directory, &control));
        }
    }
}

// The switches of passes and engines, but not the platforms, that a header tests.
std::set<std::string> testedSwitches(const std::string& text) {
    static const std::regex condition(R"(#\s*(?:if|elif)\s+([^\n]*))"), name("[A-Z][A-Z_0-9]*");
    const auto known = orThrow(reprisec::definesOf(pack(), nullptr, Stage::fragment, {}));
    std::set<std::string> found;
    for (std::sregex_iterator each(text.begin(), text.end(), condition), end; each != end; ++each) {
        const std::string rest = (*each)[1];
        for (std::sregex_iterator word(rest.begin(), rest.end(), name); word != end; ++word)
            if (known.contains(word->str()) && !word->str().starts_with("PLATFORM_") &&
                word->str() != "STAGE_COMPUTE")
                found.insert(word->str());
    }
    return found;
}

// --- Verdicts

Verdict failed(std::string detail) {
    return {false, "FAILED", {}, {}, std::move(detail)};
}

Verdict judgeException(const Case& which, const Results& results) {
    const std::string report = results.of("shader", which.shaders.back().name);
    if (report.starts_with("ok"))
        return failed("it compiles, but is listed as not expressible; take the row out");
    if (report.find(which.exception->compilerSays) == std::string::npos)
        return failed("the listed reason is not the compiler's: " + report);
    return {true, "not expressible", {}, {}, {}};
}

Verdict judgeControl(Verdict verdict) {
    if (verdict.passed) return failed("the wrong form is not caught");
    if (verdict.comparison.outside == 0) return verdict; // it did not compile or run
    verdict.passed = true;
    verdict.result = "caught";
    return verdict;
}

Verdict judgeRuns(const Case& which, const Results& results, const DeviceErrors& errors) {
    for (const Shader& shader : which.shaders)
        if (const std::string report = results.of("shader", shader.name); !report.starts_with("ok"))
            return failed(shader.name + " " + (report.empty() ? "was not compiled" : report));
    Verdict verdict{true, "equal", {}, {}, {}};
    for (const CaseRun& each : which.runs) {
        const std::string report = results.of("run", each.run.name);
        if (!report.starts_with("ok"))
            return failed(each.run.name + " " + (report.empty() ? "was not run" : report));
        const passes::Comparison comparison =
            each.scene.judge(results.targets(each.run), errors.at(each.run.width, each.run.height));
        if (&each == &which.runs.front()) verdict.first = comparison;
        passes::join(verdict.comparison, comparison, each.scene.name);
    }
    if (verdict.comparison.holds()) return verdict;
    verdict.passed = false;
    verdict.result = "FAILED";
    verdict.detail = passes::text(verdict.comparison);
    return verdict;
}

} // namespace

std::vector<Case> allCases(const fs::path& directory) {
    std::vector<Case> cases;
    for (const Platform& platform : platforms) {
        cases.push_back(screenCopyCase(platform, directory, nullptr));
        for (const auto& pass : pack().passes())
            for (const Stage stage : stagesOf(pass, platform))
                for (const Variant& variant : variantsFor(platform, pass, stage))
                    if (reprise::forStage(variant, stage).values == variant.values)
                        cases.push_back(passCase(platform, variant, stage, directory, nullptr));
        addControls(cases, platform, directory);
    }
    return cases;
}

Case rampCase(const Platform& platform) {
    return ownCase(platform, fullscreenVertex(platform, {}, nullptr),
                   ownShader(platform, "ramp", Stage::fragment, {}, nullptr), "ramp", rampScene(), nullptr);
}

std::vector<Shader> headerJobs(const Platform& platform) {
    std::vector<Shader> jobs;
    for (const auto& entry : fs::directory_iterator(hlslRoot / "reprise")) {
        if (entry.path().extension() != ".hlsli") continue;
        const std::string file = entry.path().filename().string();
        Shader job{std::string(platform.name) + "." + file,
                   std::string(platform.fragmentProfile),
                   "mainFragment",
                   "reprise/" + file,
                   {hlslRoot},
                   macrosOf(platform, nullptr, Stage::fragment)};
        jobs.push_back(job);
        for (const std::string& macro : testedSwitches(orThrow(reprisec::readText(entry.path())))) {
            Shader other = job;
            other.name += "." + macro;
            other.macros[macro] = 1;
            jobs.push_back(other);
        }
    }
    std::ranges::sort(jobs, {}, &Shader::name);
    return jobs;
}

bool hasFunctions(const Shader& header) {
    static const std::regex head(R"((^|\n)\w+ \w+\([^;{}]*\) \{)");
    return std::regex_search(orThrow(reprisec::readText(hlslRoot / header.file)), head);
}

void writeControls(const fs::path& directory) {
    for (const Control& control : controls())
        for (const Replacement& replacement : control.replacements) {
            std::string text = orThrow(reprisec::readText(hlslRoot / replacement.file));
            const size_t place = text.find(replacement.original);
            if (place == std::string::npos)
                throw std::runtime_error(std::string(replacement.file) +
                                         " no longer holds: " + std::string(replacement.original));
            text.replace(place, replacement.original.size(), replacement.wrong);
            const fs::path file = controlRoot(directory, control) / replacement.file;
            fs::create_directories(file.parent_path());
            std::ofstream(file, std::ios::binary) << text;
        }
}

double DeviceErrors::largestInterpolationPx() const {
    double largest = 0.0;
    for (const auto& [extent, error] : interpolationPx)
        largest = std::max(largest, error);
    return largest;
}

// Another attribute may round otherwise than the position: half a unit in the last place of the extent at
// least.
DeviceError DeviceErrors::at(int width, int height) const {
    const auto found = interpolationPx.find({width, height});
    const double measured = found == interpolationPx.end() ? largestInterpolationPx() : found->second;
    return {filterPx, std::max(measured, 0x1p-24 * std::max(width, height))};
}

DeviceErrors errorsOf(const Platform& platform, const std::vector<Case>& cases, const Results& results) {
    DeviceErrors errors;
    errors.filterPx = filterErrorPx(results.targets(rampCase(platform).runs[0].run)[0]);
    for (const Case& each : cases) {
        if (each.platform != &platform || each.title != "fullscreen" || each.control) continue;
        for (const CaseRun& run : each.runs)
            errors.interpolationPx[{run.run.width, run.run.height}] =
                interpolationErrorPx(results.targets(run.run)[0]);
    }
    return errors;
}

Verdict judge(const Case& which, const Results& results, const DeviceErrors& errors) {
    if (which.exception) return judgeException(which, results);
    Verdict verdict = judgeRuns(which, results, errors);
    return which.control ? judgeControl(std::move(verdict)) : verdict;
}

} // namespace d3d
