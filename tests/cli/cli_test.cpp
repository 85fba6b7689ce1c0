// The program from outside: exit codes, messages, and that a command that fails writes nothing.
#include "tests/cli/cli.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <string>

namespace fs = std::filesystem;

namespace {

TEST_F(Cli, LabIntersectFindsNothingWrongAndWritesItsNumbers) {
    const Answer run =
        gnomon("lab intersect --shapes=disc --distances=3,1000 --rays=200 --json=all.json --html=all.html");
    EXPECT_EQ(run.code, 0) << run.err;
    EXPECT_NE(run.out.find("\n0 of "), std::string::npos) << run.out;
    const auto results = nlohmann::json::parse(readText(folder_ / "all.json"));
    EXPECT_EQ(results["format"], "gnomon-results");
    EXPECT_EQ(results["command"], "gnomon lab intersect --rays=200 --context=osmesa --distances=3,1000 --shapes=disc");
    const auto& table = results["tables"][1];
    EXPECT_EQ(table["rows"].size(), 8U) << "uniform, grazing, tangent and axis rays at two distances";
    for (const auto& row : table["rows"]) EXPECT_EQ(row.size(), table["columns"].size());
    for (const auto& chart : results["charts"]) EXPECT_EQ(chart["table"], table["name"]);
    const std::string page = readText(folder_ / "all.html");
    EXPECT_NE(page.find("gnomon-results"), std::string::npos);
    EXPECT_EQ(page.find("<link"), std::string::npos) << "it loads nothing";
    EXPECT_EQ(gnomon("lab intersect --shapes=triangle --distances=3 --rays=100").code, 0)
        << "fans are searched by balls";
}

TEST_F(Cli, LabRefusesWhatItDoesNotKnow) {
    expectRefused("lab intersct", 2, "did you mean 'intersect'?");
    expectRefused("lab intersect --shapes=torsus", 2, "did you mean 'torus'?");
    expectRefused("lab intersect --shaps=torus", 2, "did you mean --shapes?");
    expectRefused("lab intersect --rays=1", 2, "use 100");
    expectRefused("lab intersect --distances=0", 2, "use 2");
    expectRefused("lab intersect --context=metal", 2, "osmesa|egl|window");
}

/// How many rows of a table have no value in the column called `key`.
int emptyIn(const nlohmann::json& table, const std::string& key) {
    const auto& columns = table["columns"];
    const auto column = std::find_if(columns.begin(), columns.end(), [&](const auto& c) { return c["key"] == key; });
    EXPECT_NE(column, columns.end()) << key;
    const std::size_t at = std::size_t(column - columns.begin());
    return int(std::count_if(table["rows"].begin(), table["rows"].end(),
                             [&](const auto& row) { return row.at(at).is_null(); }));
}

TEST_F(Cli, LabTraceMeasuresEveryWayAndWritesItsNumbers) {
    const Answer run = gnomon("lab trace --scenes=lite --spheres=10,100 --size=64x48 --repeats=3 --json=all.json "
                              "--html=all.html");
    EXPECT_EQ(run.code, 0) << run.err;
    EXPECT_NE(run.out.find("random spheres, 10 to 100: "), std::string::npos) << run.out;
    const auto results = nlohmann::json::parse(readText(folder_ / "all.json"));
    EXPECT_EQ(results["command"], "gnomon lab trace --scenes=lite --spheres=10,100 --size=64x48 --depth=8 "
                                  "--shadows=hard --repeats=3 --context=osmesa");
    const auto &scenes = results["tables"][0], &growth = results["tables"][1], &choice = results["tables"][2];
    EXPECT_EQ(scenes["rows"].size(), 8U)
        << "the source's way, shader variants, and three that read a uniform block and a texture";
    EXPECT_EQ(growth["rows"].size(), 18U) << "three arrangements of two numbers in three ways";
    EXPECT_EQ(choice["rows"].size(), 8U) << "lite from a block and from a texture, and six of spheres";
    for (const char* counter : {"boxes", "objects", "shadow_rays"}) {
        EXPECT_EQ(emptyIn(scenes, counter), 1) << "only the source's way does not count";
        EXPECT_EQ(emptyIn(growth, counter), 0);
    }
    for (const char* time : {"frame", "ratio", "speed_up", "compile"}) EXPECT_EQ(emptyIn(scenes, time), 0);
    for (const char* time : {"frame", "growth", "pack", "load"}) EXPECT_EQ(emptyIn(growth, time), 0);
    EXPECT_NE(readText(folder_ / "all.html").find("gnomon-results"), std::string::npos);
}

TEST_F(Cli, LabShadowsMeasuresEveryWayAndDrawsIt) {
    const Answer run =
        gnomon("lab shadows --scenes=simple --models=hard,montecarlo,cone-linear,silhouette --samples=1,4 "
               "--epsilons=0.1 --radii=0.5 --size=64x48 --reference=64 --repeats=2 --json=all.json "
               "--pictures=pictures");
    EXPECT_EQ(run.code, 0) << run.err;
    const auto results = nlohmann::json::parse(readText(folder_ / "all.json"));
    const auto &shadows = results["tables"][0], &rivals = results["tables"][2];
    EXPECT_EQ(shadows["rows"].size(), 6U) << "hard, twice Monte Carlo, linear from both ends, silhouette";
    for (const char* number : {"frame", "ratio", "evaluations", "rmse", "picture"})
        EXPECT_EQ(emptyIn(shadows, number), 0);
    EXPECT_EQ(emptyIn(shadows, "epsilon"), 4);
    EXPECT_EQ(rivals["rows"].size(), 0U) << "linear at 1/30 was not asked for";
    for (const char* model : {"hard", "cone-linear", "silhouette"})
        EXPECT_TRUE(std::filesystem::exists(folder_ / "pictures" / ("simple-" + std::string(model) + ".png"))) << model;
}

TEST_F(Cli, UnderstandsEarlierSpellingsAndWritesThePresentOnes) {
    const Answer now = gnomon(
                     "render simple --size=32x24 --shadows=cone-linear --cone-origin=light --variants=off -o a.pfm"),
                 then = gnomon("render simple --size=32x24 --shadows=cone-linear --direction=b --parts=off -o b.pfm");
    EXPECT_EQ(now.code + then.code, 0) << now.err << then.err;
    EXPECT_EQ(readText(folder_ / "a.pfm"), readText(folder_ / "b.pfm"));
    const std::string words =
        "--models=cone-linear --epsilons=0.1 --size=16x12 --reference=16 --repeats=1 --json=l.json";
    EXPECT_EQ(gnomon("lab shadows --scenes=simple --directions=a " + words).code, 0);
    EXPECT_NE(readText(folder_ / "l.json").find(" --cone-origins=surface "), std::string::npos);
    EXPECT_EQ(gnomon("bench simple --depth=1 --shadows=cone-linear --direction=a,b --size=16x12 --repeats=1 "
                     "--baseline=direction=b --json=b.json")
                  .code,
              0);
    EXPECT_NE(readText(folder_ / "b.json").find(" --cone-origin=surface,light "), std::string::npos);
    expectRefused("render simple --direction=c -o c.png", 2, "cone-origin: 'c' is none of surface|light");
    expectRefused("render simple --directon=a -o c.png", 2, "did you mean --direction?");
}

TEST_F(Cli, LabShadowsRefusesWhatItDoesNotKnow) {
    expectRefused("lab shadows --models=cone-liner", 2, "did you mean 'cone-linear'?");
    expectRefused("lab shadows --models=off", 2, "'off' is no shadow model");
    expectRefused("lab shadows --scenes=simpel", 1, "did you mean 'simple'?");
    expectRefused("lab shadows --epsilons=2", 2, "use 0.000244");
    expectRefused("lab shadows --cone-origins=c", 2, "use surface or both");
    expectRefused("lab shadows --reference=1", 2, "use 16");
    expectRefused("lab shadows --size=0x4", 2, "size: 0 is out of range");
}

TEST_F(Cli, LabTraceRefusesWhatItDoesNotKnow) {
    expectRefused("lab trce", 2, "did you mean 'trace'?");
    expectRefused("lab trace --scens=lite", 2, "did you mean --scenes?");
    expectRefused("lab trace --scenes=lit", 1, "there is no scene 'lit'; did you mean 'lite'?");
    expectRefused("lab trace --spheres=7", 2, "spheres: 7 is out of range; use 8");
    expectRefused("lab trace --spheres=ten", 2, "spheres");
    expectRefused("lab trace --repeats=0", 2, "use 1");
    expectRefused("lab trace --depth=9", 2, "depth: 9 is out of range; use 1…8");
    expectRefused("lab trace --size=0x600", 2, "size: 0 is out of range");
    expectRefused("lab trace --shadows=haard", 2, "did you mean 'hard'?");
    expectRefused("lab trace --context=metal", 2, "osmesa|egl|window");
}

TEST_F(Cli, BenchMeasuresEveryCombinationAndWritesItsNumbers) {
    const Answer run =
        gnomon("bench lite --depths=1,4 --shadows=off,hard --sizes=32x24 --repeats=3 --context=osmesa,egl "
               "--baseline=shadows=off --json=all.json --html=all.html");
    EXPECT_EQ(run.code, 0) << run.err;
    EXPECT_EQ(run.err, "");
    const auto results = nlohmann::json::parse(readText(folder_ / "all.json"));
    EXPECT_EQ(results["command"], "gnomon bench lite --context=osmesa,egl --depth=1,4 --shadows=off,hard --size=32x24 "
                                  "--baseline=shadows=off --repeats=3");
    EXPECT_EQ(results["environment"]["rounds"], "osmesa 3 of 3, egl 3 of 3");
    const auto& table = results["tables"][0];
    EXPECT_EQ(table["rows"].size(), 8U) << "two contexts, depths and kinds of shadows";
    for (const char* key : {"fps", "frame", "frame_low", "frame_high", "frame_calibrated", "cpu", "ratio", "compile",
                            "first", "source", "rounds"})
        EXPECT_EQ(emptyIn(table, key), 0) << key;
    for (const auto& column : table["columns"]) EXPECT_NE(column["key"], "gpu") << "llvmpipe has no GPU to time";
    EXPECT_EQ(results["charts"].size(), 2U) << "one for each context";
    EXPECT_NE(readText(folder_ / "all.html").find("gnomon-results"), std::string::npos);
}

TEST_F(Cli, BenchRefusesWhatItDoesNotKnow) {
    expectRefused("bench lit", 1, "there is no scene 'lit'; did you mean 'lite'?");
    expectRefused("bench --depths=1,9", 2, "depth: 9 is out of range; use 1…8");
    expectRefused("bench --shadows=off,haard", 2, "did you mean 'hard'?");
    expectRefused("bench --size=800", 2, "use WIDTHxHEIGHT, as 800x600");
    expectRefused("bench --shadow=off", 2, "did you mean --shadows?");
    expectRefused("bench --repeats=0", 2, "repeats: 0 is out of range; use 1…10000");
    expectRefused("bench --limit=0", 2, "limit: 0 is out of range");
    expectRefused("bench --context=osmesa,metal", 2, "'metal' is none of osmesa|egl|window");
    expectRefused("bench --baseline=depth=2", 2, "depth is never '2' here");
    expectRefused("bench --json=none/all.json", 2, "none/all.json: there is no folder none; make it first");
    expectRefused("bench lite --eye=1,2,3 --target=1,2,3", 2, "the camera looks at its own position");
    expectRefused("bench lite --context=osmesa,window", 3, "leave window out of --context");
}

TEST_F(Cli, BenchKeepsWhatItMeasuredWhereItIsInterrupted) {
    const Answer run =
        gnomon("bench lite --depth=1 --shadows=off --size=32x24 --repeats=10000 --json=all.json",
               "timeout --foreground --preserve-status --signal=INT 8 env -u DISPLAY -u WAYLAND_DISPLAY");
    EXPECT_EQ(run.code, 130) << run.err;
    EXPECT_NE(run.out.find("Interrupted: what was measured is kept."), std::string::npos) << run.out;
    const auto results = nlohmann::json::parse(readText(folder_ / "all.json"));
    EXPECT_NE(results["environment"]["rounds"].get<std::string>().find("of 10000; interrupted"), std::string::npos);
    ASSERT_EQ(results["tables"][0]["rows"].size(), 1U);
    EXPECT_EQ(emptyIn(results["tables"][0], "frame"), 0);
    EXPECT_EQ(gnomon("report all.json -o all.html").code, 0) << "what was kept is complete";
}

TEST_F(Cli, BenchEndsByItsLimitAfterAWholeRound) {
    const Answer run =
        gnomon("bench lite --depth=1 --shadows=off --size=32x24 --repeats=10000 --limit=3 --json=all.json");
    EXPECT_EQ(run.code, 0) << run.err;
    EXPECT_NE(run.out.find("; ended by --limit=3"), std::string::npos) << run.out;
}

TEST_F(Cli, ReportMakesOnePageOfSeveralRunsAndComparesTwo) {
    for (const char* file : {"old.json", "new.json"})
        ASSERT_EQ(
            gnomon(std::string("bench lite --depth=1 --shadows=off,hard --size=32x24 --repeats=5 --json=") + file).code,
            0);
    EXPECT_EQ(gnomon("report old.json new.json -o both.html").out, "both.html written\n");
    const Answer run = gnomon("report --against old.json new.json --json=change.json -o change.html");
    EXPECT_EQ(run.code, 0) << run.err;
    EXPECT_NE(run.out.find("Frames a second: frame"), std::string::npos) << run.out;
    EXPECT_NE(run.out.find("What changed"), std::string::npos) << run.out;
    const auto change = nlohmann::json::parse(readText(folder_ / "change.json"));
    EXPECT_EQ(change["command"], "gnomon report --against old.json new.json --tolerance=5");
    EXPECT_EQ(change["tables"][0]["name"], "changes");
    EXPECT_EQ(change["tables"][1]["columns"].back()["key"], "verdict");
    EXPECT_EQ(emptyIn(change["tables"][1], "ratio"), 0);
    EXPECT_TRUE(fs::exists(folder_ / "change.html"));
}

// One number made worse, one count made less, one row taken away: each is told, and nothing else.
TEST_F(Cli, ReportComparesWhatLabsMeasure) {
    const Answer lab = gnomon("lab shadows --scenes=simple --models=hard,silhouette,quilez --size=32x24 --reference=16 "
                              "--repeats=1 --json=old.json");
    ASSERT_EQ(lab.code, 0) << lab.err;
    auto results = nlohmann::json::parse(readText(folder_ / "old.json"));
    auto& table = results["tables"][0];
    const auto cell = [&](std::size_t row, const char* key) -> nlohmann::json& {
        for (std::size_t i = 0; i < table["columns"].size(); ++i)
            if (table["columns"][i]["key"] == key) return table["rows"][row][i];
        ADD_FAILURE() << key;
        return table;
    };
    cell(0, "rmse") = 2 * cell(0, "rmse").get<double>();
    cell(1, "evaluations") = cell(1, "evaluations").get<double>() + 1;
    table["rows"].erase(2);
    results.erase("pictures");
    write("new.json", results.dump());
    const Answer run = gnomon("report --against old.json new.json --json=change.json");
    EXPECT_EQ(run.code, 0) << run.err;
    const auto change = nlohmann::json::parse(readText(folder_ / "change.json"));
    for (const auto& one : change["tables"])
        if (one["name"] == "shadows_changed") {
            ASSERT_EQ(one["rows"].size(), 2U);
            for (const auto& row : one["rows"]) EXPECT_EQ(row.back(), "worse");
        } else if (one["name"] == "missing") {
            ASSERT_FALSE(one["rows"].empty());
            EXPECT_EQ(one["rows"][0][2], "old");
        } else if (one["name"] != "changes") {
            for (const auto& row : one["rows"]) EXPECT_EQ(row.back(), "the same within noise") << one["name"];
        }
    EXPECT_NE(run.out.find("Rows that only one run has"), std::string::npos) << run.out;
    EXPECT_NE(run.out.find("errors and counts that changed"), std::string::npos) << run.out;
}

TEST_F(Cli, ReportRefusesFilesThatAreNoResults) {
    write("scene.json", kScene);
    write("cut.json", "{\n\"format\": \"gnomon-results\",\n\"version\": 1,\n\"title\": [\n");
    write("number.json", "{\n\"format\": \"gnomon-results\",\n\"version\": 1,\n\"title\": 3\n}");
    expectRefused("report scene.json -o x.html", 1, "scene.json:1: this is no file of results; give a file that");
    expectRefused("report cut.json -o x.html", 1, "cut.json:");
    expectRefused("report number.json -o x.html", 1, "number.json:4: title: has to be a string, not a number");
    expectRefused("report none.json -o x.html", 1, "none.json: cannot be read");
    expectRefused("report . -o x.html", 1, ".: is a folder");
    expectRefused("report number.json", 2, "use -o report.html, or --against OLD.json");
    expectRefused("report --against scene.json", 2, "FILES is required");
    expectRefused("report --against scene.json cut.json number.json", 2, "2 files are held against it");
    expectRefused("report number.json -o none/x.html", 2, "there is no folder none");
    expectRefused("report --against scene.json number.json --tolerance=-1", 2, "use 0…99 per cent");
}

TEST_F(Cli, LabSaysWhereItCannotWriteBeforeItMeasures) {
    for (const char* lab : {"intersect", "trace", "shadows"})
        expectRefused(std::string("lab ") + lab + " --json=none/all.json", 2, "none/all.json: there is no folder none");
    expectRefused("lab intersect --picture=none/x.png", 2, "none/x.png: there is no folder none");
}

} // namespace

