#include "tracer/render/renderer.h"

#include "tracer/clock.h"
#include "tracer/gl/objects.h"
#include "tracer/render/programs.h"
#include "tracer/plan/scene_offsets.h"
#include "tracer/plan/scene_packer.h"
#include "tracer/software/uncommon_features.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <thread>

namespace gnomon {
namespace {

constexpr int kDataWidth = 2048;             // texels a row of the data texture, as shaders/scene.glsl reads it
constexpr GLenum kProgramPointSize = 0x8642; // GL_PROGRAM_POINT_SIZE: always on in GLES
constexpr GLenum kSeamlessCubemap = 0x884F;  // GL_TEXTURE_CUBE_MAP_SEAMLESS: always on in GLES, unknown to its header

/// shaders/frame.glsl, in std140.
struct FrameBlock {
    glm::vec4 eye, right, up, forward, origin, background, cone, options, canvas;
    glm::ivec4 limits, budget, channels;
    glm::uvec4 zero;
};

/// `origin` is what the shader's coordinates are relative to.
FrameBlock frameBlock(const View& view, const Scene& scene, glm::dvec3 origin, const Settings& settings, bool encode) {
    const CameraFrame camera = frameOf(view.camera);
    const double aspect = double(view.width) / view.height;
    const std::string_view channels = colorModes()[std::size_t(settings.colorMode)];
    const auto channel = [&](std::size_t i) { return int(std::string_view("rgb").find(channels[i])); };
    FrameBlock block{};
    block.eye = glm::vec4(camera.eye - origin, 0);
    block.right = glm::vec4(camera.right * camera.halfHeight * aspect, 0);
    block.up = glm::vec4(camera.up * camera.halfHeight, 0);
    block.forward = glm::vec4(camera.forward, 0);
    block.origin = glm::vec4(origin, 0);
    block.background = glm::vec4(scene.background.color, 1);
    block.cone.x = float(2 * camera.halfHeight / view.height);
    block.options = glm::vec4(settings.threshold, settings.epsilon, settings.lightRadius.value_or(-1), 0);
    block.budget = glm::ivec4(settings.shadowSteps, settings.samples, settings.marchSteps, settings.firstSample);
    block.canvas = glm::vec4(view.width, view.height, 0, 0);
    block.limits = glm::ivec4(settings.depth, settings.light, encode, 0);
    block.channels = glm::ivec4(channel(0), channel(1), channel(2), 0);
    return block;
}

Image flat(std::uint8_t r, std::uint8_t g, std::uint8_t b) { return {1, 1, {r, g, b, 255}}; }

/// Of the finest levels of all images of a purpose; docs/scenes.md tells it.
constexpr std::size_t kMostImageBytes = std::size_t(1) << 29;

/// Samples of a light that one draw takes where its picture is read back: llvmpipe ends all loops of a pixel after
/// 65 536 turns in all, and other drivers take a long draw for one that hangs.
int batchOf(const Settings& settings) { return shadowRow(settings.shadows).batch; }

bool inBatches(const Settings& settings) {
    return batchOf(settings) > 0 && settings.samples > batchOf(settings) &&
           (settings.aov == Aov::Color || settings.aov == Aov::Visibility);
}

std::uint8_t encoded(float light, bool linear) {
    const float c = std::clamp(light, 0.0f, 1.0f); // the curve: shaders/shade/encode.glsl
    const float curve = c <= 0.0031308f ? 12.92f * c : 1.055f * std::pow(c, 1 / 2.4f) - 0.055f;
    return std::uint8_t(std::lround(255 * (linear ? curve : c)));
}

/// The picture of such numbers, as the shader would have encoded it.
Image pictureOf(const FloatImage& numbers, bool linear) {
    Image image{numbers.width, numbers.height, {}};
    const std::size_t channels = std::size_t(numbers.channels);
    for (std::size_t at = 0; at + channels <= numbers.pixels.size(); at += channels) {
        for (std::size_t c = 0; c < 3; ++c)
            image.rgba.push_back(encoded(numbers.pixels[at + std::min(c, channels - 1)], linear && channels == 3));
        image.rgba.push_back(255);
    }
    return image;
}

/// The same view with fewer pixels.
View scaled(View view, double scale) {
    view.width = std::max(1, int(std::lround(view.width * scale)));
    view.height = std::max(1, int(std::lround(view.height * scale)));
    return view;
}

/// A scene with its images on the GPU. Scenes that follow one another do not share textures: the old one draws on until
/// the new one's program is ready.
struct LoadedScene {
    PreparedScenePtr prepared;
    ScenePacker packer;
    gl::Texture paints, normals, sky;
    bool stale = true; ///< images have come that the textures do not have
};

} // namespace

struct Renderer::Impl {
    gl::Info info = gl::info();
    std::map<std::string, Image> pictures; // kept, so that a lost context can be filled again
    Settings settings;
    ProgramCache programs;
    gl::VertexArray vertexArray;
    gl::Buffer frameBuffer, sceneBuffer;
    gl::Texture sceneTexture;
    int sceneRows = 0;
    gl::Target picture, aside, output, warm;
    gl::Fence drawing;
    double asked = 0, drawSeconds = 0;
    unsigned version = 0;

