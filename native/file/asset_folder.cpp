#include "native/file/asset_folder.h"

#include "native/file/input_file.h"
#include "tracer/image_header.h"
#include "tracer/image_memory.h"
#include "tracer/scene/json_document.h"
#include "tracer/scene/read_scene.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdlib>
#include <fstream>
#include <span>
#include <string_view>

namespace gnomon {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kMostFileBytes = std::size_t(128) << 20;    ///< of an image
constexpr std::size_t kMostDecodedBytes = std::size_t(512) << 20; ///< of all images of a scene together

bool isFile(const fs::path& path) {
    std::error_code ignored;
    return fs::is_regular_file(path, ignored);
}

bool isFolder(const fs::path& path) {
    std::error_code ignored;
    return fs::is_directory(path, ignored);
}

/// Memory that an image file's pixels take, as it says itself; 0 of a file that says nothing.
std::uint64_t decodedBytes(const fs::path& file) {
    std::vector<std::uint8_t> bytes(kHeaderBytes);
    std::ifstream in(file, std::ios::binary);
    in.read(reinterpret_cast<char*>(bytes.data()), std::streamsize(bytes.size()));
    const auto header = imageHeader(std::span(bytes).first(std::size_t(in.gcount())));
    return header ? header->pixels() * 4 : 0;
}

constexpr std::array<std::string_view, 4> kImageEndings{".png", ".jpg", ".jpeg", ".hdr"};

bool endsAsAnImage(const std::string& name) {
    std::string ending = fs::path(name).extension().string();
    for (char& c : ending) c = char(std::tolower(static_cast<unsigned char>(c)));
    return std::find(kImageEndings.begin(), kImageEndings.end(), ending) != kImageEndings.end();
}

/// Files that an image's name may mean, the first that exists is taken: docs/scenes.md tells the rule, and
/// web/page/load.js has it too.
std::vector<std::string> filesNamed(const std::string& name) {
    if (endsAsAnImage(name)) return {name};
    std::vector<std::string> files;
    for (const char* added : {".png", ".PNG", ".jpg", ".JPG", ".jpeg", ".JPEG"}) files.push_back(name + added);
    return files;
}

/// What a background's images are not: squares of one size, or twice as wide as high. They are stretched then.
void noteSizes(const Scene& scene, const NamedImages& images, Problems& notes) {
    const std::string &cube = scene.background.cubemap, &panorama = scene.background.image;
    const auto isFace = [&](const std::string& name) {
        return !cube.empty() && name.size() == cube.size() + 3 && name.starts_with(cube); // CUBE-px
    };
    int side = 0;
    for (const auto& [name, image] : images) {
        std::string wanted;
        if (isFace(name) && (image.width != image.height || (side != 0 && side != image.width)))
            wanted = "those of a cube map are squares of one size";
        else if (name == panorama && image.width != 2 * image.height)
            wanted = "a background's is twice as wide as high";
        if (isFace(name)) side = image.width;
        if (wanted.empty()) continue;
        const std::string size = std::to_string(image.width) + " x " + std::to_string(image.height);
        notes.push_back({scene.file, 0, {}, "image '" + name + "' is stretched: it has " + size, wanted});
        return;
    }
}

/// Is `text` a path rather than a scene's name?
bool looksLikeFile(const std::string& text) {
    return text.find('/') != std::string::npos || fs::path(text).extension() == ".json";
}

} // namespace

std::optional<AssetFolder> AssetFolder::find(Problems& problems) {
    if (const char* chosen = std::getenv("GNOMON_ASSETS"); chosen && *chosen) {
        if (isFolder(fs::path(chosen) / "scenes")) return AssetFolder(chosen);
        problems.push_back({"GNOMON_ASSETS",
                            0,
                            {},
                            std::string(chosen) + " holds no folder scenes",
                            "let it name the assets folder, or unset it"});
        return std::nullopt;
    }
    std::error_code ignored;
    const fs::path program = fs::read_symlink("/proc/self/exe", ignored).parent_path();
    for (const fs::path& root : {program.parent_path() / "share" / "gnomon", fs::path(GNOMON_SOURCE_DIR) / "assets"})
        if (isFolder(root / "scenes")) return AssetFolder(root);
    problems.push_back({{},
                        0,
                        {},
                        "the scenes and textures that come with the program are not found",
                        "set GNOMON_ASSETS to the assets folder"});
    return std::nullopt;
}

std::vector<std::string> AssetFolder::sceneNames() const {
    std::vector<std::string> names;
    std::error_code ignored;
    for (const auto& entry : fs::directory_iterator(root_ / "scenes", ignored)) {
        const fs::path name = entry.path().filename();
        // `NAME.schema.json` describes scenes; it is none.
        if (name.extension() == ".json" && name.stem().extension().empty()) names.push_back(name.stem().string());
    }
    std::sort(names.begin(), names.end());
    return names;
}

