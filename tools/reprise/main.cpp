// SPDX-License-Identifier: Apache-2.0
// reprise: measures the pack, shows what is in it and what a scene needs of it.
#include "commands.hpp"

#include <functional>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace {

using namespace report;

void addReport(CLI::App& app, ReportOptions& o, std::function<void()>& run) {
    CLI::App* command = app.add_subcommand("report", "Measure error against run time and write a page");
    command->add_flag("--quick", o.quick, "320x180, 16 frames, 9 rounds of timing: minutes on two cores");
    command->add_option("--scene", o.scenes, "A built-in scene's name or a glTF, GLB or OBJ file; repeatable")
        ->allow_extra_args(false);
    command->add_option("--technique", o.technique,
                        "One pass of the table, or occlusion, shadow, lighting (default: all)");
    command->add_option("--size", o.size, "WIDTHxHEIGHT of error and time (default: 640x360 and 1280x720)");
    command->add_option("--frames", o.frames, "Frames of a sequence (default: 32, quick 16)")
        ->check(CLI::Range(1, 10000));
    command->add_option("--stage", o.stage, "fragment, compute or both")->capture_default_str();
    command->add_option("--device", o.device, "Part of a device's name, or its index");
    command->add_option("--out", o.out, "Directory of the report")->capture_default_str();
    command->add_option("--flips", o.flips, "Presets whose switches are flipped one by one")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->capture_default_str();
    command->add_flag("--timing-only", o.timingOnly, "Times without errors, for large sizes");
    command->add_flag("--fresh", o.fresh, "Compile every variant from its HLSL, whatever generated/ holds");
    command->add_flag("--all-rows", o.allRows, "Print every row, not only presets and the front");
    command->callback([&] { run = [&o] { reportCommand(o); }; });
}

void addCheck(CLI::App& app, CheckOptions& o, std::function<void()>& run) {
    CLI::App* command = app.add_subcommand(
        "check", "Run every function over stiff and extreme inputs against double precision");
    command->add_flag("--quick", o.quick, "A tenth of the inputs: seconds");
    command->add_option("--function", o.function, "Only this function (default: all)");
    command->add_option("--device", o.device, "Part of a device's name, or its index");
    command->add_option("--out", o.out, "The JSON file")->capture_default_str();
    command->callback([&] { run = [&o] { checkCommand(o); }; });
}

// A flag that turns off what is on by default; CLI11's own form shows as "--no-history{false}".
void addOff(CLI::App& command, const std::string& name, bool& what, const std::string& text) {
    command.add_flag_callback(
        name, [&what] { what = false; }, text);
}

// The fields of CacheSettings.
void addCacheOptions(CLI::App& command, PlanOptions& o) {
    reprise::CacheSettings& c = o.cache;
    command.add_option("--occlusion", o.occlusion, "ambient_occlusion or scalable_obscurance")
        ->capture_default_str();
    command.add_option("--ratio", c.ratio, "Pixels per texel of the cache along an axis: 1, 2 or 4")
        ->capture_default_str();
    command.add_option("--samples", o.samples, "Of occlusion, a texel and frame (default: the pass's)");
    command.add_option("--cascades", c.cascades, "Of the shadow map, 1 to 4")->capture_default_str();
    addOff(command, "--no-history", c.history, "The cache keeps nothing from frame to frame");
    addOff(command, "--no-change-detection", c.detectsChanges, "History is kept where the values change");
    addOff(command, "--no-filter", c.filter, "The cache is not filtered");
    addOff(command, "--no-merging", c.merges, "Occlusion, shadow and cache are passes of their own");
    command.add_flag("--filter-history", c.filtersHistory, "What is filtered is the next frame's history");
    command
        .add_option("--packing", o.packing,
                    "Of occlusion and shadow: shadow_in_integer, occlusion_in_integer, with_frames (takes "
                    "--no-filter) or two")
        ->capture_default_str();
}