    std::shared_ptr<LoadedScene> wantedScene, drawnScene;
    Programs wanted, drawn;
    bool adopted = false; ///< the wanted programs draw
    Settings drawnSettings;
    Problems pending; // found while choosing a program, told by the next poll()

    explicit Impl(std::span<const ShaderFile> overrides) : programs(info.parallelCompile, overrides) { makeObjects(); }

    void makeObjects() {
        vertexArray = gl::makeVertexArray();
        frameBuffer = gl::makeUniformBuffer();
        sceneBuffer = gl::makeUniformBuffer();
        glBindVertexArray(vertexArray.get());
        glDisable(GL_DEPTH_TEST);
        glDisable(GL_BLEND);
        if (!info.es) {
            glEnable(kSeamlessCubemap);
            glEnable(kProgramPointSize);
        }
        warm = gl::makeTarget(1, 1, GL_RGBA8, true);
    }

    // --- images -----------------------------------------------------------------------------------------------------

    gl::Texels coding(const Scene& scene, bool color) const {
        return scene.encoding == Encoding::Linear && color ? gl::Texels::Srgb : gl::Texels::Display;
    }

    /// As it came; `standIn` until it does.
    const Image& pictureOr(const Image& standIn, const std::string& name) const {
        const auto found = pictures.find(name);
        return found == pictures.end() ? standIn : found->second;
    }

    gl::Texture upload(const LoadedScene& loaded, std::vector<Image> images, bool color,
                       std::vector<glm::vec2>& tiles) {
        if (images.empty()) return {};
        const gl::Texels texels = coding(loaded.prepared->scene, color);
        const Layers layers(std::move(images), texels == gl::Texels::Srgb, info.maxTextureSize, kMostImageBytes);
        for (int i = 0; i < layers.count(); ++i) tiles.push_back(layers.tile(i));
        if (layers.reduced())
            pending.push_back(
                {loaded.prepared->scene.file,
                 0,
                 {},
                 "the images take more than 512 MB, or are larger than this GL takes them: the largest are "
                 "drawn smaller",
                 "use fewer or smaller images"});
        return gl::makeImages(layers, texels);
    }

    void uploadImages(LoadedScene& loaded) {
        const Image none, grey = flat(128, 128, 128), level = flat(128, 128, 255), dry = flat(0, 0, 0);
        std::vector<Image> paints, normals;
        for (const Paint& paint : loaded.prepared->textureSet.paints)
            paints.push_back(painted(paint.color.empty() ? none : pictureOr(grey, paint.color),
                                     paint.mask.empty() ? none : pictureOr(dry, paint.mask)));
        for (const std::string& name : loaded.prepared->textureSet.normals) normals.push_back(pictureOr(level, name));
        Tiles tiles;
        loaded.paints = upload(loaded, std::move(paints), true, tiles.paints);
        loaded.normals = upload(loaded, std::move(normals), false, tiles.normals);
        loaded.packer.setTiles(std::move(tiles));
        loaded.stale = false;
    }

    void uploadSky(LoadedScene& loaded) {
        std::vector<Image> faces;
        for (const std::string& name : loaded.prepared->skyFaces)
            if (const auto found = pictures.find(name); found != pictures.end()) faces.push_back(found->second);
        const bool complete = faces.size() == 6 && std::all_of(faces.begin(), faces.end(), [&](const Image& face) {
                                  return face.width == face.height && face.width == faces[0].width;
                              });
        if (!complete) faces.assign(6, flat(8, 10, 18)); // night, until all six faces are there
        loaded.sky = gl::makeCubemap(faces, coding(loaded.prepared->scene, true));
    }

