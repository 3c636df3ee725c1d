// SPDX-License-Identifier: Apache-2.0
// pack.toml as tables. What it may say is listed here, key by key; anything else is an error with its line.
#include "internal.hpp"

#include <algorithm>

#include <toml++/toml.h>

namespace reprisec {

namespace {

using reprise::BindingInfo;
using reprise::BindingKind;
using reprise::Condition;
using reprise::FormatChoice;
using reprise::GroupChoice;
using reprise::ImageInfo;
using reprise::PresetInfo;
using reprise::SwitchInfo;

bool isOutput(std::span<const ImageInfo> outputs, std::string_view name) {
    return std::ranges::find(outputs, name, &ImageInfo::name) != outputs.end();
}

// Thrown while reading, caught in load.
struct Mistake {
    toml::source_region where;
    std::string message;
};

[[noreturn]] void fail(const toml::node& node, std::string message) {
    throw Mistake{node.source(), std::move(message)};
}

class Reader {
public:
    explicit Reader(Pack::Storage& storage) : storage_(storage) {}
    void read(const toml::table& root);

private:
    Pack::Storage& storage_;

    std::string_view keep(std::string text) { return storage_.texts.emplace_back(std::move(text)); }

    static void allow(const toml::table& table, std::initializer_list<std::string_view> keys) {
        for (const auto& [key, value] : table)
            if (std::ranges::find(keys, key.str()) == keys.end())
                fail(value,
                     "unknown key \"" + std::string(key.str()) + "\"; correct the spelling or remove it");
    }
    static const toml::node& need(const toml::table& table, std::string_view key) {
        if (const toml::node* node = table.get(key)) return *node;
        fail(table, "the key \"" + std::string(key) + "\" is missing here; add it");
    }
    template <class T> static T as(const toml::node& node, const char* what) {
        if (const auto value = node.value_exact<T>()) return *value;
        fail(node, std::string("this must be ") + what);
    }
    std::string_view text(const toml::table& table, std::string_view key) {
        return keep(as<std::string>(need(table, key), "a string"));
    }
    std::string_view textOr(const toml::table& table, std::string_view key) {
        return table.contains(key) ? text(table, key) : std::string_view{};
    }
    static bool flagOr(const toml::table& table, std::string_view key, bool fallback) {
        return table.contains(key) ? as<bool>(need(table, key), "true or false") : fallback;
    }
    static uint32_t number(const toml::node& node) {
        const auto value = as<int64_t>(node, "a whole number");
        if (value < 0 || value > 65535) fail(node, "this must be from 0 to 65535");
        return static_cast<uint32_t>(value);
    }
    static const toml::array& array(const toml::node& node) {
        if (const toml::array* found = node.as_array()) return *found;
        fail(node, "this must be an array");
    }
    static const toml::table& table(const toml::node& node) {
        if (const toml::table* found = node.as_table()) return *found;
        fail(node, "this must be a table");
    }
    // Absent is empty: [[pass.input]] and the like.
    template <class Visit> static void each(const toml::table& parent, std::string_view key, Visit visit) {
        if (const toml::node* node = parent.get(key))
            for (const toml::node& item : array(*node))
                visit(table(item));
    }
    template <size_t count>
    static void numbers(const toml::table& parent, std::string_view key, uint32_t (&out)[count]) {
        const toml::node* node = parent.get(key);
        if (!node) return;
        if (array(*node).size() != count) fail(*node, "this must be " + std::to_string(count) + " numbers");
        for (size_t i = 0; i < count; ++i)
            out[i] = number(array(*node)[i]);
    }