TEST_F(Cli, RefusesSettingsOutOfRangeWithTheRange) {
    expectRefused("render lite -o x.png --size=0x600", 2, "size: 0 is out of range; use 1…16384");
    expectRefused("render lite -o x.png --size=100000x600", 2, "size: 100000 is out of range; use 1…16384");
    expectRefused("render lite -o x.png --depth=9", 2, "depth: 9 is out of range; use 1…8");
    expectRefused("render lite -o x.png --depth=0", 2, "depth: 0 is out of range; use 1…8");
    expectRefused("render lite -o x.png --fov=180", 2, "fov: 180 is out of range; use 0.001…170");
}

TEST_F(Cli, RefusesNumbersThatAreNone) {
    expectRefused("render lite -o x.png --time=nan", 2, "time: 'nan' is not a number");
    expectRefused("render lite -o x.png --fov=inf", 2, "fov: 'inf' is not a number");
    expectRefused("render lite -o x.png --eye=0,nan,3", 2, "eye: 'nan' is not a number");
    expectRefused("render lite -o x.png --eye=0,0", 2, "eye: '0,0' is not a point");
    expectRefused("render lite -o x.png --depth=four", 2, "depth: 'four' is not a whole number");
    expectRefused("render lite -o x.png --depth", 2, "--depth has no value");
}