    void uploadAll(LoadedScene& loaded) {
        loaded.stale = true;
        if (!loaded.prepared->skyFaces.empty()) uploadSky(loaded);
    }

    void imageArrived(LoadedScene& loaded, const std::string& name) {
        loaded.stale |= loaded.prepared->textureSet.shows(name);
        const auto begin = loaded.prepared->skyFaces.begin(), end = loaded.prepared->skyFaces.end();
        const bool last = std::all_of(begin, end, [&](const auto& face) { return pictures.contains(face); });
        if (last && std::find(begin, end, name) != end) uploadSky(loaded);
    }

    // --- limits -----------------------------------------------------------------------------------------------------

    bool fits(const PreparedScene& prepared, Problems& problems) const {
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

    // --- programs ---------------------------------------------------------------------------------------------------

    void choose() {
        if (!wantedScene) return;
        Plan plan = splitPlanOf(*wantedScene->prepared, settings, targetOf(info));
        if (programs.overridden()) { // these are of the library's own files
            plan.split = {};
            plan.target.cachedLoads = false;
        }
        if (const int texels = sceneTexels(plan.scene); plan.scene.dataBlock && texels > plan.target.blockTexels) {
            plan.scene.dataBlock = false;
            pending.push_back({wantedScene->prepared->scene.file,
                               0,
                               {},
                               "the scene takes " + std::to_string(texels) +
                                   " texels, a uniform block of this GL holds " +
                                   std::to_string(plan.target.blockTexels) + ": its numbers go into a texture",
                               {}});
        }
        wanted = Programs(plan, programs, pending);
        adopted = false;
        adopt();
    }

    /// From here on the wanted programs draw, once they can.
    void adopt() {
        if (!wanted.canDraw()) return;
        if (!adopted) ++version; // its parts draw the same
        adopted = true;
        drawn = wanted;
        drawnScene = wantedScene;
        drawnSettings = settings;
    }

    ProgramState poll(Problems& problems) {
        const ProgramState state = wanted.poll(
            programs, [this](const CachedProgram& program) { warmUp(program); }, problems);
        if (!adopted || drawn.parted() != wanted.parted()) adopt();
        return state;
    }

    void warmUp(const CachedProgram& program) {
        const View view{wantedScene->prepared->scene.camera, 0, 1, 1};
        upload(view, wanted, *wantedScene, settings, true);
        glBindFramebuffer(GL_FRAMEBUFFER, warm.framebuffer.get());
        glViewport(0, 0, 1, 1);
        wanted.drawAlone(warm, program, {0, 0, 1, 1});
    }

    // --- drawing ----------------------------------------------------------------------------------------------------

    void uploadScene(const Plan& plan, LoadedScene& loaded, const View& view) {
        const auto texels = loaded.packer.pack(plan, view.time, view.camera.eye);
        if (plan.scene.dataBlock) {
            glBindBuffer(GL_UNIFORM_BUFFER, sceneBuffer.get());
            glBufferData(GL_UNIFORM_BUFFER, GLsizeiptr(texels.size() * sizeof(glm::vec4)), texels.data(),
                         GL_DYNAMIC_DRAW);
            glBindBufferBase(GL_UNIFORM_BUFFER, kSceneBinding, sceneBuffer.get());
            return;
        }
        const int full = int(texels.size()) / kDataWidth, rest = int(texels.size()) % kDataWidth;
        const int rows = full + (rest > 0);
        glActiveTexture(GL_TEXTURE0 + kDataUnit);
        if (rows != sceneRows) {
            sceneTexture = gl::makeDataTexture(kDataWidth, rows);
            sceneRows = rows;
        }
        glBindTexture(GL_TEXTURE_2D, sceneTexture.get());
        // An upload of no rows costs Firefox half a second.
        if (full > 0) glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, kDataWidth, full, GL_RGBA, GL_FLOAT, texels.data());
        if (rest > 0)
            glTexSubImage2D(GL_TEXTURE_2D, 0, 0, full, rest, 1, GL_RGBA, GL_FLOAT,
                            &texels[std::size_t(full) * kDataWidth]);
    }

