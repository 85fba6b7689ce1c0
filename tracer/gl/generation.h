/// What GL objects belong to. A lost context takes all of its objects along; the one that follows is a new generation,
/// and an object of an older one reads as empty and touches no GL when it is deleted. So nobody keeps a list of what to
/// forget.
///
/// One context is current at a time: whoever ends or loses it says so, before objects of the next are made.
#pragma once

namespace gnomon::gl {

/// Counts the contexts there have been: an object belongs to the one it was made in.
unsigned generation();
/// All objects made so far are gone with their context.
void contextLost();

/// Objects of this generation that are not deleted: a flat count proves that nothing leaks.
int liveObjects();

namespace detail {
void objectMade();
void objectDeleted();
} // namespace detail

} // namespace gnomon::gl