TEST_F(Cli, SuggestsTheWordThatMayBeMeant) {
    expectRefused("render lite -o x.png --dept=3", 2, "there is no option --dept; did you mean --depth?");
    expectRefused("render lite -o x.png --shadows=haard", 2, "did you mean 'hard'?");
    expectRefused("render lit -o x.png", 1, "there is no scene 'lit'; did you mean 'lite'?");
    expectRefused("rendr lite -o x.png", 2, "there is no command 'rendr'; did you mean 'render'?");
    expectRefused("settings --jsn", 2, "did you mean --json?");
}

TEST_F(Cli, RefusesWordsThatAreMissingOrTooMany) {
    expectRefused("render", 2, "SCENE is required");
    expectRefused("render lite", 2, "--output is required");
    expectRefused("render lite more -o x.png", 2, "'more' is one word too many");
    expectRefused("render lite -o x.png --context=glut", 2, "'glut' is none of osmesa|egl|window");
    expectRefused("shader lite --pass=blur", 2, "'blur' is none of trace|base|sky|canvas");
    expectRefused("view lite --window=qt", 2, "'qt' is none of glfw|sdl");
}

TEST_F(Cli, ReportsEveryWrongSettingAtOnce) {
    const Answer run = gnomon("render lite -o x.jpg --depth=9 --glow=maybe");
    EXPECT_EQ(run.code, 2);
    for (const char* part : {"depth: 9", "glow: 'maybe'", "x.jpg: the picture's format is unknown"})
        EXPECT_NE(run.err.find(part), std::string::npos) << run.err;
    EXPECT_EQ(files(), 0U);
}

