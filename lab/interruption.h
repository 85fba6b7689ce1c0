/// Ctrl-C and SIGTERM end every command with the same code: at once, or where something is being measured, once what
/// was measured is kept.
#pragma once

namespace gnomon {

/// From here on an interruption ends the program at once, with `code`.
void endWhenInterrupted(int code);
/// From here on the first one is put off; one that comes a while later ends the program all the same.
void deferInterruption();
/// One came and was put off: what is done is to be kept, and no more to be begun.
bool interrupted();

} // namespace gnomon
