/// What the page's exports share: the viewer, and the ways in which texts and pixels go out.
///
/// Text goes in and out as UTF-8. A `const char*` that comes out stays valid until the next call; where it tells of
/// problems, empty means that there are none. The page owns events, time and loading; what they mean is decided in
/// Viewer. page/tracer.js and page/compare_calls.js are the JavaScript side of the exports.
#pragma once

#include "tracer/problem.h"
#include "tracer/render/viewer.h"
#include "tracer/scene/read_scene.h"

#include <emscripten.h>

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

struct Host {
    std::unique_ptr<gnomon::Viewer> viewer;
    gnomon::Problems problems;                ///< of frames, until the page takes them
    std::map<std::string, std::string> files; ///< by path; kept, each the latest of its path
};
extern Host host;

/// Files that scenes name, as the page has fetched them.
gnomon::SceneFiles givenFiles();

/// Hands text out.
const char* give(std::string text);

/// Hands a picture or an array of floats out: width, height, channels and address, for as long as `values` live.
const int* hand(int width, int height, int channels, const void* values);

/// Of a file's bytes, or of texels where they have a width: those of formats that the browser decodes.
std::optional<gnomon::Image> imageFrom(const std::string& name, std::span<const std::uint8_t> bytes, int width,
                                       gnomon::Problems&);

std::vector<std::string> linesOf(std::string_view text);
std::string inLines(const std::vector<std::string>& lines);

/// Of lines `key=value`.
std::vector<std::pair<std::string, std::string>> pairsOf(std::string_view text);