void addPlan(CLI::App& app, PlanOptions& o, std::function<void()>& run) {
    CLI::App* command =
        app.add_subcommand("plan", "Print what a scene needs: passes, images, reads, and what is left out");
    reprise::SceneNeeds& n = o.needs;
    addOff(*command, "--no-anti-aliasing", n.antiAliasing, "No temporal anti-aliasing");
    addOff(*command, "--static-camera", n.cameraMoves, "The camera never moves");
    addOff(*command, "--static-objects", n.objectsMove, "No object moves");
    command->add_flag("--skinned-meshes", n.skinnedMeshes, "Skinned meshes move");
    command->add_flag("--engine-motion", n.engineWritesMotion, "The engine writes motion vectors itself");
    addOff(*command, "--no-hdr", n.hdr, "No colour exceeds display white");
    command->add_flag("--fast-motion", n.fastMotion, "The motion blur fallback is wanted");
    command->add_flag("--reversed-depth", n.reversedDepth, "Device depth is reversed");
    command->add_flag("--orthographic", n.orthographic, "The camera is orthographic");
    command->add_flag("--linear-depth", n.linearDepth, "Depth is linear, in metres");
    command->add_flag("--ambient-occlusion", n.ambientOcclusion, "Occlusion is computed and cached");
    command->add_flag("--sun-shadows", n.sunShadows, "Shadows of the sun are filtered and cached");
    command->add_flag("--reversed-shadows", n.reversedShadows, "Depth of the shadow map is reversed");
    command->add_option("--cached-channels", n.cachedChannels, "Of the engine's own values, 1 to 4")
        ->capture_default_str();
    command->add_flag("--normals", n.normals, "The engine gives normals in view space");
    command->add_flag("--combine-lighting", n.combinesLighting, "Light is put together with its visibility");
    command->add_flag("--other-light", n.otherLight,
                      "Light that neither occlusion nor shadow touches is added");
    addCacheOptions(*command, o);
    command->add_option("--stage", o.stage, "fragment or compute")->capture_default_str();
    command->add_option("--preset", o.preset, "Preset of temporal_aa")->capture_default_str();
    command->add_option("--size", o.size, "WIDTHxHEIGHT")->capture_default_str();
    command->callback([&] { run = [&o] { planCommand(o); }; });
}

void addRender(CLI::App& app, RenderOptions& o, std::function<void()>& run) {
    CLI::App* command = app.add_subcommand("render", "Write one frame of a scene as PNG");
    command->add_option("--scene", o.scene, "A built-in scene's name or a file")->required();
    command->add_option("--frame", o.frame, "Index of the frame")->capture_default_str();
    command->add_option("--size", o.size, "WIDTHxHEIGHT")->capture_default_str();
    command->add_option("--device", o.device, "Part of a device's name, or its index");
    command->add_option("--out", o.out, "The PNG file")->required();
    command->add_flag("--truth", o.truth, "64 samples per pixel instead of one");
    command->add_option("--show", o.show, "colour; or, by ray casting, occlusion or sun")
        ->capture_default_str();
    command->add_option("--radius", o.radius, "Of occlusion, metres")->capture_default_str();
    command->add_option("--rays", o.rays, "Per pixel, of occlusion and sun")->capture_default_str();
    command->callback([&] { run = [&o] { renderCommand(o); }; });
}

std::string oneLine(std::string text) {
    for (char& c : text)
        c = c == '\n' ? ' ' : c;
    while (!text.empty() && text.back() == ' ')
        text.pop_back();
    return text;
}

} // namespace

int main(int argc, char** argv) {
    CLI::App app("Temporal coherence as a shader pack: error against run time");
    app.require_subcommand(1);
    std::function<void()> run;
    ReportOptions report;
    CheckOptions check;
    PlanOptions plan;
    RenderOptions render;
    addReport(app, report, run);
    app.add_subcommand("list", "Print passes, switches, scenes and devices")->callback([&] {
        run = listCommand;
    });
    addCheck(app, check, run);
    addPlan(app, plan, run);
    addRender(app, render, run);
    try {
        app.parse(argc, argv);
        run();
    } catch (const CLI::CallForHelp& help) {
        return app.exit(help);
    } catch (const CLI::ParseError& failure) {
        fmt::print(stderr, "reprise: {}; see reprise --help\n", oneLine(failure.what()));
        return 1;
    } catch (const std::exception& failure) {
        fmt::print(stderr, "reprise: {}\n", oneLine(failure.what()));
        return 1;
    }
    return 0;
}
