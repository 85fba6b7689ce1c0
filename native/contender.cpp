#include "native/contender.h"

#include "tracer/gl/gl.h"

#include <algorithm>
#include <cmath>

namespace gnomon {
namespace {

Work workOf(const FloatImage& counts) {
    double sum[3] = {};
    for (std::size_t i = 0; i < counts.pixels.size(); ++i) sum[i % 3] += counts.pixels[i];
    const double pixels = double(counts.width) * counts.height;
    return {sum[0] / pixels, sum[1] / pixels, sum[2] / pixels};
}

} // namespace

Contender::Contender(const Scene& scene, const NamedImages& images, const Settings& settings,
                     std::span<const ShaderFile> overrides, Problems& problems)
    : renderer_(overrides), settings_(settings) {
    for (const auto& [name, image] : images) renderer_.setImage(name, image);
    renderer_.configure(settings); // before there is a scene, so that no other program is compiled
    if (renderer_.setScene(scene, problems) && renderer_.finish(problems)) program_ = renderer_.stats();
}

double Contender::draw(const View& view, double (*clock)()) {
    const double start = clock();
    renderer_.drawRows(view, 1, 0, view.height);
    glFinish();
    return clock() - start;
}

std::optional<std::vector<Work>> Contender::count(std::span<const View> views, Problems& problems) {
    Settings counting = settings_;
    counting.aov = Aov::Work;
    renderer_.configure(counting);
    if (!renderer_.finish(problems)) return std::nullopt;
    std::vector<Work> works;
    for (const View& view : views) works.push_back(workOf(renderer_.readOutput(view, problems)));
    renderer_.configure(settings_);
    return problems.empty() ? std::optional(works) : std::nullopt;
}

FloatImage Contender::read(const Settings& settings, const View& view, Problems& problems) {
    renderer_.configure(settings);
    FloatImage image;
    if (renderer_.finish(problems)) image = renderer_.readOutput(view, problems);
    renderer_.configure(settings_);
    return image;
}

Image Contender::picture(const Settings& settings, const View& view, Problems& problems) {
    renderer_.configure(settings);
    Image image;
    if (renderer_.finish(problems)) image = renderer_.readPicture(view, problems);
    renderer_.configure(settings_);
    return image;
}

std::vector<std::vector<double>> race(std::span<const Entrant> entrants, int rounds, double (*clock)(),
                                      LabProgress& progress) {
    std::vector<std::vector<double>> times(entrants.size());
    for (int round = -1; round < rounds; ++round) {
        std::vector<double> seconds(entrants.size());
        for (std::size_t i = 0; i < entrants.size(); ++i) {
            // Forth and back, so that what grows during a round favours nobody.
            const std::size_t turn = round % 2 == 0 ? i : entrants.size() - 1 - i;
            if (entrants[turn].settings) entrants[turn].contender->use(*entrants[turn].settings);
            seconds[turn] = entrants[turn].contender->draw(entrants[turn].view, clock);
            if (!progress.step() && i + 1 < entrants.size()) return times;
        }
        if (round < 0) continue;
        for (std::size_t i = 0; i < entrants.size(); ++i) times[i].push_back(seconds[i]);
    }
    return times;
}

Quartiles quartilesOf(std::vector<double> values) {
    if (values.empty()) return {};
    std::sort(values.begin(), values.end());
    const auto at = [&](double share) {
        const double place = share * double(values.size() - 1);
        const std::size_t below = std::size_t(place), above = std::min(below + 1, values.size() - 1);
        return values[below] + (place - double(below)) * (values[above] - values[below]);
    };
    return {at(0.25), at(0.5), at(0.75)};
}

Quartiles ratioOf(const std::vector<double>& times, const std::vector<double>& base) {
    std::vector<double> ratios;
    for (std::size_t i = 0; i < std::min(times.size(), base.size()); ++i) ratios.push_back(times[i] / base[i]);
    return quartilesOf(std::move(ratios));
}

} // namespace gnomon
