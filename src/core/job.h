#pragma once

#include <algorithm>

#include <planish/core/context.h>

namespace planish {

/// @throws Cancelled if the job was cancelled
inline void stop_if_cancelled(const Context& context) {
  if (context.is_cancelled && context.is_cancelled()) throw Cancelled();
}

/// Reports how far a job is, and ends it if it was cancelled. From the calling thread of the job.
/// @throws Cancelled
inline void report_progress(const Context& context, const Progress& progress) {
  if (context.on_progress) context.on_progress(progress);
  stop_if_cancelled(context);
}

/// The context of a part of a job, whose shares go from `begin` to `end` of the whole.
/// @param subject of the part, where the part has none of its own; must outlive the part
inline Context part_of(const Context& context, double begin, double end,
                       std::string_view subject = {}) {
  Context part = context;
  if (!context.on_progress) return part;
  part.on_progress = [tell = context.on_progress, begin, end, subject](Progress progress) {
    progress.share = begin + (end - begin) * progress.share;
    if (progress.subject.empty()) progress.subject = subject;
    tell(progress);
  };
  return part;
}

/// Progress of a job whose number of steps is not known.
class StepProgress {
 public:
  /// @param of_rest what a step takes of what is left
  explicit StepProgress(double of_rest = 0.1) : of_rest_(of_rest) {}

  double after_step() { return share_ += of_rest_ * (1.0 - share_); }
  double share() const { return share_; }

 private:
  double of_rest_, share_ = 0.0;
};

/// Divides a job into parts whose number is not known: each takes its share of what is left.
class PartsOfJob {
 public:
  explicit PartsOfJob(const Context& context) : context_(context) {}

  /// The context of the next part.
  /// @param share of what is left, 0 to 1
  Context next(double share) {
    const double begin = done_;
    done_ += share * (1.0 - done_);
    return part_of(context_, begin, done_);
  }

 private:
  const Context& context_;
  double done_ = 0.0;
};

}  // namespace planish
