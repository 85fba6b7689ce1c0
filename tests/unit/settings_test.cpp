// The settings table: every face of a setting comes from its row, so every row must read what it writes.
#include "tracer/settings/settings.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>
#include <map>
#include <set>

using namespace gnomon;

namespace {

/// Texts that each row must take, other than its default.
const std::map<std::string_view, std::vector<std::string>>& samples() {
    static const std::map<std::string_view, std::vector<std::string>> texts{
        {"depth", {"1", "8"}},
        {"threshold", {"0", "1", "0.1", "1e-09"}},
        {"shadows", {"off", "montecarlo", "silhouette"}},
        {"epsilon", {"0.000244140625", "0.1", "0.5"}},
        {"cone-origin", {"light"}},
        {"shadow-steps", {"1", "4096"}},
        {"samples", {"1", "65536"}},
        {"first-sample", {"1", "1048576"}},
        {"light-radius", {"0", "0.25", "10000"}},
        {"march", {"steps", "sphere"}},
        {"march-steps", {"1", "4096"}},
        {"surface", {"field"}},
        {"field-method", {"adamax", "gradient", "lipschitz"}},
        {"field-resolution", {"8", "256"}},
        {"field-format", {"r16f"}},
        {"field-iterations", {"1", "1000"}},
        {"field-rate", {"1e-05", "0.05"}},
        {"field-beta1", {"0", "0.99"}},
        {"field-beta2", {"0", "0.999"}},
        {"field-starts", {"1", "5"}},
        {"field-samples", {"2", "512"}},
        {"lipschitz", {"32.5", "1000000"}},
        {"field-march", {"relaxed", "voxel"}},
        {"field-steps", {"1", "4096"}},
        {"field-epsilon", {"1e-06", "1"}},
        {"field-relaxation", {"1", "2"}},
        {"glow", {"off"}},
        {"normal-maps", {"off"}},
        {"color-mode", {"rrr", "bgr", "bbb"}},
        {"aov", {"distance", "position", "normal", "object", "visibility"}},
        {"light", {"1", "15"}},
        {"time", {"-1000000", "0.1", "1234.5678901234567"}},
        {"pause", {"on"}},
        {"eye", {"0,1.5,-3", "-0.1,1000000,1e-07"}},
        {"target", {"1,2,3"}},
        {"fov", {"0.001", "36.86989764584402", "170"}},
        {"speed", {"0.001", "10000"}},
        {"size", {"1x1", "1920x1080", "16384x4096", "8192x8192"}},
        {"scale", {"0.1", "0.3333333333333333"}},
        {"adapt", {"off"}},
        {"vsync", {"off"}},
        {"accel", {"none", "hierarchy"}},
        {"data", {"block", "texture"}},
        {"variants", {"on", "off"}},
    };
    return texts;
}

bool takes(std::string_view key, std::string_view text, Settings* result = nullptr) {
    Settings settings;
    Problems problems;
    const bool taken = setFromText(settings, key, text, "test", problems);
    EXPECT_EQ(taken, problems.empty()) << key << "=" << text;
    EXPECT_TRUE(taken || settings == Settings{}) << key << "=" << text << " changed something though it was refused";
    if (result) *result = settings;
    return taken;
}

std::string complaint(std::string_view key, std::string_view text) {
    Settings settings;
    Problems problems;
    setFromText(settings, key, text, "command line", problems);
    return toString(problems);
}

/// What a URL parser makes of a query.
std::map<std::string, std::string> parseQuery(const std::string& query) {
    std::map<std::string, std::string> pairs;
    for (std::size_t from = 0; from < query.size();) {
        const std::size_t end = std::min(query.find('&', from), query.size()), equals = query.find('=', from);
        std::string value;
        for (std::size_t i = equals + 1; i < end; ++i) {
            const bool code = query[i] == '%';
            value += code ? char(std::stoi(query.substr(i + 1, 2), nullptr, 16)) : query[i] == '+' ? ' ' : query[i];
            i += code ? 2 : 0;
        }
        pairs[query.substr(from, equals - from)] = value;
        from = end + 1;
    }
    return pairs;
}

} // namespace