    Stage stage(const toml::node& node);
    std::span<const Stage> stages(const toml::table& parent);
    std::vector<std::string_view> textList(const toml::table& parent, std::string_view key);
    std::span<const Condition> conditions(const toml::table& parent, std::string_view key,
                                          const PassInfo& pass);
    template <class Take>
    void eachChoice(const toml::table& parent, std::string_view key, const PassInfo& pass, const Take& take);
    std::span<const FormatChoice> formatsBy(const toml::table& parent, const PassInfo& pass);
    std::span<const GroupChoice> groupsBy(const toml::table& parent, const PassInfo& pass);
    SwitchInfo readSwitch(const toml::table& table);
    ImageInfo readImage(const toml::table& table, const PassInfo& pass);
    void readInput(const toml::table& table, const PassInfo& pass, std::vector<ImageInfo>& images,
                   std::vector<BindingInfo>& bindings);
    std::pair<float, float> feedback(const toml::table& table);
    void readOutput(const toml::table& table, const PassInfo& pass, std::vector<ImageInfo>& images,
                    std::vector<BindingInfo>& bindings);
    void addBinding(const toml::table& table, std::vector<BindingInfo>& bindings, BindingInfo binding);
    void readPass(const toml::table& table);
    void readPreset(const toml::table& table);
    void readPack(const toml::table& table);
};

Stage Reader::stage(const toml::node& node) {
    const auto name = as<std::string>(node, "a string");
    for (Stage each : {Stage::vertex, Stage::fragment, Stage::compute})
        if (stageWord(each) == name) return each;
    fail(node, "\"" + name + "\" is no stage; there are vertex, fragment and compute");
}

std::span<const Stage> Reader::stages(const toml::table& parent) {
    auto& list = storage_.stageLists.emplace_back();
    for (const toml::node& node : array(need(parent, "stages")))
        list.push_back(stage(node));
    return list;
}

std::vector<std::string_view> Reader::textList(const toml::table& parent, std::string_view key) {
    std::vector<std::string_view> list;
    for (const toml::node& node : array(need(parent, key)))
        list.push_back(keep(as<std::string>(node, "a string")));
    return list;
}

// { SWITCH = "value" }, checked against the switches of the pass.
std::span<const Condition> Reader::conditions(const toml::table& parent, std::string_view key,
                                              const PassInfo& pass) {
    if (!parent.contains(key)) return {};
    auto& list = storage_.conditionLists.emplace_back();
    for (const auto& [name, value] : table(need(parent, key))) {
        const auto add = [&](const toml::node& node) {
            Variant probe{&pass, {}};
            const auto wanted = as<std::string>(node, "a string");
            if (auto set = reprise::setSwitch(probe, name.str(), wanted); !set)
                fail(node, set.error().message);
            list.push_back({keep(std::string(name.str())), keep(wanted)});
        };
        if (!key.ends_with("when") || !value.is_array()) {
            add(value);
            continue;
        }
        for (const toml::node& alternative : array(value))
            add(alternative);
    }
    return list;
}

SwitchInfo Reader::readSwitch(const toml::table& table) {
    allow(table, {"name", "values", "default", "need", "summary", "stages"});
    SwitchInfo info{};
    info.name = text(table, "name");
    auto& values = storage_.textLists.emplace_back(textList(table, "values"));
    info.values = values;
    if (values.size() < 2 || values.size() > 255) fail(need(table, "values"), "a switch has 2 to 255 values");
    const auto standard = std::ranges::find(values, text(table, "default"));
    if (standard == values.end()) fail(need(table, "default"), "the default is none of the values");
    info.defaultValue = static_cast<uint8_t>(standard - values.begin());
    info.need = textOr(table, "need");
    info.summary = textOr(table, "summary");
    if (table.contains("stages")) info.stages = stages(table);
    return info;
}

// { SWITCH = { value = what it has in place of the usual } }
template <class Take>
void Reader::eachChoice(const toml::table& parent, std::string_view key, const PassInfo& pass,
                        const Take& take) {
    if (!parent.contains(key)) return;
    for (const auto& [name, choices] : table(need(parent, key)))
        for (const auto& [value, node] : table(choices)) {
            Variant probe{&pass, {}};
            if (auto set = reprise::setSwitch(probe, name.str(), value.str()); !set)
                fail(node, set.error().message);
            take({keep(std::string(name.str())), keep(std::string(value.str()))}, table(choices));
        }
}

std::span<const FormatChoice> Reader::formatsBy(const toml::table& parent, const PassInfo& pass) {
    auto& list = storage_.formatLists.emplace_back();
    eachChoice(parent, "format_by", pass, [&](Condition when, const toml::table& choices) {
        list.push_back({when, text(choices, when.value)});
    });
    return list;
}

std::span<const GroupChoice> Reader::groupsBy(const toml::table& parent, const PassInfo& pass) {
    auto& list = storage_.groupLists.emplace_back();
    eachChoice(parent, "threads_by", pass, [&](Condition when, const toml::table& choices) {
        numbers(choices, when.value, list.emplace_back(GroupChoice{when, {}}).threads);
    });
    return list;
}

ImageInfo Reader::readImage(const toml::table& table, const PassInfo& pass) {
    ImageInfo image{};
    image.name = text(table, "name");
    image.space = textOr(table, "space");
    image.format = textOr(table, "format");
    const auto scaleOr1 = [&](std::string_view key) {
        const toml::node* scale = table.get(key);
        if (!scale) return 1.0f;
        const auto value = scale->value<double>();
        const bool own = key == "scale";
        if (!value || !(own ? *value >= 0.0 : *value > 0.0))
            fail(*scale, own ? "the scale must be a number, 0 for an extent of its own"
                             : "the scale must be a number above 0");
        return static_cast<float>(*value);
    };
    image.scale = scaleOr1("scale");
    image.widthScale = scaleOr1("width_scale");
    image.history = textOr(table, "history");
    image.sameAs = textOr(table, "same_as");
    image.when = conditions(table, "when", pass);
    image.orWhen = conditions(table, "or_when", pass);
    image.formatBy = formatsBy(table, pass);
    return image;
}

void Reader::addBinding(const toml::table& table, std::vector<BindingInfo>& bindings, BindingInfo binding) {
    for (const BindingInfo& other : bindings)
        if (other.binding == binding.binding || other.name == binding.name)
            fail(table, std::string(binding.name) + " and " + std::string(other.name) +
                            " share a name or the binding " + std::to_string(binding.binding) +
                            "; change one");
    bindings.push_back(binding);
}

void Reader::readInput(const toml::table& table, const PassInfo& pass, std::vector<ImageInfo>& images,
                       std::vector<BindingInfo>& bindings) {
    allow(table, {"name", "binding", "filter", "kind", "space", "format", "format_by", "scale", "width_scale",
                  "when", "or_when", "history", "same_as"});
    const ImageInfo image = readImage(table, pass);
    images.push_back(image);
    const uint32_t binding = number(need(table, "binding"));
    if (const auto kind = textOr(table, "kind"); !kind.empty()) {
        if (kind != "structured")
            fail(need(table, "kind"), "the only kind besides a texture is \"structured\"");
        addBinding(table, bindings, {image.name, binding, BindingKind::storageBuffer});
        return;
    }
    addBinding(table, bindings, {image.name, binding, BindingKind::sampledImage});
    if (!table.contains("filter")) return; // fetched only
    const auto filter = text(table, "filter");
    if (filter != "point" && filter != "linear")
        fail(need(table, "filter"), "a filter is \"point\" or \"linear\"");
    addBinding(table, bindings,
               {keep(std::string(image.name) + "_sampler"), binding + samplerOffset,
                filter == "point" ? BindingKind::pointSampler : BindingKind::linearSampler});
}

void Reader::readOutput(const toml::table& table, const PassInfo& pass, std::vector<ImageInfo>& images,
                        std::vector<BindingInfo>& bindings) {
    allow(table,
          {"name", "binding", "space", "format", "format_by", "scale", "width_scale", "when", "or_when"});
    const ImageInfo image = readImage(table, pass);
    if (image.format.empty()) fail(table, "an output needs a format; add it");
    if (image.scale == 0.0f) fail(table, "an output has a share of the frame's extent; give a scale above 0");
    images.push_back(image);
    addBinding(table, bindings, {image.name, number(need(table, "binding")), BindingKind::storageImage});
}

void Reader::readPass(const toml::table& table) {
    allow(table, {"name", "file", "stages", "fullscreen", "threads", "threads_by", "pixels_per_thread",
                  "overhang", "summary", "source", "parameters", "switch", "input", "output"});
    PassInfo pass{};
    pass.name = text(table, "name");
    if (std::ranges::find(storage_.passes, pass.name, &PassInfo::name) != storage_.passes.end())
        fail(table, "there are two passes named " + std::string(pass.name) + "; rename one");
    pass.summary = textOr(table, "summary");
    pass.source = textOr(table, "source");
    pass.stages = stages(table);
    pass.fullscreen = flagOr(table, "fullscreen", false);
    std::ranges::fill(pass.threads, 1u);
    std::ranges::fill(pass.pixelsPerThread, 1u);
    numbers(table, "threads", pass.threads);
    numbers(table, "pixels_per_thread", pass.pixelsPerThread);
    numbers(table, "overhang", pass.overhang);

    auto& switches = storage_.switchLists.emplace_back();
    each(table, "switch", [&](const toml::table& item) { switches.push_back(readSwitch(item)); });
    pass.switches = switches;
    pass.threadsBy = groupsBy(table, pass);
    auto& bindings = storage_.bindingLists.emplace_back();
    PassSource source{(storage_.file.parent_path() / std::string(text(table, "file"))).lexically_normal(),
                      std::string(textOr(table, "parameters"))};
    if (!source.parameters.empty())
        bindings.push_back({keep(source.parameters), 0, BindingKind::uniformBuffer});
    auto& inputs = storage_.imageLists.emplace_back();
    each(table, "input", [&](const toml::table& item) { readInput(item, pass, inputs, bindings); });
    auto& outputs = storage_.imageLists.emplace_back();
    each(table, "output", [&](const toml::table& item) { readOutput(item, pass, outputs, bindings); });
    for (const ImageInfo& input : inputs)
        if (!input.history.empty() && !isOutput(outputs, input.history) &&
            std::ranges::none_of(storage_.passes, [&](const PassInfo& earlier) {
                return isOutput(earlier.outputs, input.history);
            }))
            fail(table, "the history of " + std::string(input.name) +
                            " is no output of the pass or of one before it; correct it");
    for (const ImageInfo& input : inputs)
        if (!input.sameAs.empty() &&
            std::ranges::find(inputs, input.sameAs, &ImageInfo::name) == inputs.end())
            fail(table, "the same_as of " + std::string(input.name) + " is no input of the pass; correct it");
    std::ranges::sort(bindings, {}, &BindingInfo::binding);
    pass.inputs = inputs;
    pass.outputs = outputs;
    pass.bindings = bindings;
    storage_.passes.push_back(pass);
    storage_.sources.push_back(std::move(source));
    storage_.presets.emplace_back();
}

// [least, most] weight of history, 0 <= least <= most < 1. A preset of a pass without history has none.
std::pair<float, float> Reader::feedback(const toml::table& table) {
    if (!table.contains("feedback")) return {};
    const toml::array* pair = need(table, "feedback").as_array();
    const auto number = [&](size_t i) { return pair->get(i)->value<double>().value_or(-1.0); };
    const bool valid = pair != nullptr && pair->size() == 2 && number(0) >= 0.0 && number(0) <= number(1);
    if (!valid || !(number(1) < 1.0))
        fail(need(table, "feedback"), "feedback is [least, most] weight of history, 0 <= least <= most < 1");
    return {static_cast<float>(number(0)), static_cast<float>(number(1))};
}

void Reader::readPreset(const toml::table& table) {
    allow(table, {"pass", "name", "summary", "switches", "feedback", "ramp_feedback"});
    const auto passName = text(table, "pass");
    const auto pass = std::ranges::find(storage_.passes, passName, &PassInfo::name);
    if (pass == storage_.passes.end()) fail(need(table, "pass"), "there is no pass " + std::string(passName));
    auto& presets = storage_.presets[static_cast<size_t>(pass - storage_.passes.begin())];
    const auto [feedbackMin, feedbackMax] = feedback(table);
    const PresetInfo preset{text(table, "name"),
                            textOr(table, "summary"),
                            conditions(table, "switches", *pass),
                            feedbackMin,
                            feedbackMax,
                            flagOr(table, "ramp_feedback", false)};
    if (std::ranges::find(presets, preset.name, &PresetInfo::name) != presets.end())
        fail(table, "the pass " + std::string(passName) + " has two presets of this name; rename one");
    presets.push_back(preset);
}

void Reader::readPack(const toml::table& table) {
    allow(table, {"name", "schema", "include", "platform_switches"});
    storage_.name = text(table, "name");
    if (number(need(table, "schema")) != 1) fail(need(table, "schema"), "this compiler reads schema 1");
    for (std::string_view directory : textList(table, "include"))
        storage_.includeDirectories.push_back((storage_.file.parent_path() / directory).lexically_normal());
    for (std::string_view name : textList(table, "platform_switches"))
        storage_.platformSwitches.emplace_back(name);
}

void Reader::read(const toml::table& root) {
    allow(root, {"pack", "pass", "preset"});
    readPack(table(need(root, "pack")));
    // Variants keep pointers to passes, so the vector must not grow under them.
    if (const toml::node* passes = root.get("pass")) storage_.passes.reserve(array(*passes).size());
    each(root, "pass", [&](const toml::table& item) { readPass(item); });
    each(root, "preset", [&](const toml::table& item) { readPreset(item); });
}

Error located(const fs::path& file, const toml::source_region& where, std::string_view message) {
    return {ErrorCode::invalidArgument,
            file.string() + ":" + std::to_string(where.begin.line) + ": " + std::string(message)};
}

} // namespace

Result<std::shared_ptr<Pack::Storage>> readTable(const fs::path& packToml) {
    auto content = readText(packToml);
    if (!content) return content.error();
    auto storage = std::make_shared<Pack::Storage>();
    storage->file = packToml;
    try {
        Reader(*storage).read(toml::parse(*content, packToml.string()));
    } catch (const toml::parse_error& error) {
        return located(packToml, error.source(), error.description());
    } catch (const Mistake& mistake) {
        return located(packToml, mistake.where, mistake.message);
    }
    return storage;
}

} // namespace reprisec
