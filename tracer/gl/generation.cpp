#include "tracer/gl/generation.h"

namespace gnomon::gl {
namespace {

unsigned current = 1;
int alive = 0;

} // namespace

unsigned generation() { return current; }

void contextLost() {
    ++current;
    alive = 0;
}

int liveObjects() { return alive; }

namespace detail {
void objectMade() { ++alive; }
void objectDeleted() { --alive; }
} // namespace detail

} // namespace gnomon::gl