TEST_F(Cli, RefusesFilesThatCannotHoldTheOutput) {
    expectRefused("render lite -o x.jpg", 2, "end the name with .png, .pfm or .exr");
    expectRefused("render lite -o x.png --aov=distance", 2, "a PNG cannot hold distance");
    expectRefused("render lite -o missing/x.png", 2, "there is no folder missing");
}

TEST_F(Cli, RefusesSettingsThatDoNotFitTheScene) {
    expectRefused("render lite -o x.pfm --aov=visibility --light=7", 2, "lite has no light 7; use 0…2");
    expectRefused("render lite -o x.png --eye=1,2,3 --target=1,2,3", 2, "the camera looks at its own position");
}

TEST_F(Cli, RefusesScenesThatAreMissingOrBroken) {
    expectRefused("render nowhere.json -o x.png", 1, "nowhere.json: there is no such scene file");
    expectRefused("render . -o x.png", 1, ".: is a folder");
    write("broken.json", "{\"objects\": [\n");
    expectRefused("render broken.json -o x.png", 1, "broken.json:");
    write("number.json", "{\"objects\": [{\"sphere\": {\"center\": [0, 0, NaN], \"radius\": 1}}]}\n");
    expectRefused("check number.json", 1, "number.json:1");
    write("empty.json", "");
    expectRefused("check empty.json", 1, "empty.json");
}

