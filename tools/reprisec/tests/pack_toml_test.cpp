// SPDX-License-Identifier: Apache-2.0
// Pack::load: what pack.toml may say, and where it is wrong.
#include "small_pack.hpp"

namespace {

// The message of a table in which `from` became `to`.
std::string complaint(const fs::path& folder, std::string from, const std::string& to) {
    std::string text = smallTable;
    const size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    writeText(folder / "pack.toml", text.replace(at, from.size(), to));
    const auto pack = reprisec::Pack::load(folder / "pack.toml");
    return pack ? "it succeeded" : pack.error().message.substr(folder.string().size() + 1);
}

} // namespace

TEST_F(SmallPack, mistakesInTheTableAreNamedWithTheirLine) {
    const auto complains = [&](const std::string& from, const std::string& to, const std::string& start) {
        EXPECT_EQ(complaint(folder, from, to).substr(0, start.size()), start);
    };
    complains("filter = \"point\"", "filtre = \"point\"", "pack.toml:26: unknown key \"filtre\"");
    complains("filter = \"point\"", "filter = \"nearest\"", "pack.toml:26: a filter is");
    complains("default = \"one\"", "default = \"two\"", "pack.toml:17: the default is none of the values");
    complains("stages = [\"fragment\", \"compute\"]", "stages = [\"pixel\"]",
              "pack.toml:10: \"pixel\" is no stage");
    complains("binding = 16", "binding = 33", "pack.toml:27: gOutColour and gInColour_sampler share");
    complains("TAPS = \"nine\"", "TAPS = \"ten\"",
              "pack.toml:35: the switch TAPS of the pass copy has no value");
    complains("schema = 1", "schema = 2", "pack.toml:3: this compiler reads schema 1");
    complains("binding = 1\n", "binding = \"1\"\n", "pack.toml:25: this must be a whole number");
    complains("name = \"small\"", "name = small", "pack.toml:2: ");
    complains("filter = \"point\"", "scale = -0.5", "pack.toml:26: the scale must be a number, 0 for");
    complains("filter = \"point\"", "when = { TAPS = [\"nine\", \"ten\"] }",
              "pack.toml:26: the switch TAPS of the pass copy has no value");
    complains("binding = 16", "scale = 0.0\n  binding = 16", "pack.toml:27: an output has a share");
    complains("TAPS = \"nine\"", "TAPS = [\"nine\"]", "pack.toml:35: this must be a string");
    complains("binding = 16", "binding = 16\nwidth_scale = 0.0", "pack.toml:30: the scale must be a number");
    const auto formats = [&](const std::string& choices, const std::string& said) {
        complains("format = \"rg16f\"", "format = \"rg16f\"\n  format_by = " + choices,
                  "pack.toml:31: " + said);
    };
    formats("{ TAP = { nine = \"r16f\" } }", "the pass copy has no switch \"TAP\"");
    formats("{ TAPS = { ten = \"r16f\" } }", "the switch TAPS of the pass copy has no value");
    formats("{ TAPS = { nine = 16 } }", "this must be a string");
    formats("{ TAPS = \"r16f\" }", "this must be a table");
    formats("\"r16f\"", "this must be a table");
}

// Groups of the values that are named, the others those of the pass; what is no group is an error.
TEST_F(SmallPack, groupsFollowASwitch) {
    const std::string place = "threads = [8, 8, 1]\n";
    const auto with = [&](const std::string& choices) {
        std::string text = smallTable;
        text.insert(text.find(place) + place.size(), "threads_by = " + choices + "\n");
        writeText(folder / "pack.toml", text);
    };
    with("{ TAPS = { nine = [16, 4, 1] } }");
    const reprisec::Pack pack = load();
    auto variant = reprise::makeVariant(pack.passes(), "copy");
    ASSERT_TRUE(variant);
    const auto threads = [&](std::string_view taps) {
        EXPECT_TRUE(reprise::setSwitch(*variant, "TAPS", taps));
        const auto found = reprise::threadsOf(*variant);
        return std::vector<uint32_t>(found.begin(), found.end());
    };
    EXPECT_EQ(threads("one"), (std::vector<uint32_t>{8, 8, 1}));
    EXPECT_EQ(threads("nine"), (std::vector<uint32_t>{16, 4, 1}));
    with("{ TAPS = { nine = 16 } }");
    EXPECT_FALSE(reprisec::Pack::load(folder / "pack.toml"));
    with("{ TAPS = { ten = [16, 4, 1] } }");
    EXPECT_FALSE(reprisec::Pack::load(folder / "pack.toml"));
}