TEST(Settings, HasASampleHereForEveryRow) {
    for (const auto& row : settingsTable()) EXPECT_TRUE(samples().count(row.key)) << row.key;
    EXPECT_EQ(samples().size(), settingsTable().size());
}

TEST(Settings, WritesEveryValueSoThatItReadsBackTheSame) {
    for (const auto& row : settingsTable())
        for (const auto& text : samples().at(row.key)) {
            Settings settings, again;
            ASSERT_TRUE(takes(row.key, text, &settings)) << row.key << "=" << text;
            EXPECT_NE(settings, Settings{}) << row.key << "=" << text << " changed nothing";
            EXPECT_EQ(textOf(row, settings), text) << row.key;
            ASSERT_TRUE(takes(row.key, textOf(row, settings), &again));
            EXPECT_EQ(settings, again) << row.key << "=" << text;
        }
}

TEST(Settings, WritesEveryDefaultSoThatItReadsBackTheSame) {
    for (const auto& row : settingsTable()) {
        Settings settings;
        EXPECT_TRUE(takes(row.key, textOf(row, Settings{}), &settings)) << row.key;
        EXPECT_EQ(settings, Settings{}) << row.key;
    }
}

TEST(Settings, UnsetsAnOptionalByAnEmptyText) {
    Settings settings;
    Problems problems;
    ASSERT_TRUE(setFromText(settings, "eye", "1,2,3", "test", problems));
    ASSERT_TRUE(setFromText(settings, "eye", "", "test", problems));
    EXPECT_EQ(settings, Settings{});
}

TEST(Settings, ReadsBooleansInTheUsualWords) {
    for (const char* yes : {"on", "true", "1"}) {
        Settings settings;
        EXPECT_TRUE(takes("pause", yes, &settings));
        EXPECT_TRUE(settings.pause) << yes;
    }
    for (const char* no : {"off", "false", "0"}) {
        Settings settings;
        EXPECT_TRUE(takes("glow", no, &settings));
        EXPECT_FALSE(settings.glow) << no;
    }
}

TEST(Settings, RefusesWhatIsNoValueAndThenChangesNothing) {
    const std::map<std::string_view, std::vector<std::string>> wrong{
        {"depth", {"", "0", "9", "-1", "4.0", "4x", " 4", "+4", "99999999999999", "four"}},
        {"threshold", {"", "nan", "NaN", "inf", "-inf", "1e999", "0x1", "0.5 ", " 0.5", "1.0001", "-0.1", "e", "."}},
        {"shadows", {"", "Hard", "soft", "on"}},
        {"glow", {"", "yes", "2", "ON"}},
        {"color-mode", {"", "rgba", "xyz", "5", "RGB"}},
        {"light", {"16", "-1"}},
        {"time", {"1000001", "-1e7", "1,5", "nan"}},
        {"eye", {"1,2", "1,2,3,4", "1;2;3", "1,2,", ",,", "nan,0,0", "0,inf,0", "0,0,1e9"}},
        {"fov", {"0", "180", "-30"}},
        {"size",
         {"0x0", "0x5", "5x0", "100000x1", "16384x16384", "8193x8192", "800", "800x", "x600", "800x600x2", "8e2x600",
          "-1x5"}},
        {"scale", {"0", "0.09", "1.01"}},
    };
    for (const auto& [key, texts] : wrong)
        for (const auto& text : texts) EXPECT_FALSE(takes(key, text)) << key << "=" << text;
}

TEST(Settings, SaysWhatIsWrongWhatTheRangeIsAndWhatMayBeMeant) {
    EXPECT_EQ(complaint("depth", "9"), "command line: depth: 9 is out of range; use 1…8\n");
    EXPECT_EQ(complaint("depth", "many"), "command line: depth: 'many' is not a whole number; use 1…8\n");
    EXPECT_EQ(complaint("shadows", "haard"),
              "command line: shadows: 'haard' is none of "
              "off|hard|montecarlo|montecarlo-march|quilez|aaltonen|cone-base|cone-linear|"
              "cone-discrete|cone-convex|silhouette; did you mean 'hard'?\n");
    EXPECT_EQ(complaint("shadow", "hard"), "command line: there is no setting 'shadow'; did you mean 'shadows'?\n");
    EXPECT_EQ(complaint("size", "800"), "command line: size: '800' is not a size; use WIDTHxHEIGHT, as 800x600\n");
}

