#pragma once

#include <atomic>
#include <limits>
#include <set>
#include <string>

#include <planish/core/context.h>

#include <gtest/gtest.h>

namespace planish {

/// Sees to what a long job reports, and cancels it after a number of reports.
class WatchedJob {
 public:
  explicit WatchedJob(int most = std::numeric_limits<int>::max()) : most_(most) {}

  Context context(unsigned threads = 0) {
    return {threads, [this](const Progress& progress) { see(progress); },
            [this] { return reports_ >= most_; }};
  }

  int reports() const { return reports_; }
  double share() const { return share_; }
  const std::set<std::string>& subjects() const { return subjects_; }

 private:
  void see(const Progress& progress) {
    EXPECT_LT(reports_, most_) << "none after it was cancelled";
    EXPECT_GE(progress.share, share_) << progress.stage;
    EXPECT_LE(progress.share, 1.0 + 1e-12) << progress.stage;
    EXPECT_FALSE(progress.stage.empty());
    share_ = progress.share;
    subjects_.emplace(progress.subject);
    ++reports_;
  }

  int most_;
  std::atomic<int> reports_ = 0;
  double share_ = 0.0;
  std::set<std::string> subjects_;
};

/// Runs a job again and again, cancelled after the first report, the second one, ...: each time it
/// must end with Cancelled.
/// @param job called with a context
/// @param tries at most so many, evenly spread over the reports of a whole run
template <class Job>
void expect_cancellable(const Job& job, int tries = 10) {
  WatchedJob whole;
  job(whole.context());
  ASSERT_GT(whole.reports(), 1);
  for (int last = 1; last < whole.reports(); last += 1 + whole.reports() / tries) {
    WatchedJob cut(last);
    EXPECT_THROW(job(cut.context()), Cancelled) << last;
    EXPECT_EQ(cut.reports(), last);
  }
}

}  // namespace planish