    void bindImages(LoadedScene& loaded) {
        glActiveTexture(GL_TEXTURE0 + kPaintUnit);
        glBindTexture(GL_TEXTURE_2D_ARRAY, loaded.paints.get());
        glActiveTexture(GL_TEXTURE0 + kNormalUnit);
        glBindTexture(GL_TEXTURE_2D_ARRAY, loaded.normals.get());
        glActiveTexture(GL_TEXTURE0 + kSkyUnit);
        glBindTexture(GL_TEXTURE_CUBE_MAP, loaded.sky.get());
        glActiveTexture(GL_TEXTURE0 + kDataUnit);
    }

    /// All that programs read.
    void upload(const View& view, const Programs& with, LoadedScene& loaded, const Settings& choices, bool encode) {
        const FrameBlock block = frameBlock(view, loaded.prepared->scene, loaded.prepared->origin, choices, encode);
        glBindVertexArray(vertexArray.get());
        glBindBuffer(GL_UNIFORM_BUFFER, frameBuffer.get());
        glBufferData(GL_UNIFORM_BUFFER, sizeof block, &block, GL_DYNAMIC_DRAW);
        glBindBufferBase(GL_UNIFORM_BUFFER, kFrameBinding, frameBuffer.get());
        if (loaded.stale) uploadImages(loaded); // before their tiles are packed
        uploadScene(with.plan(), loaded, view);
        bindImages(loaded);
    }

    /// Where the smaller programs draw, of what was uploaded last.
    ScreenPartition partition(const View& view) const {
        if (!drawn.parted()) return {};
        CameraFrame camera = frameOf(view.camera);
        camera.eye = glm::dvec3(glm::vec3(camera.eye - drawnScene->prepared->origin)); // as the shader gets it
        const auto bounds = screenBoundsOf(*drawnScene->prepared, drawn.plan(), drawnScene->packer.shapes());
        return partitionOf(bounds, camera, view.width, view.height);
    }

    /// Rows of the picture as the settings have it, or others of which only numbers differ.
    void drawInto(const gl::Target& target, const View& view, const Settings& choices, bool encode, int from, int to) {
        upload(view, drawn, *drawnScene, choices, encode);
        glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer.get());
        glViewport(0, 0, view.width, view.height);
        glDisable(GL_BLEND);
        drawn.draw(target, partition(view), {0, from, view.width, to - from});
    }

    // Pictures go into a target of our own and from there to the window, also at full scale: some drivers compile a
    // program anew for each format of target, and the window's differs.
    void drawPicture(const View& view) {
        resize(picture, view.width, view.height, GL_RGBA8);
        asked = monotonicSeconds();
        drawInto(picture, view, drawnSettings, true, 0, view.height);
        drawing.set();
    }

    void drawBand(const View& view, int from, int to) {
        resize(aside, view.width, view.height, GL_RGBA8);
        asked = monotonicSeconds();
        drawInto(aside, view, drawnSettings, true, from, to);
        drawing.set();
    }

    bool busy() {
        if (!drawing.isSet()) return false;
        if (!drawing.passed()) return true;
        drawSeconds = monotonicSeconds() - asked;
        return false;
    }

    /// The lowest `rows` of a target over as much of the framebuffer as they are of the whole.
    static void blit(const gl::Target& from, int rows, const View& view, GLuint framebuffer) {
        const bool same = from.width == view.width && from.height == view.height;
        glBindFramebuffer(GL_READ_FRAMEBUFFER, from.framebuffer.get());
        glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
        const int to = int(std::lround(double(view.height) * rows / from.height));
        glBlitFramebuffer(0, 0, from.width, rows, 0, 0, view.width, to, GL_COLOR_BUFFER_BIT,
                          same ? GL_NEAREST : GL_LINEAR);
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
        glViewport(0, 0, view.width, view.height);
    }

    void resize(gl::Target& target, int width, int height, GLenum format) const {
        const bool leaves = drawn.fallsBack(), notes = bool(target.coverage) || !leaves;
        if (target.width == width && target.height == height && target.format == format && notes) return;
        target = gl::makeTarget(width, height, format, leaves);
    }