TEST(Settings, HasNoTwoRowsOfOneKeyAndNoTwoMeaningsOfOneHotkey) {
    std::set<std::string_view> keys, hotkeys;
    for (const auto& row : settingsTable()) {
        EXPECT_TRUE(keys.insert(row.key).second) << row.key;
        for (auto hotkey : {row.next, row.previous})
            EXPECT_TRUE(hotkey.empty() || hotkeys.insert(hotkey).second) << hotkey;
        for (unsigned char c : row.key) EXPECT_TRUE(std::islower(c) || std::isdigit(c) || c == '-') << row.key;
        EXPECT_FALSE(row.help.empty()) << row.key;
        EXPECT_FALSE(row.group.empty()) << row.key;
        for (const auto alias : row.aliases) EXPECT_TRUE(keys.insert(alias).second) << alias;
    }
    for (const char* steering : {"W", "A", "S", "D", "Shift"}) EXPECT_FALSE(hotkeys.count(steering)) << steering;
}

TEST(Settings, SwitchShadowsGlowNormalMapsPauseAndVsyncByTheirKeys) {
    Settings settings;
    EXPECT_EQ(pressHotkey(settings, "1"), "shadows off");
    EXPECT_EQ(settings.shadows, ShadowModel::Off);
    EXPECT_EQ(pressHotkey(settings, "1"), "shadows hard");
    EXPECT_EQ(settings.shadows, ShadowModel::Hard);
    EXPECT_EQ(pressHotkey(settings, "G"), "glow off");
    EXPECT_FALSE(settings.glow);
    EXPECT_EQ(pressHotkey(settings, "N"), "normal-maps off");
    EXPECT_FALSE(settings.normalMaps);
    EXPECT_EQ(pressHotkey(settings, "P"), "pause on");
    EXPECT_TRUE(settings.pause);
    EXPECT_EQ(pressHotkey(settings, "V"), "vsync off");
    EXPECT_FALSE(settings.vsync);
}

TEST(Settings, StepDepthByRightAndLeftAndStopAtTheEnds) {
    Settings settings;
    for (int depth = 5; depth <= 8; ++depth)
        EXPECT_EQ(pressHotkey(settings, "Right"), "depth " + std::to_string(depth));
    EXPECT_EQ(pressHotkey(settings, "Right"), "depth 8, the most");
    for (int depth = 7; depth >= 1; --depth) EXPECT_EQ(pressHotkey(settings, "Left"), "depth " + std::to_string(depth));
    EXPECT_EQ(pressHotkey(settings, "Left"), "depth 1, the least");
    EXPECT_EQ(settings.depth, 1);
}

TEST(Settings, GoThroughAll27ColourModesByUpAndBackByDown) {
    Settings settings;
    EXPECT_EQ(colorModes()[settings.colorMode], "rgb");
    std::set<int> seen;
    for (int i = 0; i < 27; ++i) {
        EXPECT_FALSE(pressHotkey(settings, "Up").empty());
        seen.insert(settings.colorMode);
    }
    EXPECT_EQ(seen.size(), 27U);
    EXPECT_EQ(settings, Settings{});
    settings.colorMode = 0;
    EXPECT_EQ(pressHotkey(settings, "Down"), "color-mode bbb");
    EXPECT_EQ(pressHotkey(settings, "Up"), "color-mode rrr");
}

TEST(Settings, NameEveryColourModeByTheThreeChannelsItPicks) {
    const std::string channels = "rgb";
    for (int i = 0; i < 27; ++i) {
        const std::string name{channels[i / 9], channels[i / 3 % 3], channels[i % 3]};
        EXPECT_EQ(colorModes()[i], name);
    }
}

TEST(Settings, AnswerNothingToAKeyThatIsNobodys) {
    Settings settings;
    for (const char* key : {"", "Z", "W", "Shift", "F1", "right"}) EXPECT_EQ(pressHotkey(settings, key), "") << key;
    EXPECT_EQ(settings, Settings{});
}

