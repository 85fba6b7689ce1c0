#include "tracer/render/scene_fields.h"

#include "tracer/clock.h"
#include "tracer/plan/plan.h"

#include <algorithm>

namespace gnomon {
namespace {

constexpr double kMostTexels = 1 << 25; ///< 128 MiB of float32, twice while others are baked
constexpr int kCoarse = 16;             ///< samples along an axis: a few milliseconds
constexpr double kStepSeconds = 0.02;   ///< that a step is to take

FieldBake bakeOf(const Shape& shape, const Settings& settings, int samples) {
    FieldBake bake;
    const glm::dvec3 size = pointOf(shape, "size");
    bake.heights = *shape.heights;
    bake.size = size;
    bake.resolution = samples;
    bake.format = settings.fieldFormat == FieldFormat::R16f ? GL_R16F : GL_R32F;
    bake.method = BakeMethod(settings.fieldMethod);
    bake.iterations = settings.fieldIterations;
    bake.starts = settings.fieldStarts;
    bake.samples = settings.fieldSamples;
    bake.rate = settings.fieldRate;
    bake.beta1 = settings.fieldBeta1;
    bake.beta2 = settings.fieldBeta2;
    bake.lipschitz = settings.lipschitz;
    return bake;
}

} // namespace

void SceneFields::want(const Settings& settings, const gl::Info& info, Problems& problems) {
    if (wanted_ && bakesAlike(*wanted_, settings) && (current_ || !stages_.empty())) return;
    wanted_ = settings;
    const auto layoutOf = [&](int samples) {
        return fieldLayoutOf(prepared_->scene, samples, info.maxVolumeSize, kMostTexels);
    };
    const FieldLayout layout = layoutOf(settings.fieldResolution);
    if (layout.samples < settings.fieldResolution)
        problems.push_back({prepared_->scene.file, 0, {},
                            std::to_string(layout.slots.size()) + " fields of " +
                                std::to_string(settings.fieldResolution) + " samples a side are too much: they have " +
                                std::to_string(layout.samples),
                            "use --field-resolution=" + std::to_string(layout.samples) + " or fewer surfaces"});
    stages_ = {{layout, settings}};
    if (!current_ && layout.samples > kCoarse) {
        stages_.push_back({layoutOf(kCoarse), settings});
        stages_.back().settings.fieldMethod = FieldMethod::Exact; // others may take long at any resolution
    }
    began_ = failed_ = false;
}

std::optional<FieldLayout> SceneFields::step(ProgramCache& cache, const CodegenTarget& target, Problems& problems) {
    if (stages_.empty() || failed_) return {};
    if (drawn_.isSet()) {
        if (!drawn_.passed()) return {};
        const double took = std::max(monotonicSeconds() - asked_, 1e-6);
        slices_ = std::clamp(int(slices_ * kStepSeconds / took), 1, 2 * slices_);
    }
    const Stage& stage = stages_.back();
    const GLenum format = stage.settings.fieldFormat == FieldFormat::R16f ? GL_R16F : GL_R32F;
    if (!began_ || !next_) {
        next_ = gl::makeVolume(stage.layout.size, format, target.floatFilter);
        slot_ = 0;
        slices_ = 1;
        failed_ = !next_ || !beginSlot(target, problems);
        if (failed_) return {};
    }
    const FieldSlot& slot = stage.layout.slots[slot_];
    asked_ = monotonicSeconds();
    failed_ = !pass_.step(cache, next_, slot.at, slices_, problems);
    if (failed_) return {};
    drawn_.set();
    if (pass_.done() < 1) return {};
    if (++slot_ < stage.layout.slots.size()) {
        failed_ = !beginSlot(target, problems);
        return {};
    }
    current_ = std::move(next_);
    next_ = {};
    began_ = false;
    FieldLayout layout = stage.layout;
    stages_.pop_back();
    return layout;
}

bool SceneFields::beginSlot(const CodegenTarget& target, Problems& problems) {
    const Stage& stage = stages_.back();
    const FieldSlot& slot = stage.layout.slots[slot_];
    const Shape& shape = prepared_->scene.objects[std::size_t(slot.object)].shape;
    FieldBake bake = bakeOf(shape, stage.settings, stage.layout.samples);
    bake.box = {-0.5 * slot.size, 0.5 * slot.size};
    began_ = pass_.begin(bake, target, problems);
    return began_;
}

double SceneFields::baked() const {
    if (stages_.empty()) return 1;
    if (!began_) return 0;
    return (double(slot_) + pass_.done()) / double(stages_.back().layout.slots.size()) / double(stages_.size());
}

void SceneFields::bind() const {
    glActiveTexture(GL_TEXTURE0 + kFieldUnit);
    glBindTexture(GL_TEXTURE_3D, current_.texture.get());
    glActiveTexture(GL_TEXTURE0 + kDataUnit);
}

} // namespace gnomon