std::optional<fs::path> AssetFolder::fileOf(const std::string& nameOrFile, Problems& problems) const {
    if (!looksLikeFile(nameOrFile)) {
        const fs::path named = root_ / "scenes" / (nameOrFile + ".json");
        if (isFile(named)) return named;
    }
    std::error_code ignored;
    if (nameOrFile == "-" || (fs::exists(nameOrFile, ignored) && !isFolder(nameOrFile))) return nameOrFile;
    if (isFolder(nameOrFile)) {
        problems.push_back({nameOrFile, 0, {}, "is a folder", "name a scene file in it"});
        return std::nullopt;
    }
    const auto names = sceneNames();
    const auto meant = closest(nameOrFile, {names.begin(), names.end()});
    std::string remedy = "`gnomon scenes` lists the names";
    if (!meant.empty()) remedy = "did you mean '" + std::string(meant) + "'?";
    if (looksLikeFile(nameOrFile))
        problems.push_back(
            {nameOrFile, 0, {}, "there is no such scene file", meant.empty() ? "check the path" : remedy});
    else
        problems.push_back({{}, 0, {}, "there is no scene '" + nameOrFile + "'", remedy});
    return std::nullopt;
}

std::optional<Scene> AssetFolder::readScene(const std::string& nameOrFile, Problems& problems) const {
    const auto file = fileOf(nameOrFile, problems);
    if (!file) return std::nullopt;
    const auto text = readInput(file->string(), kMaxJsonBytes, "use a smaller scene", problems);
    if (!text) return std::nullopt;
    const fs::path folder = isFile(*file) ? file->parent_path() : fs::path();
    const auto beside = [&](const std::string& path, Problems& wrong) -> std::optional<std::string> {
        const fs::path besides = folder / path;
        std::error_code ignored;
        if (!fs::exists(besides, ignored) || isFile(besides) || isFolder(besides))
            return readInput(besides.string(), kMaxSceneFileBytes, "use a smaller file", wrong);
        wrong.push_back({besides.string(), 0, {}, "is a pipe or a device", "name a file"}); // it might never end
        return std::nullopt;
    };
    return gnomon::readScene(*text, inputName(file->string()), problems, beside);
}

std::optional<fs::path> AssetFolder::imageFileOf(const Scene& scene, const std::string& name,
                                                 Problems& problems) const {
    // Beside the scene; one that came through a pipe stands in the folder that the program was started in.
    const fs::path folder = isFile(scene.file) ? fs::path(scene.file).parent_path() : fs::path();
    const std::vector<std::string> files = filesNamed(name);
    for (const fs::path& parent : {folder, root_ / "textures"})
        for (const std::string& file : files)
            if (isFile(parent / file)) return parent / file;
    std::string what = "is missing";
    std::string remedy = "put it at " + (folder / files[0]).string() + " or " +
                         (root_ / "textures" / files[0]).string() + (files.size() > 1 ? ", or as .jpg" : "");
    if (isFile(folder / name)) {
        what = "is of a format that is not read";
        remedy = "convert it to PNG or JPEG, or to Radiance HDR if it is a background";
    } else if (const std::string& cubemap = scene.background.cubemap;
               endsAsAnImage(cubemap) && name.starts_with(cubemap)) {
        remedy = "leave the ending out of the cube map's name: the files NAME-px and so on have it";
    }
    problems.push_back({scene.file, 0, {}, "image '" + name + "' " + what, remedy});
    return std::nullopt;
}

std::optional<NamedImages> AssetFolder::readImages(const Scene& scene, Problems& problems, Problems* notes) const {
    const std::size_t before = problems.size();
    std::vector<std::pair<std::string, fs::path>> files;
    std::uint64_t decoded = 0;
    for (const auto& name : imagesOf(scene))
        if (const auto file = imageFileOf(scene, name, problems)) {
            files.emplace_back(name, *file);
            decoded += decodedBytes(*file);
        }
    const auto tooMuch = [&](std::uint64_t bytes, std::uint64_t most, const std::string& when = {}) {
        if (bytes <= most) return false;
        problems.push_back({scene.file,
                            0,
                            {},
                            "its images take " + std::to_string(bytes >> 20) + " MB" + when + "; " +
                                std::to_string(most >> 20) + " MB are the most",
                            "use fewer or smaller images"});
        return true;
    };
    if (tooMuch(decoded, kMostDecodedBytes)) return std::nullopt;
    NamedImages images;
    std::uint64_t held = 0; // what files say of themselves may stand behind where it was looked for
    for (const auto& [name, file] : files) {
        const auto bytes = readInput(file.string(), kMostFileBytes, "use a smaller image", problems);
        if (!bytes) continue;
        const std::span span(reinterpret_cast<const std::uint8_t*>(bytes->data()), bytes->size());
        const auto header = measureImage(file.string(), span, problems);
        if (!header) continue;
        if (tooMuch(held + bytes->size() + header->decodeBytes, kMostImageMemory, " while " + name + " is decoded"))
            return std::nullopt;
        auto image = decodeImage(file.string(), span, problems);
        if (!image) continue;
        if (tooMuch(held += image->rgba.size(), kMostDecodedBytes)) return std::nullopt;
        images.emplace_back(name, std::move(*image));
        const std::string note = colorNote(span);
        if (notes && !note.empty()) notes->push_back({file.string(), 0, {}, note, "convert it to sRGB"});
    }
    if (notes) noteSizes(scene, images, *notes);
    return problems.size() == before ? std::optional(std::move(images)) : std::nullopt;
}

std::optional<Loaded> load(const std::string& nameOrFile, Problems& problems) {
    const auto assets = AssetFolder::find(problems);
    if (!assets) return std::nullopt;
    auto scene = assets->readScene(nameOrFile, problems);
    if (!scene) return std::nullopt;
    Problems notes;
    auto images = assets->readImages(*scene, problems, &notes);
    if (!images) return std::nullopt;
    return Loaded{*assets, std::move(*scene), std::move(*images), std::move(notes)};
}

} // namespace gnomon
