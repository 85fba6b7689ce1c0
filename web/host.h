/// What the page's two modules share, the viewer (gnomon.wasm) and the laboratory (gnomon-lab.wasm): the context, the
/// files that scenes name, and the ways in which texts and pixels go out.
///
/// Text goes in and out as UTF-8. A `const char*` that comes out stays valid until the next call; where it tells of
/// problems, empty means that there are none. The JavaScript side of the exports is page/module.js for those that both
/// have, page/tracer.js for the viewer's and page/lab_calls.js for the laboratory's.
#pragma once

#include "tracer/image.h"
#include "tracer/problem.h"
#include "tracer/scene/read_scene.h"

#include <emscripten.h>

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// What each module does once the browser has taken the context, and once it has given it back.
void onContextLost();
void onContextRestored();

/// Files that scenes name, as the page has fetched them: see giveFile().
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
