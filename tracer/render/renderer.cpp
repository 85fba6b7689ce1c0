#include "tracer/render/renderer.h"

#include "tracer/clock.h"
#include "tracer/plan/scene_offsets.h"
#include "tracer/render/depth_cut.h"
#include "tracer/render/pass/full_screen_passes.h"
#include "tracer/render/pass/full_screen_table.h"
#include "tracer/render/read_output.h"
#include "tracer/software/tuning.h"
#include "tracer/software/uncommon_features.h"

#include <algorithm>
#include <chrono>
#include <thread>
#include <utility>

namespace gnomon {
namespace {

constexpr GLenum kProgramPointSize = 0x8642; // GL_PROGRAM_POINT_SIZE: always on in GLES
constexpr GLenum kSeamlessCubemap = 0x884F;  // GL_TEXTURE_CUBE_MAP_SEAMLESS: always on in GLES, unknown to its header

/// What a context keeps from one pass to the next.
void setState(const gl::Info& info) {
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_BLEND);
    if (info.es) return;
    glEnable(kSeamlessCubemap);
    glEnable(kProgramPointSize);
}

/// Whether this GL can hold the scene.
bool fits(const PreparedScene& prepared, const Settings& settings, const gl::Info& info, Problems& problems) {
    const std::size_t before = problems.size();
    const auto refuse = [&](const std::string& what, const std::string& remedy) {
        problems.push_back({prepared.scene.file, 0, {}, what, remedy});
    };
    const int texels = sceneTexels(planOf(prepared, settings, targetOf(info)).scene);
    const long most = long(kDataWidth) * info.maxTextureSize;
    if (texels > most)
        refuse("the scene takes " + std::to_string(texels) + " texels, this GL holds " + std::to_string(most),
               "use fewer objects");
    const TextureSet& textureSet = prepared.textureSet;
    const int layers = int(std::max(textureSet.paints.size(), textureSet.normals.size()));
    const int mostLayers = std::min(kMostLayers, info.maxLayers);
    if (layers > mostLayers)
        refuse("the scene shows " + std::to_string(layers) + " images, this GL holds " + std::to_string(mostLayers),
               "use fewer images");
    return problems.size() == before;
}

/// Where shadows are not drawn as the settings say, since a light is at no distance.
void tellOfDirectionalLight(const PreparedScene& prepared, const Plan& plan, const Settings& settings,
                            Problems& problems) {
    const auto tell = [&](const std::string& what, const std::string& remedy) {
        problems.push_back({prepared.scene.file, 0, {}, what, remedy});
    };
    if (!plan.scene.directional) return;
    const ShadowRow& wanted = shadowRow(settings.shadows);
    std::string others;
    for (const ShadowRow& row : kShadowModels)
        if (row.parallel) others += (others.empty() ? "" : ", ") + std::string(row.key);
    if (!wanted.parallel)
        tell("the scene has a directional light, which --shadows=" + std::string(wanted.key) +
                 " does not take: its shadows are hard",
             "use one of: " + others);
    if (wanted.cones && settings.coneOrigin == ConeOrigin::Light)
        tell("the scene has a directional light, from which no shadow cone can start: they start at the surface",
             "use --cone-origin=surface");
}

/// Where surfaces have no distance that the settings ask for.
void tellOfFields(const PreparedScene& prepared, const Plan& plan, const Settings& settings, Problems& problems) {
    const auto tell = [&](const std::string& what, const std::string& remedy) {
        problems.push_back({prepared.scene.file, 0, {}, what, remedy});
    };
    const std::vector<Object>& objects = prepared.scene.objects;
    const bool nets = std::any_of(objects.begin(), objects.end(), [](const Object& o) { return bool(o.shape.net); });
    const ShadowRow& wanted = shadowRow(settings.shadows);
    const bool hard = wanted.distances && plan.scene.shadows == ShadowModel::Hard;
    if (nets && hard)
        tell("the scene has patches in space, of which no distance is known that --shadows=" + std::string(wanted.key) +
                 " asks for: its shadows are hard",
             "use --shadows=silhouette or montecarlo");
    const bool field = settings.surface == SurfaceMode::Field && !plan.scene.surfaceInField;
    if (!plan.target.floatTargets && hasSurfaces(prepared.scene) && (field || hard))
        tell("this GL cannot bake fields of distances, since it draws no float32: surfaces are met without them" +
                 std::string(hard ? ", and shadows are hard" : ""),
             "use another GL");
}

/// How to draw for the settings. A problem where scene data does not lie where the settings want it.
Plan planFor(const PreparedScene& prepared, const Settings& settings, const gl::Info& info, bool overridden,
             Problems& problems) {
    Plan plan = splitPlanOf(prepared, settings, targetOf(info));
    if (overridden) plan.split = {}; // variants are of the library's own files
    tellOfDirectionalLight(prepared, plan, settings, problems);
    tellOfFields(prepared, plan, settings, problems);
    const int texels = sceneTexels(plan.scene), room = plan.target.blockTexels;
    if (plan.scene.dataBlock && texels > room) {
        plan.scene.dataBlock = false;
        problems.push_back({prepared.scene.file,
                            0,
                            {},
                            "the scene takes " + std::to_string(texels) + " texels, a uniform block of this GL holds " +
                                std::to_string(room) + ": its values go into a texture",
                            {}});
    }
    return plan;
}

/// Both go through the same full-screen passes.
bool passesAlike(const Settings& a, const Settings& b) {
    return std::all_of(kFullScreenTable.begin(), kFullScreenTable.end(),
                       [&](const FullScreenRow& row) { return row.wanted(a) == row.wanted(b); });
}

} // namespace