TEST_F(Cli, ReportsEveryProblemOfASceneWithItsLine) {
    write("wrong.json", "{\n\"objects\": [\n{\"sphere\": {\"center\": [0, 0, 0], \"radius\": -1}},\n"
                        "{\"sphere\": {\"centre\": [0, 0, 0], \"radius\": 1}}\n]}\n");
    const Answer run = gnomon("check wrong.json");
    EXPECT_EQ(run.code, 1);
    EXPECT_NE(run.err.find("gnomon: error: wrong.json:3: "), std::string::npos) << run.err;
    EXPECT_NE(run.err.find("gnomon: error: wrong.json:4: "), std::string::npos) << run.err;
}

TEST_F(Cli, SaysWhichImageIsMissingAndWhereItWasLookedFor) {
    write("bare.json", R"({"materials": {"m": {"texture": {"image": "nosuchimage"}}},
                           "objects": [{"sphere": {"center": [0, 0, 0], "radius": 1}, "material": "m"}]})");
    expectRefused("render bare.json -o x.png", 1,
                  "bare.json: image 'nosuchimage' is missing; put it at nosuchimage.png or ");
    write("nosuchimage.png", "not a picture");
    expectRefused("render bare.json -o x.png", 1, "nosuchimage.png: cannot be read as a picture");
}