TEST(Settings, GoThroughAUrlAndBack) {
    EXPECT_EQ(toUrlQuery(Settings{}), "");
    for (int which = 0; which < 2; ++which) {
        Settings settings, again;
        Problems problems;
        for (const auto& row : settingsTable()) {
            const auto& texts = samples().at(row.key);
            ASSERT_TRUE(setFromText(settings, row.key, which == 0 ? texts.front() : texts.back(), "test", problems));
        }
        const std::string query = toUrlQuery(settings);
        for (unsigned char c : query)
            EXPECT_TRUE(std::isalnum(c) || std::string("-._~,%=&").find(char(c)) != std::string::npos) << query;
        for (const auto& [key, value] : parseQuery(query)) ASSERT_TRUE(setFromText(again, key, value, "URL", problems));
        EXPECT_EQ(settings, again) << query;
    }
}

TEST(Settings, TellOnlyTheDifferencesInAUrl) {
    Settings settings;
    settings.depth = 7;
    settings.eye = {0, 1.5, -3};
    EXPECT_EQ(toUrlQuery(settings), "depth=7&eye=0,1.5,-3");
}

TEST(Settings, AreCompleteInTheirJson) {
    const auto table = nlohmann::json::parse(settingsJson());
    ASSERT_EQ(table.size(), settingsTable().size());
    for (std::size_t i = 0; i < table.size(); ++i) {
        const auto& row = settingsTable()[i];
        EXPECT_EQ(table[i].at("key"), row.key);
        EXPECT_EQ(table[i].at("help"), row.help);
        EXPECT_EQ(table[i].at("range"), rangeOf(row));
        for (const char* member : {"type", "default", "group", "hotkeys", "effect"})
            EXPECT_TRUE(table[i].contains(member)) << row.key << " " << member;
    }
    EXPECT_EQ(table[0].at("default"), 4);
    EXPECT_EQ(table[0].at("hotkeys"), nlohmann::json({"Right", "Left"}));
}

TEST(Settings, TakeTheirEarlierKeysAndNamesAndWriteThePresentOnes) {
    for (const auto& [was, is] : {std::pair{"direction=b", "cone-origin=light"},
                                  {"direction=light", "cone-origin=light"},
                                  {"cone-origin=b", "cone-origin=light"},
                                  {"parts=off", "variants=off"}}) {
        const std::string pair = was;
        const std::size_t equals = pair.find('=');
        Settings settings;
        EXPECT_TRUE(takes(pair.substr(0, equals), pair.substr(equals + 1), &settings)) << was;
        EXPECT_EQ(toUrlQuery(settings), is) << was;
    }
    Settings settings;
    EXPECT_TRUE(takes("direction", "a", &settings));
    EXPECT_EQ(settings, Settings{});
}

TEST(Settings, RefuseUnderAnEarlierKeyInThePresentWords) {
    EXPECT_EQ(complaint("direction", "c"), "command line: cone-origin: 'c' is none of surface|light\n");
    EXPECT_EQ(complaint("parts", "offf"),
              "command line: variants: 'offf' is none of auto|on|off; did you mean 'off'?\n");
    EXPECT_EQ(complaint("directon", "a"),
              "command line: there is no setting 'directon'; did you mean 'cone-origin'?\n");
}

TEST(Settings, TellTheirEarlierNamesInTheirJson) {
    for (const auto& row : nlohmann::json::parse(settingsJson())) {
        if (row["key"] == "cone-origin") {
            EXPECT_EQ(row["aliases"], nlohmann::json({"direction"}));
            EXPECT_EQ(row["renamed"], (nlohmann::json{{"a", "surface"}, {"b", "light"}}));
        } else if (row["key"] == "variants") {
            EXPECT_EQ(row["aliases"], nlohmann::json({"parts"}));
        } else {
            EXPECT_FALSE(row.contains("aliases")) << row["key"];
        }
    }
}

TEST(Settings, HaveOneLineEachInTheirMarkdown) {
    const std::string text = settingsMarkdown();
    EXPECT_EQ(std::size_t(std::count(text.begin(), text.end(), '\n')), settingsTable().size() + 2);
    for (const auto& row : settingsTable())
        EXPECT_NE(text.find("| `" + std::string(row.key) + "` |"), std::string::npos);
}