struct Renderer::Impl {
    gl::Info info = gl::info();
    Settings settings;
    ProgramCache programs;
    Frame frame;
    TracePass warm, coarse, fine;
    FullScreenPasses fullScreen;
    OutputReader reader;
    DepthProbe depthProbe;
    unsigned version = 0, fineVersion = 0;

    Drawing wanted, drawn;
    bool adopted = false; ///< the wanted one draws

    gl::Fence drawing;
    double asked = 0, drawSeconds = 0;

    explicit Impl(std::span<const ShaderFile> overrides) : programs(info.parallelCompile, overrides) { setState(info); }

    // --- programs ---------------------------------------------------------------------------------------------------

    void choose() {
        if (!wanted.scene) return;
        Problems& problems = frame.problems;
        const Plan plan = planFor(wanted.scene->prepared(), settings, info, programs.overridden(), problems);
        wanted.settings = settings;
        wanted.trace = VariantPrograms(plan, programs, problems);
        wanted.fullScreen.clear();
        for (const FullScreenRow& row : kFullScreenTable)
            if (row.wanted(settings)) wanted.fullScreen.push_back(programs.get(plan, problems, row.shader));
        adopted = false;
        if (plan.scene.fields) wanted.scene->fields().want(settings, info, problems);
        adopt();
    }

    /// From here on the wanted programs draw, once they can.
    void adopt() {
        if (!wanted.canDraw()) return;
        if (!adopted) ++version; // its variants draw the same
        adopted = true;
        drawn = wanted;
    }

    Progress poll(Problems& problems) {
        Progress progress{.wanted = bool(wanted.scene)};
        if (!wanted.scene) return progress;
        progress.images = wanted.scene->images().fraction(frame.pictures);
        progress.failed =
            !wanted.trace.began() || std::count(wanted.fullScreen.begin(), wanted.fullScreen.end(), nullptr) > 0;
        if (!wanted) return progress;
        const double fullScreenReady = pollFullScreen(progress, problems);
        const CompileState traced = wanted.trace.poll(
            programs, [this](const CachedProgram& program) { warm.warmUp(wanted, program, frame); }, problems);
        if (!adopted || drawn.trace.split() != wanted.trace.split()) adopt();
        progress.failed |= traced == CompileState::Failed;
        progress.compiled = 0.5 * (wanted.trace.compiled() + fullScreenReady);
        bake(progress, problems);
        return progress;
    }

    void bake(Progress& progress, Problems& problems) {
        const Plan& plan = wanted.trace.plan();
        if (!plan.scene.fields) return;
        if (wanted.scene->bake(programs, plan.target, problems)) {
            ++version;
            if (!adopted) adopt();
        }
        progress.baked = wanted.scene->fields().baked();
        progress.failed |= wanted.scene->fields().failed();
    }

    /// Fraction of the full-screen passes that are ready.
    double pollFullScreen(Progress& progress, Problems& problems) {
        int ready = 0;
        for (const auto& pass : wanted.fullScreen) {
            const CompileState state = programs.poll(
                *pass, [&] { fullScreen.warmUp(*pass, wanted, warmed(), frame); }, problems);
            ready += state == CompileState::Ready;
            progress.failed |= state == CompileState::Failed;
        }
        return double(ready) / double(wanted.fullScreen.size());
    }

    /// A linear picture of one pixel.
    const TracePass& warmed() {
        warm.begin(wanted, {wanted.scene->prepared().scene.camera, 0, 1, 1});
        return warm;
    }

    // --- drawing ----------------------------------------------------------------------------------------------------

    void step(TracePass& pass, int rows) {
        asked = monotonicSeconds();
        pass.step(drawn, drawn.settings, frame, {rows});
    }

    /// All of the picture, at once.
    bool trace(const View& view, double scale) {
        if (!drawn.canDraw() || view.width <= 0 || view.height <= 0) return false;
        const View coarseView = scaled(view, scale);
        if (!coarse.begin(drawn, coarseView)) return false;
        step(coarse, coarseView.height);
        return true;
    }

    bool busy() {
        if (!drawing.isSet()) return false;
        if (!drawing.passed()) return true;
        drawSeconds = monotonicSeconds() - asked;
        return false;
    }
};

