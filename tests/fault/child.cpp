#include "fault/child.h"

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <set>
#include <stdexcept>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace planish::fault {

namespace {

namespace fs = std::filesystem;

std::string content_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

void limit(int resource, rlim_t value) {
  if (value == 0) return;
  struct rlimit both = {};
  getrlimit(static_cast<__rlimit_resource>(resource), &both);
  both.rlim_cur = value;
  setrlimit(static_cast<__rlimit_resource>(resource), &both);
}

/// In the child only: from here on nothing is allocated.
void put(int descriptor, const std::string& path) {
  if (path == "-") {
    close(descriptor);
  } else if (path == "|") {
    int ends[2] = {};
    if (pipe(ends) != 0) _exit(126);
    dup2(ends[1], descriptor);
    close(ends[0]);
    close(ends[1]);
  } else {
    const int file = open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    if (file < 0) _exit(126);
    dup2(file, descriptor);
    close(file);
  }
}

pid_t start(const std::vector<std::string>& args, const Limits& limits, const Standard& standard) {
  std::vector<std::string> words = {PLANISH_PROGRAM};
  words.insert(words.end(), args.begin(), args.end());
  std::vector<char*> pointers;
  for (std::string& word : words)
    pointers.push_back(word.data());
  pointers.push_back(nullptr);
  const pid_t id = fork();
  if (id < 0) throw std::runtime_error("no process to be had");
  if (id > 0) return id;
  put(STDOUT_FILENO, standard.out);
  put(STDERR_FILENO, standard.err);
  limit(RLIMIT_AS, limits.memory);
  limit(RLIMIT_CPU, limits.cpu_seconds);
  limit(RLIMIT_FSIZE, limits.file_size);
  execv(PLANISH_PROGRAM, pointers.data());
  _exit(127);
}

Ended waited_for(pid_t id) {
  int status = 0;
  while (waitpid(id, &status, 0) < 0 && errno == EINTR) {
  }
  Ended ended;
  if (WIFEXITED(status)) ended.exit_code = WEXITSTATUS(status);
  if (WIFSIGNALED(status)) ended.signal = WTERMSIG(status);
  return ended;
}

std::string under_callgrind(const std::vector<std::string>& args, const std::string& out) {
  std::string command =
      "valgrind --tool=callgrind --callgrind-out-file=" + out + " " PLANISH_PROGRAM;
  for (const std::string& word : args)
    command += " '" + word + "'";
  return command;
}

}  // namespace

std::string told(const Ended& ended) {
  const std::string how = ended.signal != 0 ? "signal " + std::to_string(ended.signal)
                                            : "exit code " + std::to_string(ended.exit_code);
  return how + ", out: " + ended.out.substr(0, 500) + ", err: " + ended.err.substr(0, 500);
}

std::uint64_t instructions_of(const std::vector<std::string>& args) {
  const std::string command =
      under_callgrind(args, "/dev/null") + " 2>&1 >/dev/null | sed -n 's/.*Collected : //p'";
  FILE* const pipe = popen(command.c_str(), "r");
  unsigned long long count = 0;
  if (pipe == nullptr || fscanf(pipe, "%llu", &count) != 1) count = 0;
  if (pipe != nullptr) pclose(pipe);
  return count;
}

// "cfn=(7) name" says which function the next line "calls=N ..." is about; later only "cfn=(7)".
std::uint64_t calls_of(const std::string& function, const std::vector<std::string>& args) {
  const fs::path out = fs::temp_directory_path() / ("planish_calls_" + std::to_string(getpid()));
  const std::string command = under_callgrind(args, out.string()) + " >/dev/null 2>&1";
  if (std::system(command.c_str()) != 0) return 0;
  std::ifstream profile(out);
  std::set<std::string> numbers;  // of the function
  std::uint64_t calls = 0;
  bool is_called = false;
  for (std::string line; std::getline(profile, line);) {
    const auto begin = line.find("fn=("), end = line.find(')');
    if (begin != line.npos && begin <= 1) {
      const std::string number = line.substr(begin + 3, end - begin - 2);
      if (line.compare(end + 1, 1 + function.size(), " " + function) == 0) numbers.insert(number);
      is_called = begin == 1 && numbers.count(number) != 0;
    } else if (is_called && line.starts_with("calls=")) {
      calls += std::stoull(line.substr(6));
    }
  }
  fs::remove(out);
  return calls;
}

Ended run_program(const std::vector<std::string>& args, const Limits& limits,
                  const Standard& standard) {
  const std::string stem =
      (fs::temp_directory_path() / ("planish_fault_" + std::to_string(getpid()))).string();
  const Standard files = {standard.out.empty() ? stem + ".out" : standard.out,
                          standard.err.empty() ? stem + ".err" : standard.err};
  Ended ended = waited_for(start(args, limits, files));
  if (standard.out.empty()) ended.out = content_of(files.out);
  if (standard.err.empty()) ended.err = content_of(files.err);
  fs::remove(stem + ".out");
  fs::remove(stem + ".err");
  return ended;
}

Running::Running(const std::vector<std::string>& args)
    : id_(start(args, {}, {"/dev/null", "/dev/null"})) {}

Running::~Running() {
  if (id_ < 0) return;
  kill(id_, SIGKILL);
  waited_for(id_);
}

void Running::send(int signal) const {
  kill(id_, signal);
}

Ended Running::wait() {
  const Ended ended = waited_for(id_);
  id_ = -1;
  return ended;
}

Files contents(const fs::path& folder) {
  std::map<std::string, std::string> found;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const std::string name = entry.path().lexically_relative(folder).string();
    if (entry.is_symlink()) {
      found[name] = "-> " + fs::read_symlink(entry.path()).string();
    } else if (entry.is_directory()) {
      found[name + "/"] = "";
    } else {
      found[name] = entry.is_regular_file() ? content_of(entry.path()) : "special";
    }
  }
  return found;
}

bool can_limit_memory() {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  return false;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
  return false;
#else
  return true;
#endif
#else
  return true;
#endif
}

}  // namespace planish::fault