TEST_F(Cli, NeedsADisplayOnlyForAWindow) {
    expectRefused("view lite", 3, "`gnomon render SCENE -o FILE` draws in memory");
    expectRefused("", 3, "`gnomon render SCENE -o FILE` draws in memory");
    expectRefused("render lite -o x.png --context=window", 3, "no display can be opened");
}

TEST_F(Cli, SaysWhereTheAssetsAreExpected) {
    const Answer run = gnomon("scenes", "env GNOMON_ASSETS=/nowhere");
    EXPECT_EQ(run.code, 1);
    EXPECT_NE(run.err.find("GNOMON_ASSETS: /nowhere holds no folder scenes"), std::string::npos) << run.err;
}

TEST_F(Cli, RendersAPictureInEveryFormat) {
    for (const char* file : {"x.png", "x.pfm", "x.exr"}) {
        const Answer run = gnomon(std::string("render lite --size=32x24 -o ") + file);
        EXPECT_EQ(run.code, 0) << run.err;
        EXPECT_EQ(run.err, "");
        EXPECT_NE(run.out.find("lite, 32 x 24"), std::string::npos) << run.out;
        EXPECT_TRUE(fs::exists(folder_ / file));
    }
    EXPECT_EQ(readText(folder_ / "x.pfm").size(), std::string("PF\n32 24\n-1.0\n").size() + 32 * 24 * 3 * 4);
    EXPECT_EQ(files(), 3U);
}

TEST_F(Cli, RendersTheUsersOwnSceneFile) {
    write("mine.json", kScene);
    EXPECT_EQ(gnomon("check mine.json").out, "mine: right (1 object, 1 light, 2 materials, 0 images)\n");
    const Answer run = gnomon("render mine.json --aov=distance --size=3x3 --eye=0,0,3 --target=0,0,0 -o d.pfm");
    EXPECT_EQ(run.code, 0) << run.err;
    const std::string bytes = readText(folder_ / "d.pfm"), head = "Pf\n3 3\n-1.0\n";
    ASSERT_EQ(bytes.size(), head.size() + 9 * 4);
    float middle = 0;
    std::memcpy(&middle, bytes.data() + head.size() + 4 * 4, 4);
    EXPECT_FLOAT_EQ(middle, 2.5F); // eye at 3, radius 0.5
}