    /// Draws into a target of `format` and leaves it bound for reading.
    bool drawOutput(const View& view, GLenum format, bool encode, const Settings& with, Problems& problems) {
        if (!drawn) return false;
        const auto refuse = [&](const std::string& what, const std::string& remedy) {
            problems.push_back({{}, 0, {}, what, remedy});
            return false;
        };
        if (view.width > info.maxTextureSize || view.height > info.maxTextureSize)
            return refuse("a picture of " + std::to_string(view.width) + "x" + std::to_string(view.height) +
                              " is larger than this GL's " + std::to_string(info.maxTextureSize),
                          "use a smaller --size");
        if (format == GL_RGBA32F && !info.floatTargets)
            return refuse("this GL cannot draw float32 pictures (EXT_color_buffer_float is missing)",
                          "use another --context");
        resize(output, view.width, view.height, format);
        if (!output.framebuffer)
            return refuse("the GL has no memory for a picture of this size", "use a smaller --size");
        drawInto(output, view, with, encode, 0, view.height);
        glPixelStorei(GL_PACK_ALIGNMENT, 1);
        return true;
    }

    FloatImage readOnce(const View& view, const Settings& with, Problems& problems) {
        if (!drawOutput(view, GL_RGBA32F, false, with, problems)) return {};
        std::vector<float> rgba(std::size_t(view.width) * view.height * 4);
        glReadPixels(0, 0, view.width, view.height, GL_RGBA, GL_FLOAT, rgba.data());
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
        if (!gl::check("reading the picture back", problems)) return {};
        FloatImage image{view.width, view.height, channelsOf(settings.aov), {}};
        image.pixels.resize(std::size_t(image.width) * image.height * image.channels);
        for (int y = 0; y < view.height; ++y) // GL's first row is the lowest
            for (int x = 0; x < image.width; ++x)
                std::copy_n(&rgba[(std::size_t(image.height - 1 - y) * image.width + x) * 4], image.channels,
                            image.at(x, y));
        return image;
    }

    /// The mean of pictures that take a stretch of the samples each.
    FloatImage readInBatches(const View& view, Problems& problems) {
        const Settings& all = drawnSettings;
        const int most = batchOf(all);
        FloatImage sum;
        for (int done = 0; done < all.samples && problems.empty(); done += most) {
            Settings stretch = all;
            stretch.firstSample = all.firstSample + done;
            stretch.samples = std::min(most, all.samples - done);
            FloatImage part = readOnce(view, stretch, problems);
            const float share = float(stretch.samples) / float(all.samples);
            if (sum.pixels.empty())
                sum = {part.width, part.height, part.channels, std::vector<float>(part.pixels.size())};
            for (std::size_t i = 0; i < part.pixels.size(); ++i) sum.pixels[i] += share * part.pixels[i];
        }
        return sum;
    }
};

Renderer::Renderer(std::span<const ShaderFile> overrides) : impl_(std::make_unique<Impl>(overrides)) {}
Renderer::~Renderer() = default;

bool Renderer::setScene(const Scene& scene, Problems& problems) {
    const PreparedScenePtr prepared = prepare(scene);
    if (!impl_->fits(*prepared, problems)) return false;
    auto loaded = std::make_shared<LoadedScene>(LoadedScene{prepared, ScenePacker(prepared)});
    impl_->uploadAll(*loaded);
    impl_->wantedScene = std::move(loaded);
    impl_->choose();
    return true;
}

void Renderer::setImage(const std::string& name, const Image& image) {
    impl_->pictures[name] = image;
    ++impl_->version;
    if (impl_->wantedScene) impl_->imageArrived(*impl_->wantedScene, name);
    if (impl_->drawnScene && impl_->drawnScene != impl_->wantedScene) impl_->imageArrived(*impl_->drawnScene, name);
}

void Renderer::configure(const Settings& settings) {
    const bool alike = planAlike(impl_->settings, settings);
    impl_->settings = settings;
    ++impl_->version;
    if (!alike || !impl_->wanted) impl_->choose();
    // What is only a number acts at once, also while a new program compiles.
    if (impl_->drawn) impl_->drawnSettings = settings;
}

void Renderer::replaceShaders(std::span<const ShaderFile> overrides) {
    impl_->programs.setOverrides(overrides);
    impl_->choose();
}

