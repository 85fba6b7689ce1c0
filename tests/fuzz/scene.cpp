/// Any bytes as a scene file: read, checked, prepared, planned, packed and turned into shader source for every target.
///
/// What is read is drawn: no plan contradicts itself, no source is missing, the texels of all times are as many.
#include "tests/fuzz/fuzz.h"
#include "tracer/plan/scene_packer.h"
#include "tracer/scene/read_scene.h"
#include "tracer/shader/shader_builder.h"
#include "tracer/software/tuning.h"
#include "tracer/software/uncommon_features.h"

#include <cstdint>

namespace {

using namespace gnomon;

/// Settings that change what is built, chosen by the blanks that the text begins with.
Settings settingsFor(std::string_view text) {
    std::size_t blanks = 0;
    while (blanks < text.size() && (text[blanks] == ' ' || text[blanks] == '\n')) ++blanks;
    Settings settings;
    settings.shadows = ShadowModel(blanks % (int(ShadowModel::Silhouette) + 1));
    settings.accel = Accel(blanks / 11 % 3);
    settings.march = March(blanks / 33 % 4);
    return settings;
}

void build(const PreparedScenePtr& scene, const Settings& settings, Rasteriser rasteriser) {
    Problems problems;
    const Plan plan = splitPlanOf(*scene, settings, tunedFor(rasteriser));
    const std::string contradiction = contradictionIn(plan);
    fuzz::require(contradiction.empty(), contradiction);
    fuzz::require(!buildShader("pass/trace.frag", plan, problems).text.empty() && problems.empty(),
                  "a scene that was read has a shader", problems);
    ScenePacker packer(scene);
    const std::size_t texels = packer.pack(plan, 0, scene->scene.camera.eye).size();
    fuzz::require(packer.pack(plan, 1000, scene->scene.camera.eye).size() == texels, "a scene's texels stay as many");
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    Problems problems;
    const auto scene = readScene(text, "scene.json", problems);
    fuzz::requireTold(!scene, problems);
    if (!scene) return 0;
    const PreparedScenePtr prepared = prepare(*scene);
    for (const Rasteriser rasteriser : {Rasteriser::Gpu, Rasteriser::Llvmpipe})
        build(prepared, settingsFor(text), rasteriser);
    return 0;
}