// Of an output and of an input, by the values that are named; the others have the format of the image.
TEST_F(SmallPack, formatsFollowASwitch) {
    std::string table = smallTable;
    for (const std::string place : {"filter = \"point\"\n", "format = \"rg16f\"\n"})
        table.insert(table.find(place) + place.size(),
                     (place.starts_with("filter") ? std::string("  format = \"r32f\"\n") : "") +
                         "  format_by = { TAPS = { nine = \"rgba16f\", gather = \"r16f\" } }\n");
    writeText(folder / "pack.toml", table);
    const reprisec::Pack pack = load();
    auto variant = reprise::makeVariant(pack.passes(), "copy");
    ASSERT_TRUE(variant);
    const auto formats = [&](std::string_view taps) {
        EXPECT_TRUE(reprise::setSwitch(*variant, "TAPS", taps));
        return std::string(reprise::formatOf(*variant, variant->pass->inputs[0])) + " " +
               std::string(reprise::formatOf(*variant, variant->pass->outputs[0]));
    };
    EXPECT_EQ(formats("one"), "r32f rg16f");
    EXPECT_EQ(formats("nine"), "rgba16f rgba16f");
    EXPECT_EQ(formats("gather"), "r16f r16f");
}

// Values of one switch are alternatives, several switches all have to be right, or those of or_when; an
// input's scale may be 0.
TEST_F(SmallPack, inputsExistUnderOneOfSeveralValues) {
    std::string table = smallTable;
    const std::string filter = "filter = \"point\"\n";
    table.insert(table.find(filter) + filter.size(),
                 "  scale = 0\n  when = { TAPS = [\"nine\", \"gather\"], FINE = \"on\" }\n");
    const std::string format = "format = \"rg16f\"\n";
    table.insert(
        table.find(format) + format.size(),
        "  when = { TAPS = \"nine\", FINE = \"on\" }\n  or_when = { TAPS = [\"one\", \"gather\"] }\n");
    writeText(folder / "pack.toml", table);
    const reprisec::Pack pack = load();
    auto variant = reprise::makeVariant(pack.passes(), "copy");
    ASSERT_TRUE(variant);
    const reprise::ImageInfo& input = variant->pass->inputs[0];
    EXPECT_EQ(reprise::scaleOf(*variant, input), 0.0);
    for (const std::string_view taps : {"one", "nine", "gather"})
        for (const std::string_view fine : {"off", "on"}) {
            ASSERT_TRUE(reprise::setSwitch(*variant, "TAPS", taps));
            ASSERT_TRUE(reprise::setSwitch(*variant, "FINE", fine));
            EXPECT_EQ(reprise::exists(*variant, input), taps != "one" && fine == "on") << taps << " " << fine;
            EXPECT_EQ(reprise::exists(*variant, variant->pass->outputs[0]), taps != "nine" || fine == "on")
                << taps << " " << fine;
        }
}

TEST_F(SmallPack, widthHasAScaleOfItsOwn) {
    std::string text = smallTable;
    text.replace(text.find("binding = 16"), 12, "binding = 16\nscale = 0.5\nwidth_scale = 1.5");
    writeText(folder / "pack.toml", text);
    const auto pack = reprisec::Pack::load(folder / "pack.toml");
    ASSERT_TRUE(pack) << pack.error().message;
    EXPECT_EQ(pack->passes()[0].outputs[0].scale, 0.5f);
    EXPECT_EQ(pack->passes()[0].outputs[0].widthScale, 1.5f);
    EXPECT_EQ(pack->passes()[0].inputs[0].widthScale, 1.0f);
}

TEST_F(SmallPack, missingTableIsNamed) {
    const auto pack = reprisec::Pack::load(folder / "none.toml");
    ASSERT_FALSE(pack);
    EXPECT_NE(pack.error().message.find("none.toml"), std::string::npos);
}

TEST_F(SmallPack, committedVariantsAreDefaultsPresetsAndSingleFlips) {
    const reprisec::Pack pack = load();
    std::vector<std::string> names;
    for (const auto& variant : pack.committedVariants(pack.passes()[0]))
        names.push_back(variantName(variant));
    const std::vector<std::string> expected{"copy", "copy--taps-nine--fine-on", "copy--taps-nine",
                                            "copy--taps-gather", "copy--fine-on"};
    EXPECT_EQ(names, expected);
}

TEST_F(SmallPack, everyNameIsReadBackAsItsVariant) {
    const reprisec::Pack pack = load();
    for (const auto& variant : pack.committedVariants(pack.passes()[0])) {
        const auto parsed = pack.parseVariant(variantName(variant));
        ASSERT_TRUE(parsed) << parsed.error().message;
        EXPECT_EQ(parsed->values, variant.values);
    }
    for (const char* wrong : {"", "copy--", "copy--taps", "copy--taps-", "copy---one", "copy--taps-nine--"}) {
        EXPECT_FALSE(pack.parseVariant(wrong)) << wrong;
    }
}

TEST_F(SmallPack, fileNamesLeaveOutSwitchesWithoutEffectInTheStage) {
    const reprisec::Pack pack = load();
    const auto preset = pack.preset("copy", "fine");
    ASSERT_TRUE(preset) << preset.error().message;
    EXPECT_EQ(spirvFileName(*preset, reprise::Stage::fragment), "copy--taps-nine--fine-on.frag.spv");
    EXPECT_EQ(spirvFileName(*preset, reprise::Stage::compute), "copy--taps-nine.comp.spv");
    EXPECT_FALSE(pack.preset("copy", "finest"));
}