TEST_F(Cli, TakesTheLastOfASettingGivenTwiceAndNegativeNumbersApart) {
    const Answer run = gnomon("render lite --depth=9 --depth=1 --eye -1,2,30 --size=8x8 -o x.png");
    EXPECT_EQ(run.code, 0) << run.err;
}

TEST_F(Cli, PrintsTheShaderWithoutAnyGl) {
    const Answer es = gnomon("shader lite"), core = gnomon("shader lite --glsl=gl330"),
                 canvas = gnomon("shader lite --pass=canvas"), sky = gnomon("shader lite --pass=sky"),
                 base = gnomon("shader lite --pass=base --variants=on"),
                 earlier = gnomon("shader lite --pass=usual --parts=on");
    EXPECT_EQ(es.code, 0) << es.err;
    EXPECT_EQ(es.out.rfind("#version 300 es", 0), 0U);
    EXPECT_EQ(core.out.rfind("#version 330 core", 0), 0U);
    EXPECT_NE(canvas.out.find("gl_Position"), std::string::npos);
    EXPECT_EQ(sky.out.find("struct Sphere"), std::string::npos);
    EXPECT_NE(base.out.find("discard"), std::string::npos);
    EXPECT_EQ(base.out.find("== kDielectric"), std::string::npos) << "lite's glass is an uncommon feature";
    EXPECT_EQ(base.out, earlier.out) << "the earlier names of pass and setting";
    EXPECT_NE(es.out.find("== kDielectric"), std::string::npos);
    EXPECT_EQ(es.out.find("Torus"), std::string::npos) << "lite has no torus, so its shader must not";
}

TEST_F(Cli, MeasuresTheShader) {
    const Answer run = gnomon("shader lite --stats");
    EXPECT_EQ(run.code, 0) << run.err;
    for (const char* part : {"bytes ", "lines ", "modules ", "pass/trace.frag", "compile "})
        EXPECT_NE(run.out.find(part), std::string::npos) << run.out;
}

TEST_F(Cli, ListsScenesSettingsAndGlAsTextAndAsJson) {
    for (const char* list : {"scenes", "settings", "info"}) {
        const Answer text = gnomon(list), json = gnomon(std::string(list) + " --json");
        EXPECT_EQ(text.code, 0) << text.err;
        EXPECT_NE(text.out, "");
        EXPECT_TRUE(nlohmann::json::accept(json.out)) << json.out;
    }
    EXPECT_NE(gnomon("scenes").out.find("lite"), std::string::npos);
}

TEST_F(Cli, ExplainsEveryCommandAndSetting) {
    const Answer all = gnomon("--help");
    EXPECT_EQ(all.code, 0);
    for (const char* command : {"view", "render", "bench", "report", "check", "shader", "scenes", "settings", "info"}) {
        EXPECT_NE(all.out.find(command), std::string::npos);
        EXPECT_EQ(gnomon(std::string(command) + " --help").code, 0) << command;
    }
    const std::string help = gnomon("render --help").out;
    for (const auto& row : nlohmann::json::parse(gnomon("settings --json").out)) {
        std::string option = "--" + row.at("key").get<std::string>();
        for (const auto& alias : row.value("aliases", nlohmann::json::array()))
            option += ",--" + alias.get<std::string>();
        EXPECT_NE(help.find(option + " "), std::string::npos) << row;
    }
}

TEST_F(Cli, OpensAWindowWithEitherLibraryAndEndsAfterTheFramesAskedFor) {
    for (const char* window : {"glfw", "sdl"}) {
        const Answer run = gnomon(std::string("lite --frames=2 --size=64x48 --window=") + window, "xvfb-run -a");
        EXPECT_EQ(run.code, 0) << window << "\n" << run.err;
    }
}

TEST_F(Cli, DrawsTheSamePictureFromAWindowsGlAsFromMemory) {
    EXPECT_EQ(gnomon("render lite --size=64x48 -o memory.pfm").code, 0);
    const Answer run = gnomon("render lite --size=64x48 -o window.pfm --context=window", "xvfb-run -a");
    ASSERT_EQ(run.code, 0) << run.err;
    EXPECT_TRUE(readText(folder_ / "memory.pfm") == readText(folder_ / "window.pfm")); // one Mesa behind both
}