Renderer::Renderer(std::span<const ShaderFile> overrides) : impl_(std::make_unique<Impl>(overrides)) {}
Renderer::~Renderer() = default;

bool Renderer::setScene(const Scene& scene, Problems& problems) {
    const PreparedScenePtr prepared = prepare(scene);
    if (!fits(*prepared, impl_->settings, impl_->info, problems)) return false;
    impl_->wanted.scene = std::make_shared<GpuScene>(prepared, impl_->info.maxTextureSize);
    impl_->choose();
    return true;
}

void Renderer::setImage(const std::string& name, Image image) {
    impl_->frame.pictures.images[name] = std::move(image);
    ++impl_->version;
    for (const auto& scene : {impl_->wanted.scene, impl_->drawn.scene})
        if (scene) scene->images().arrived(name);
}

void Renderer::useImagesOnce() { impl_->frame.pictures.once = true; }

void Renderer::configure(const Settings& settings) {
    const bool alike = planAlike(impl_->settings, settings) && bakesAlike(impl_->settings, settings) &&
                       passesAlike(impl_->settings, settings);
    impl_->settings = impl_->wanted.settings = settings;
    ++impl_->version;
    if (!alike || !impl_->wanted) impl_->choose();
    impl_->drawn.settings = settings; // what is only a number acts at once, also while a new program compiles
}

void Renderer::replaceShaders(std::span<const ShaderFile> overrides) {
    impl_->programs.setOverrides(overrides);
    impl_->choose();
}

Progress Renderer::poll(Problems& problems) {
    const auto tell = [&] {
        problems.insert(problems.end(), impl_->frame.problems.begin(), impl_->frame.problems.end());
        impl_->frame.problems.clear();
    };
    tell();
    const Progress progress = impl_->poll(problems);
    tell(); // of its images
    return progress;
}

bool Renderer::finish(Problems& problems) {
    Progress progress = poll(problems);
    while (progress.compiling()) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
        progress = poll(problems);
    }
    return progress.ready();
}

bool Renderer::canDraw() const { return impl_->drawn.canDraw(); }

void Renderer::draw(const View& view, double scale, unsigned framebuffer) {
    Impl& i = *impl_;
    if (!i.trace(view, scale)) return;
    i.fullScreen.show(i.drawn, i.coarse, i.coarse.rows(), i.frame, view, framebuffer);
    i.drawing.set();
}

void Renderer::drawAside(const View& view, double scale) {
    Impl& i = *impl_;
    if (!i.trace(view, scale)) return;
    i.fullScreen.drawAside(i.drawn, i.coarse, i.frame);
    i.drawing.set();
}

void Renderer::refine(const View& view, double scale, int rows) {
    Impl& i = *impl_;
    if (!canDraw()) return;
    const View fine = scaled(view, scale);
    if (i.fineVersion != i.version || !(i.fine.view() == fine) || !i.fine.picture()) {
        if (!i.fine.begin(i.drawn, fine)) return;
        i.fineVersion = i.version;
    }
    i.step(i.fine, rows);
    i.drawing.set();
}

double Renderer::refined() const { return impl_->fineVersion == impl_->version ? impl_->fine.done() : 0; }

void Renderer::show(const View& view, unsigned framebuffer) {
    Impl& i = *impl_;
    if (!canDraw()) return;
    const int rows = i.fine.rows(), height = i.fine.view().height;
    if (i.coarse.picture() && rows < height)
        i.fullScreen.show(i.drawn, i.coarse, i.coarse.view().height, i.frame, view, framebuffer);
    // An edge that is stretched takes in something of the row above it, which is not drawn yet.
    const int ready = rows < height ? rows - 1 : rows;
    if (i.fine.picture() && ready > 0) i.fullScreen.show(i.drawn, i.fine, ready, i.frame, view, framebuffer);
}

bool Renderer::busy() { return impl_->busy(); }
double Renderer::drawSeconds() const { return impl_->drawSeconds; }
unsigned Renderer::version() const { return impl_->version; }

FloatImage Renderer::readOutput(const View& view, Problems& problems) {
    return canDraw() ? impl_->reader.values(impl_->drawn, view, impl_->frame, impl_->info, problems) : FloatImage{};
}

Image Renderer::readPicture(const View& view, Problems& problems) {
    return canDraw() ? impl_->reader.shown(impl_->drawn, view, impl_->frame, impl_->info, problems) : Image{};
}

std::string Renderer::depthCut(const View& view) {
    return canDraw() ? messageOf(impl_->depthProbe.measure(impl_->drawn, view, impl_->frame)) : std::string{};
}

ProgramStats Renderer::stats() const { return impl_->drawn.trace.stats(); }

const std::string& Renderer::source() const {
    static const std::string none;
    return impl_->drawn ? impl_->drawn.trace.full().source.text : none;
}

void Renderer::contextRestored() {
    impl_->info = gl::info(); // extensions must be asked for anew
    setState(impl_->info);
    impl_->frame.block = {};
    impl_->choose();
}

} // namespace gnomon
