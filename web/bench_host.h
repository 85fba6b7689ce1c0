/// What the host has to tell the page's comparison of frame rates, if one is under way.
#pragma once

/// The context with all its objects is gone, and there is a new one.
void benchLost();
void benchRestored();
