#include "lab/bench/benchmark_case.h"

#include "tracer/gl/gl.h"

namespace gnomon {
namespace {

Work workOf(const FloatImage& counts) {
    double sum[3] = {};
    for (std::size_t i = 0; i < counts.pixels.size(); ++i) sum[i % 3] += counts.pixels[i];
    const double pixels = double(counts.width) * counts.height;
    return {sum[0] / pixels, sum[1] / pixels, sum[2] / pixels};
}

} // namespace

BenchmarkCase::BenchmarkCase(const Scene& scene, const NamedImages& images, const Settings& settings,
                             std::span<const ShaderFile> overrides, Problems& problems)
    : renderer_(overrides), settings_(settings) {
    for (const auto& [name, image] : images) renderer_.setImage(name, image);
    renderer_.configure(settings); // before there is a scene, so that no other program is compiled
    if (renderer_.setScene(scene, problems) && renderer_.finish(problems)) program_ = renderer_.stats();
}

double BenchmarkCase::draw(const View& view, double (*clock)()) {
    const double start = clock();
    renderer_.drawAside(view, 1);
    glFinish();
    return clock() - start;
}

std::optional<std::vector<Work>> BenchmarkCase::count(std::span<const View> views, Problems& problems) {
    Settings counting = settings_;
    counting.aov = Aov::Work;
    renderer_.configure(counting);
    if (!renderer_.finish(problems)) return std::nullopt;
    std::vector<Work> works;
    for (const View& view : views) works.push_back(workOf(renderer_.readOutput(view, problems)));
    renderer_.configure(settings_);
    return problems.empty() ? std::optional(works) : std::nullopt;
}

FloatImage BenchmarkCase::read(const Settings& settings, const View& view, Problems& problems) {
    renderer_.configure(settings);
    FloatImage image;
    if (renderer_.finish(problems)) image = renderer_.readOutput(view, problems);
    renderer_.configure(settings_);
    return image;
}

Image BenchmarkCase::picture(const Settings& settings, const View& view, Problems& problems) {
    renderer_.configure(settings);
    Image image;
    if (renderer_.finish(problems)) image = renderer_.readPicture(view, problems);
    renderer_.configure(settings_);
    return image;
}

std::vector<std::vector<double>> timeInRounds(std::span<const TimedCase> cases, int rounds, double (*clock)(),
                                              LabProgress& progress) {
    std::vector<std::vector<double>> times(cases.size());
    for (int round = -1; round < rounds; ++round) { // the first one is not measured
        std::vector<double> seconds(cases.size());
        for (std::size_t i = 0; i < cases.size(); ++i) {
            if (LabProgress::interrupted()) return times;
            const std::size_t next = round % 2 == 0 ? i : cases.size() - 1 - i;
            const TimedCase& timed = cases[next];
            if (timed.settings) timed.benchmarkCase->use(*timed.settings);
            seconds[next] = timed.benchmarkCase->draw(timed.view, clock);
            progress.step();
        }
        for (std::size_t i = 0; i < cases.size() && round >= 0; ++i) times[i].push_back(seconds[i]);
    }
    return times;
}

} // namespace gnomon
