/// Which program this is: numbers say which one they are of.
#pragma once

namespace gnomon {

const char* version(); ///< `0.1.0`
const char* commit();  ///< as `git describe` tells it, `unknown` where there is no checkout

} // namespace gnomon
