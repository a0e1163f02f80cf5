#pragma once

namespace rubsweep::batch {

/// `automatic`: only when the stream is a terminal.
enum class ProgressMode { automatic, always, never };

}  // namespace rubsweep::batch
