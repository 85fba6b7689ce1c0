#include "tracer/version.h"

namespace gnomon {

const char* version() { return GNOMON_VERSION; }
const char* commit() { return GNOMON_COMMIT; }

} // namespace gnomon
