#include "lab/shadows/shadow_lab.h"

#include "lab/results/result_pictures.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace gnomon {
namespace {

/// Ways that share a program: only numbers differ.
using Program = std::pair<ShadowModel, ConeOrigin>;

/// The benchmark cases of one scene: one for each program.
class SceneCases {
  public:
    SceneCases(const Loaded& loaded, const ShadowPlan& plan, Problems& problems)
        : loaded_(loaded), plan_(plan),
          problems_(problems), view_{plan.camera.value_or(loaded.scene.camera), 0, plan.size.x, plan.size.y} {}

    BenchmarkCase* benchmarkCase(const ShadowWay& way) {
        auto& found = cases_[{way.model, way.coneOrigin}];
        if (!found)
            found = std::make_unique<BenchmarkCase>(loaded_.scene, loaded_.images, settingsFor(plan_, way, {}),
                                                    std::span<const ShaderFile>{}, problems_);
        return found.get();
    }

    FloatImage output(const ShadowWay& way, double radius, Aov aov) {
        Settings settings = settingsFor(plan_, way, radius);
        settings.aov = aov;
        return benchmarkCase(way)->read(settings, view_, problems_);
    }

    /// Empty where the plan wants none.
    Image pictureOf(const FloatImage& colors) const {
        if (!plan_.pictures || !problems_.empty()) return {};
        return shown(colors, *plan_.pictures, loaded_.scene.encoding == Encoding::Linear);
    }

    const View& view() const { return view_; }

  private:
    const Loaded& loaded_;
    const ShadowPlan& plan_;
    Problems& problems_;
    View view_;
    std::map<Program, std::unique_ptr<BenchmarkCase>> cases_;
};

double meanOf(const FloatImage& image, int channel) {
    double sum = 0;
    for (std::size_t i = std::size_t(channel); i < image.pixels.size(); i += std::size_t(image.channels))
        sum += image.pixels[i];
    return sum * image.channels / double(image.pixels.size());
}

/// Over all channels of the pixels that see a surface.
std::vector<double> differences(const FloatImage& a, const FloatImage& b, const FloatImage& objects) {
    std::vector<double> all;
    for (std::size_t i = 0; i < a.pixels.size(); ++i)
        if (objects.pixels[i / std::size_t(a.channels)] >= 0) all.push_back(double(a.pixels[i]) - b.pixels[i]);
    return all;
}

void markFront(ShadowCosts& costs) {
    const auto time = [](const ShadowCost& cost) { return quartilesOf(cost.seconds).median; };
    for (ShadowCost& cost : costs.ways)
        cost.front = std::none_of(costs.ways.begin(), costs.ways.end(), [&](const ShadowCost& other) {
            return time(other) < time(cost) && other.visibility.rmse <= cost.visibility.rmse;
        });
}

/// What is read back of each way, beside the reference. False where that ended early: ways that were not read are left
/// out.
bool readBack(SceneCases& cases, const ShadowPlan& plan, ShadowCosts& costs, LabProgress& progress,
              Problems& problems) {
    const ShadowWay off{ShadowModel::Off}, exact{ShadowModel::Montecarlo, ConeOrigin::Surface, 0.1, plan.reference};
    const FloatImage objects = cases.output(off, costs.radius, Aov::Object);
    const FloatImage fractions = cases.output(exact, costs.radius, Aov::Visibility);
    const FloatImage picture = cases.output(exact, costs.radius, Aov::Color);
    if (!problems.empty()) return false;
    costs.reference = cases.pictureOf(picture);
    const double bare = meanOf(cases.output(off, costs.radius, Aov::Steps), 0);
    if (!progress.step()) {
        costs.ways.clear();
        return false;
    }
    for (auto next = costs.ways.begin(); next != costs.ways.end();) {
        ShadowCost& cost = *next++;
        const auto output = [&](Aov aov) { return cases.output(cost.way, costs.radius, aov); };
        cost.visibility = errorsOf(differences(output(Aov::Visibility), fractions, objects));
        const FloatImage colors = output(Aov::Color);
        cost.picture = errorsOf(differences(colors, picture, objects));
        cost.image = cases.pictureOf(colors);
        cost.evaluations = meanOf(output(Aov::Steps), 0) - bare;
        if (shadowRow(cost.way.model).rays) cost.shadowRays = meanOf(output(Aov::Work), 2);
        if (!problems.empty()) return false;
        if (progress.step()) continue;
        costs.ways.erase(next, costs.ways.end());
        return false;
    }
    return true;
}

bool raceAll(SceneCases& cases, const ShadowPlan& plan, ShadowCosts& costs, double (*clock)(), LabProgress& progress,
             Problems& problems) {
    std::vector<Settings> settings{settingsFor(plan, {ShadowModel::Off}, costs.radius)};
    std::vector<TimedCase> timed{{cases.benchmarkCase({ShadowModel::Off}), cases.view(), nullptr}};
    for (const ShadowCost& cost : costs.ways) {
        settings.push_back(settingsFor(plan, cost.way, costs.radius));
        timed.push_back({cases.benchmarkCase(cost.way), cases.view(), nullptr});
    }
    if (!problems.empty()) return false;
    for (std::size_t i = 0; i < timed.size(); ++i) timed[i].settings = &settings[i];
    const auto times = timeInRounds(timed, plan.rounds, clock, progress);
    costs.bare = times[0];
    for (std::size_t i = 0; i < costs.ways.size(); ++i) costs.ways[i].seconds = times[i + 1];
    return true;
}

} // namespace

