#include "tracer/image_memory.h"

#include <algorithm>

namespace gnomon {

std::size_t peakMemory(std::span<const ImageUpload> uploads) {
    std::size_t held = 0, peak = 0;
    for (const ImageUpload& upload : uploads) held += upload.images;
    for (const ImageUpload& upload : uploads) {
        held += upload.texels + upload.texels / 3; // coarser levels: a quarter, a quarter of that, and so on
        peak = std::max(peak, held + upload.scratch);
        held -= upload.images;
    }
    return peak;
}

} // namespace gnomon
