#include "tracer/settings/settings.h"

#include <algorithm>
#include <array>

namespace gnomon {

namespace {

constexpr double kFar = 1e6; ///< limit of coordinates and seconds: beyond, float has less than 1/16 left

/// The names of a choice whose member is an enum that counts them in their order.
template<auto member>
ChoiceType choice(std::vector<std::string_view> names, std::vector<Renamed> renamed = {}) {
    using Enum = std::remove_cvref_t<decltype(std::declval<Settings>().*member)>;
    return {std::move(names), [](const Settings& s) { return int(s.*member); },
            [](Settings& s, int i) { s.*member = Enum(i); }, std::move(renamed)};
}

ChoiceType shadowModels() {
    std::vector<std::string_view> keys;
    for (const ShadowRow& row : kShadowModels) keys.push_back(row.key);
    ChoiceType models = choice<&Settings::shadows>(std::move(keys));
    models.switches = true;
    return models;
}

using S = Settings;

// clang-format off
std::vector<SettingRow> makeTable() {
    const std::vector<std::string_view> modes(colorModes().begin(), colorModes().end());
    return {
        {"depth", IntType{&S::depth, 1, 8}, "Rays",
         "How many surfaces light may meet on its way to the eye",
         Effect::Rebuild, 1, "Right", "Left"},
        {"threshold", RealType{&S::threshold, 0, 1}, "Rays",
         "Rays whose throughput is below this are not followed",
         Effect::Uniform, 1.0 / 512},
        {"shadows", shadowModels(), "Light",
         "Shadow model",
         Effect::Rebuild, 0, "1"},
        {"epsilon", RealType{&S::epsilon, 1.0 / 4096, 0.5}, "Light",
         "Error of the light fraction that shadow cones may make",
         Effect::Uniform, 0.005},
        {"cone-origin", choice<&S::coneOrigin>({"surface", "light"}, {{"a", "surface"}, {"b", "light"}}), "Light",
         "End from which shadow cones are marched",
         Effect::Rebuild, 0, {}, {}, {"direction"}},
        {"shadow-steps", IntType{&S::shadowSteps, 1, 4096}, "Light",
         "Most steps of a march between a surface and a light",
         Effect::Uniform, 1},
        {"samples", IntType{&S::samples, 1, 65536}, "Light",
         "Points of each light that `shadows=montecarlo` and `montecarlo-march` sample",
         Effect::Uniform, 1},
        {"first-sample", IntType{&S::firstSample, 0, 1 << 20}, "Light",
         "Index of the first sample: pictures of consecutive sample batches average to the picture of all samples",
         Effect::Uniform, 1},
        {"light-radius", OptionalRealType{&S::lightRadius, 0, 1e4}, "Light",
         "Radius of all lights; the scene's own if unset",
         Effect::Uniform, 0.05},
        {"march", choice<&S::march>({"steps", "sphere", "cone", "relaxed"}), "Rays",
         "How rays find distance objects: fixed steps, sphere tracing, sphere tracing to the width of the ray cone, "
         "relaxed sphere tracing",
         Effect::Rebuild},
        {"march-steps", IntType{&S::marchSteps, 1, 4096}, "Rays",
         "Most steps of a ray towards a distance object",
         Effect::Uniform, 1},
        {"surface", choice<&S::surface>({"field", "patch"}), "Surfaces",
         "How rays find parametric surfaces: in a baked field of distances, finished on the surface, or without one",
         Effect::Rebuild},
        {"field-method",
         choice<&S::fieldMethod>({"exact", "adamax", "adam", "gradient", "brute", "lipschitz"}), "Surfaces",
         "How the distances of a field are worked out",
         Effect::Bake},
        {"field-resolution", IntType{&S::fieldResolution, 8, 256}, "Surfaces",
         "Samples of a field along each axis",
         Effect::Bake, 8},
        {"field-format", choice<&S::fieldFormat>({"r32f", "r16f"}), "Surfaces",
         "Texels of a field: 32 or 16 bits",
         Effect::Bake},
        {"field-iterations", IntType{&S::fieldIterations, 1, 1000}, "Surfaces",
         "Steps of `field-method=adamax`, `adam` and `gradient` from each start",
         Effect::Bake, 1},
        {"field-rate", RealType{&S::fieldRate, 1e-5, 1}, "Surfaces",
         "Their rate: about how far one step goes, in parameters of the surface",
         Effect::Bake, 0.005},
        {"field-beta1", RealType{&S::fieldBeta1, 0, 0.9999}, "Surfaces",
         "How much of the earlier steps `adamax` and `adam` keep",
         Effect::Bake, 0.01},
        {"field-beta2", RealType{&S::fieldBeta2, 0, 0.9999}, "Surfaces",
         "How slowly they forget how large slopes were",
         Effect::Bake, 0.01},
        {"field-starts", IntType{&S::fieldStarts, 1, 10}, "Surfaces",
         "Starts of the descents: the point below the sample, then a grid of nine",
         Effect::Bake, 1},
        {"field-samples", IntType{&S::fieldSamples, 2, 512}, "Surfaces",
         "Points along u and v that `field-method=brute` takes the nearest of",
         Effect::Bake, 1},
        {"lipschitz", RealType{&S::lipschitz, 0, 1e6}, "Surfaces",
         "What `field-method=lipschitz` divides heights by; 0: the bound that the net of each surface gives",
         Effect::Bake, 0.5},
        {"field-march", choice<&S::fieldMarch>({"sphere", "relaxed", "voxel"}), "Surfaces",
         "How rays go through a field: by sphere tracing, by relaxed sphere tracing, by the exact root in each voxel",
         Effect::Rebuild},
        {"field-steps", IntType{&S::fieldSteps, 1, 4096}, "Surfaces",
         "Most steps of a ray through a field",
         Effect::Uniform, 1},
        {"field-epsilon", RealType{&S::fieldEpsilon, 1e-6, 1}, "Surfaces",
         "How near a sphere trace ends, in voxels",
         Effect::Uniform, 0.001},
        {"field-relaxation", RealType{&S::fieldRelaxation, 1, 2}, "Surfaces",
         "How much farther than the distance `field-march=relaxed` steps",
         Effect::Uniform, 0.05},
        {"glow", BoolType{&S::glow}, "Light",
         "Light in the air around objects that glow",
         Effect::Rebuild, 0, "G"},
        {"normal-maps", BoolType{&S::normalMaps}, "Light",
         "Fine relief from images",
         Effect::Rebuild, 0, "N"},
        {"color-mode", choice<&S::colorMode>(modes), "Picture",
         "Which of red, green and blue each channel of the picture shows",
         Effect::Uniform, 0, "Up", "Down"},
        {"aov", choice<&S::aov>({"color", "distance", "position", "normal", "object", "visibility", "work", "steps"}),
         "Picture",
         "What the pixels hold: the colour, or a value of the surface they see",
         Effect::Rebuild},
        {"light", IntType{&S::light, 0, 15}, "Picture",
         "Index of the light that `aov=visibility` shows, as counted in the scene file",
         Effect::Uniform, 1},
        {"time", RealType{&S::time, -kFar, kFar}, "Motion",
         "Seconds on the scene's clock",
         Effect::Uniform, 0.1},
        {"pause", BoolType{&S::pause}, "Motion",
         "Stops the scene's clock",
         Effect::Uniform, 0, "P"},
        {"eye", OptionalPointType{&S::eye, kFar}, "Camera",
         "Position of the camera; the scene's own if unset"},
        {"target", OptionalPointType{&S::target, kFar}, "Camera",
         "Point that the camera looks at; the scene's own if unset"},
        {"fov", OptionalRealType{&S::fov, 0.001, 170}, "Camera",
         "Vertical angle of view in degrees; the scene's own if unset",
         Effect::Uniform, 1},
        {"speed", RealType{&S::speed, 0.001, 1e4}, "Camera",
         "Units a second that W, A, S and D move; half with Shift",
         Effect::Host, 1},
        {"size", SizeType{&S::size, 1, 16384, 64}, "Canvas",
         "Width and height in pixels",
         Effect::Resize},
        {"scale", RealType{&S::scale, 0.1, 1}, "Canvas",
         "Resolution of the picture over that of the canvas",
         Effect::Host, 0.05},
        {"adapt", BoolType{&S::adapt}, "Canvas",
         "Lowers the resolution while the picture moves and takes too long",
         Effect::Host},
        {"vsync", BoolType{&S::vsync}, "Canvas",
         "Waits for the screen before the next picture (desktop)",
         Effect::Host, 0, "V"},
        {"accel", choice<&S::accel>({"auto", "none", "hierarchy"}), "Canvas",
         "Acceleration structure: auto takes what costs least",
         Effect::Rebuild},
        {"data", choice<&S::data>({"auto", "block", "texture"}), "Canvas",
         "Where the shader reads the scene from: a uniform block or a texture",
         Effect::Rebuild},
        {"variants", choice<&S::variants>({"auto", "on", "off"}), "Canvas",
         "Draws pixels without uncommon features by a smaller shader; auto: on a software rasteriser",
         Effect::Rebuild, 0, {}, {}, {"parts"}},
    };
}
// clang-format on

} // namespace

std::span<const SettingRow> settingsTable() {
    static const std::vector<SettingRow> table = makeTable();
    return table;
}

const SettingRow* findSetting(std::string_view key) {
    for (const auto& row : settingsTable())
        if (row.key == key || std::find(row.aliases.begin(), row.aliases.end(), key) != row.aliases.end()) return &row;
    return nullptr;
}

std::span<const std::string_view> colorModes() {
    static constexpr std::array<std::string_view, 27> names{
        "rrr", "rrg", "rrb", "rgr", "rgg", "rgb", "rbr", "rbg", "rbb", "grr", "grg", "grb", "ggr", "ggg",
        "ggb", "gbr", "gbg", "gbb", "brr", "brg", "brb", "bgr", "bgg", "bgb", "bbr", "bbg", "bbb"};
    return names;
}

int channelsOf(Aov aov) {
    return aov == Aov::Color || aov == Aov::Position || aov == Aov::Normal || aov == Aov::Work ? 3 : 1;
}

} // namespace gnomon