ProgramState Renderer::poll(Problems& problems) {
    const auto tell = [&] {
        problems.insert(problems.end(), impl_->pending.begin(), impl_->pending.end());
        impl_->pending.clear();
    };
    tell();
    if (!impl_->wanted) return impl_->wantedScene ? ProgramState::Failed : ProgramState::None;
    const ProgramState state = impl_->poll(problems);
    tell(); // of its images
    return state;
}

bool Renderer::finish(Problems& problems) {
    ProgramState state = poll(problems);
    while (state == ProgramState::Compiling) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
        state = poll(problems);
    }
    return state == ProgramState::Ready;
}

bool Renderer::canDraw() const { return impl_->drawn.canDraw(); }

void Renderer::draw(const View& view, double scale, unsigned framebuffer) {
    if (!impl_->drawn || view.width <= 0 || view.height <= 0) return;
    impl_->drawPicture(scaled(view, scale));
    Impl::blit(impl_->picture, impl_->picture.height, view, framebuffer);
}

void Renderer::drawRows(const View& view, double scale, int from, int to) {
    if (impl_->drawn && from < to) impl_->drawBand(scaled(view, scale), from, to);
}

void Renderer::show(const View& view, int rows, unsigned framebuffer) {
    const gl::Target &coarse = impl_->picture, &fine = impl_->aside;
    if (coarse.framebuffer && rows < fine.height) Impl::blit(coarse, coarse.height, view, framebuffer);
    // An edge that is stretched takes in something of the row above it, which is not drawn yet.
    const int ready = rows < fine.height ? rows - 1 : rows;
    if (fine.framebuffer && ready > 0) Impl::blit(fine, ready, view, framebuffer);
}

bool Renderer::busy() { return impl_->busy(); }
double Renderer::drawSeconds() const { return impl_->drawSeconds; }
unsigned Renderer::version() const { return impl_->version; }

FloatImage Renderer::readOutput(const View& view, Problems& problems) {
    return inBatches(impl_->drawnSettings) ? impl_->readInBatches(view, problems)
                                             : impl_->readOnce(view, impl_->drawnSettings, problems);
}

Image Renderer::readPicture(const View& view, Problems& problems) {
    if (impl_->drawn && inBatches(impl_->drawnSettings) && impl_->info.floatTargets)
        return pictureOf(impl_->readInBatches(view, problems), impl_->drawn.plan().scene.linear);
    if (!impl_->drawOutput(view, GL_RGBA8, true, impl_->drawnSettings, problems)) return {};
    const std::size_t row = std::size_t(view.width) * 4;
    std::vector<std::uint8_t> rgba(row * view.height);
    glReadPixels(0, 0, view.width, view.height, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    if (!gl::check("reading the picture back", problems)) return {};
    Image image{view.width, view.height, std::vector<std::uint8_t>(rgba.size())};
    for (int y = 0; y < view.height; ++y) std::copy_n(&rgba[row * (view.height - 1 - y)], row, &image.rgba[row * y]);
    return image;
}

ProgramStats Renderer::stats() const { return impl_->drawn.stats(); }

const std::string& Renderer::source() const {
    static const std::string none;
    return impl_->drawn ? impl_->drawn.full().source.text : none;
}

void Renderer::contextLost() {
    Impl& i = *impl_;
    i.programs.forget();
    i.wanted = i.drawn = {};
    for (const auto& loaded : {i.wantedScene, i.drawnScene}) {
        if (!loaded) continue;
        for (gl::Texture* texture : {&loaded->paints, &loaded->normals, &loaded->sky}) texture->forget();
    }
    i.drawnScene = nullptr;
    i.vertexArray.forget();
    i.frameBuffer.forget();
    i.sceneBuffer.forget();
    i.sceneTexture.forget();
    i.sceneRows = 0;
    i.drawing.forget();
    for (gl::Target* target : {&i.picture, &i.aside, &i.output, &i.warm}) {
        target->color.forget();
        target->depth.forget();
        target->framebuffer.forget();
        target->coverage.forget();
        *target = {};
    }
}

void Renderer::contextRestored() {
    impl_->info = gl::info(); // extensions must be asked for anew
    impl_->makeObjects();
    if (impl_->wantedScene) impl_->uploadAll(*impl_->wantedScene);
    impl_->choose();
}

} // namespace gnomon