Settings settingsFor(const ShadowPlan& plan, const ShadowWay& way, std::optional<double> radius) {
    Settings settings;
    settings.size = plan.size;
    settings.depth = 1; // what reflections show would count shadows twice
    settings.shadows = way.model;
    settings.coneOrigin = way.coneOrigin;
    settings.epsilon = way.epsilon;
    settings.samples = way.samples;
    settings.shadowSteps = 1024;
    settings.lightRadius = radius;
    return settings;
}

bool marchesCones(ShadowModel model) { return shadowRow(model).cones; }
bool takesSamples(ShadowModel model) { return shadowRow(model).batch > 0; }

Errors errorsOf(std::vector<double> differences) {
    if (differences.empty()) return {};
    Errors errors;
    double squares = 0;
    for (double& d : differences) {
        errors.mean += d;
        squares += d * d;
        d = std::abs(d);
    }
    std::sort(differences.begin(), differences.end());
    errors.mean /= double(differences.size());
    errors.rmse = std::sqrt(squares / double(differences.size()));
    errors.most999 = differences[std::size_t(0.999 * double(differences.size() - 1))];
    errors.most = differences.back();
    return errors;
}

std::vector<ShadowWay> waysOf(const ShadowPlan& plan) {
    std::vector<ShadowWay> ways;
    for (const ShadowModel model : plan.models) {
        if (takesSamples(model)) {
            for (const int samples : plan.samples) ways.push_back({model, ConeOrigin::Surface, 1.0 / 30, samples});
        } else if (marchesCones(model)) {
            for (const double epsilon : plan.epsilons)
                for (const ConeOrigin coneOrigin : {ConeOrigin::Surface, ConeOrigin::Light})
                    if (coneOrigin == ConeOrigin::Surface || plan.bothOrigins)
                        ways.push_back({model, coneOrigin, epsilon});
        } else {
            ways.push_back({model});
        }
    }
    return ways;
}

std::size_t stepsOf(const ShadowPlan& plan) {
    const std::size_t ways = waysOf(plan).size();
    return std::max<std::size_t>(plan.radii.size(), 1) * ((ways + 1) * std::size_t(plan.rounds + 1) + ways + 1);
}

std::size_t picturesOf(const ShadowPlan& plan) {
    return std::max<std::size_t>(plan.radii.size(), 1) * (waysOf(plan).size() + 1);
}

std::vector<ShadowCosts> measureShadows(const Loaded& loaded, const ShadowPlan& plan, double (*clock)(),
                                        LabProgress& progress, Problems& problems) {
    std::vector<ShadowCosts> all;
    if (loaded.scene.lights.empty()) {
        problems.push_back({loaded.scene.file, 0, {}, "there is no light in this scene", "take one that has lights"});
        return all;
    }
    SceneCases cases(loaded, plan, problems);
    std::vector<double> radii = plan.radii;
    if (radii.empty()) radii = {loaded.scene.lights[0].radius};
    for (const double radius : radii) {
        ShadowCosts costs{loaded.scene.name, radius, {}, {}, {}};
        for (const ShadowWay& way : waysOf(plan)) costs.ways.push_back({way, {}, 0, {}, {}, {}, false, {}});
        const bool timed = readBack(cases, plan, costs, progress, problems) &&
                           raceAll(cases, plan, costs, clock, progress, problems) && !costs.bare.empty();
        if (!problems.empty() || costs.ways.empty()) break;
        if (timed) markFront(costs);
        all.push_back(std::move(costs)); // what was read back is kept, also without times
        if (!timed) break;
    }
    return all;
}

} // namespace gnomon
