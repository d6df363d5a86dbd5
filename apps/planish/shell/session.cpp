#include "shell/session.h"

#include <algorithm>
#include <exception>
#include <set>

#include "platform/path.h"
#include "shell/failures.h"
#include "shell/text.h"
#include "shell/values.h"

namespace planish::cli {

namespace {

constexpr int k_bar_width = 14;
constexpr auto k_redraw_interval = std::chrono::milliseconds(100);

std::string bar(double share) {
  const auto full = static_cast<std::size_t>(k_bar_width * std::clamp(share, 0.0, 1.0));
  return "[" + left(std::string(full, '#'), k_bar_width) + "]";
}

}  // namespace

Session::Session(const Arguments& arguments, std::ostream& err, const RunContext& context)
    : err_(err),
      context_(context),
      quiet_(arguments.has("--quiet")),
      draws_progress_(context.err_is_terminal && !quiet_) {
  const Field threads = arguments.value("--threads", 0);
  threads_ = static_cast<unsigned>(whole_number_of("--threads", threads, k_threads));
}

Session::~Session() {
  clear_progress();
}

void Session::note(const std::string& message) {
  if (quiet_) return;
  clear_progress();
  err_ << "note: " << Shown{message} << "\n";
}

void Session::tell(const std::string& line) {
  if (quiet_) return;
  clear_progress();
  err_ << Shown{line} << std::endl;
}

void Session::print(std::string_view line) {
  clear_progress();
  if (context_.on_line) context_.on_line(line);
}

RunContext Session::inner_context() const {
  return {.interrupted = context_.interrupted};
}

void Session::warn(const std::string& message) {
  clear_progress();
  err_ << "warning: " << Shown{message} << "\n";
}

void Session::show_progress(const std::string& stage, double share, const std::string& detail) {
  if (!draws_progress_) return;
  const auto now = std::chrono::steady_clock::now();
  if (drawn_ > 0 && now - last_drawn_ < k_redraw_interval) return;
  last_drawn_ = now;
  std::string line = left(stage, 10) + bar(share) + right(fixed(100.0 * share, 0), 4) + " %";
  if (!detail.empty()) line += "  " + detail;
  line.resize(std::min(line.size(), k_text_width - 1));
  err_ << '\r' << Shown{left(line, drawn_)} << std::flush;  // padded over what stood there
  drawn_ = line.size();
}

void Session::clear_progress() {
  if (drawn_ == 0) return;
  err_ << '\r';
  for (std::size_t i = 0; i < drawn_; ++i)
    err_ << ' ';
  err_ << '\r' << std::flush;
  drawn_ = 0;
}

Context Session::job_context(std::string detail) {
  Context context = silent_context();
  context.on_progress = [this, detail = std::move(detail)](const Progress& progress) {
    show_progress(std::string(progress.stage), progress.share,
                  progress.subject.empty() ? detail : std::string(progress.subject));
    if (context_.on_progress) context_.on_progress(progress);
  };
  return context;
}

Context Session::silent_context() const {
  return {threads_, {}, [this] { return interrupted(); }};
}

bool Session::interrupted() const {
  return !is_resumed_ && context_.interrupted != nullptr && context_.interrupted->load();
}

void Session::stop_if_interrupted() const {
  if (interrupted()) throw Cancelled();
}

ReadResult Session::read(const std::string& path, const ReadOptions& options) {
  ReadResult result = read_mesh(path_of(path), options);
  for (const std::string& message : result.notes)
    note(path + ": " + message);
  stop_if_interrupted();
  return result;
}

void Session::open(const std::filesystem::path& page) noexcept {
  try {
    const std::string fault = context_.open_document == nullptr
                                  ? "this program has no way to"
                                  : context_.open_document(std::filesystem::absolute(page));
    if (!fault.empty()) note("cannot open " + utf8_of(page) + ": " + fault);
  } catch (const std::exception&) {
    // Without memory even for the note, the page is there all the same.
  }
}

SystemFacts Session::system_facts() const {
  return context_.system_facts == nullptr ? SystemFacts() : context_.system_facts();
}

std::string Session::run_program(const std::vector<std::string>& words) {
  if (context_.run_program == nullptr) return "cannot be started: this program has no way to";
  clear_progress();
  std::string fault = context_.run_program(words, [this] { return interrupted(); });
  stop_if_interrupted();
  return fault;
}

void Session::write(const std::vector<OutputFile>& files, const std::filesystem::path& folder) {
  stop_if_interrupted();
  clear_progress();
  write_files(files, folder);
}

void refuse_shared_places(const std::vector<OutputFile>& files) {
  std::set<std::filesystem::path> places;
  for (const OutputFile& file : files) {
    const auto place = std::filesystem::absolute(file.path).lexically_normal();
    if (!places.insert(place).second) {
      throw UsageError("two outputs have the same path " + utf8_of(file.path));
    }
  }
}

std::map<std::string, std::string> output_paths(
    const Arguments& arguments, std::initializer_list<std::pair<const char*, const char*>> flags) {
  std::map<std::string, std::string> paths;
  std::vector<OutputFile> files;
  for (const auto& [role, flag] : flags) {
    if (!arguments.has(flag)) continue;
    paths[role] = arguments.text(flag);
    files.push_back({path_of(paths[role]), {}});
  }
  refuse_shared_places(files);
  return paths;
}

}  // namespace planish::cli
