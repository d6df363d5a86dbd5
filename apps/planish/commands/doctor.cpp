// What a bug report has to say of the program and the machine.

#include <filesystem>
#include <random>
#include <string>
#include <vector>

#include <planish/core/error.h>
#include <planish/core/version.h>
#include <planish/io/write_file.h>

#include <planish_json/json.h>

#include "commands/commands.h"
#include "core/simd/isa.h"
#include "platform/memory.h"
#include "platform/path.h"
#include "platform/processors.h"
#include "report/page/page_assets.h"
#include "shell/session.h"
#include "shell/text.h"

namespace planish::cli {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t k_column = 12;

/// Whether files can be written into a folder.
bool can_be_written(const fs::path& folder) {
  // A name that no file of the user has.
  const fs::path file =
      folder / path_of("planish-doctor-" + std::to_string(std::random_device()()));
  try {
    write_files(std::vector<OutputFile>{{file, ""}});
  } catch (const Error&) {
    return false;
  }
  std::error_code ignored;
  fs::remove(file, ignored);
  return true;
}

struct Folder {
  std::string path;  ///< empty where there is none
  bool writable = false;
};

Folder examined(const fs::path& folder, const std::error_code& fault) {
  if (fault) return {};
  return {utf8_of(folder), can_be_written(folder)};
}

struct Findings {
  SystemFacts system = {};
  std::string build = PLANISH_BUILD;
  std::vector<std::string> features = {};
  std::string lanes{to_string(best_isa())};
  unsigned processors = usable_processors();
  std::size_t memory = available_memory();
  Folder temporary = {};
  Folder current = {};
  bool has_page_script = page_script().is_there();
  std::vector<std::string> missing = {};
};

std::vector<std::string> missing_in(const Findings& findings) {
  std::vector<std::string> missing;
  if (!findings.has_page_script)
    missing.emplace_back("the 3D view of reports: the program was built without Node.js");
  if (findings.system.document_opener.empty())
    missing.emplace_back("what --open starts: on Linux install xdg-utils");
  if (!findings.temporary.writable) missing.emplace_back("a temporary folder that can be written");
  if (!findings.current.writable) missing.emplace_back("leave to write into the current folder");
  return missing;
}

Findings examine(const Session& session) {
  Findings findings = {.system = session.system_facts()};
  for (const std::string_view feature : processor_features())
    findings.features.emplace_back(feature);
  std::error_code fault;
  const fs::path temporary = fs::temp_directory_path(fault);
  findings.temporary = examined(temporary, fault);
  const fs::path current = fs::current_path(fault);
  findings.current = examined(current, fault);
  findings.missing = missing_in(findings);
  return findings;
}

std::string in_words(const std::vector<std::string>& words, const std::string& separator) {
  std::string text;
  for (const std::string& word : words)
    text += (text.empty() ? "" : separator) + word;
  return text;
}

std::string memory_text(std::size_t bytes) {
  constexpr double gibibyte = 1024.0 * 1024.0 * 1024.0;
  return bytes == 0 ? "not known"
                    : fixed(static_cast<double>(bytes) / gibibyte, 1) + " GiB available";
}

std::string folder_text(const Folder& folder) {
  if (folder.path.empty()) return "none";
  return folder.path + (folder.writable ? "" : " (cannot be written)");
}

std::string text_of(const Findings& findings) {
  const auto line = [](const std::string& name, const std::string& value) {
    return left(name, k_column) + value + "\n";
  };
  const std::string processor =
      findings.system.processor.empty() ? "not known" : findings.system.processor;
  const std::string features =
      findings.features.empty() ? "" : " (" + in_words(findings.features, " ") + ")";
  std::string text =
      line("planish", k_version) + line("build", findings.build) +
      line("system", findings.system.name) + line("processor", processor + features) +
      line("lanes", findings.lanes) + line("threads", std::to_string(findings.processors)) +
      line("memory", memory_text(findings.memory)) +
      line("temporary", folder_text(findings.temporary)) +
      line("current", folder_text(findings.current)) +
      line("3D view", findings.has_page_script ? "in the build" : "missing") +
      line("--open",
           findings.system.document_opener.empty() ? "missing" : findings.system.document_opener);
  return text +
         line("missing", findings.missing.empty() ? "nothing" : in_words(findings.missing, "; "));
}

std::string json_of(const Findings& findings) {
  const auto or_null = [](const std::string& text) {
    return text.empty() ? Json(nullptr) : Json(text);
  };
  const auto folder_json = [&](const Folder& folder) {
    return Json{{"path", or_null(folder.path)}, {"writable", folder.writable}};
  };
  return json_document(
      {{"version", std::string(k_version)},
       {"build", findings.build},
       {"system", findings.system.name},
       {"processor",
        {{"name", or_null(findings.system.processor)}, {"features", findings.features}}},
       {"lanes", findings.lanes},
       {"threads", findings.processors},
       {"memory_available", findings.memory == 0 ? Json(nullptr) : Json(findings.memory)},
       {"temporary_folder", folder_json(findings.temporary)},
       {"current_folder", folder_json(findings.current)},
       {"page_script", findings.has_page_script},
       {"document_opener", or_null(findings.system.document_opener)},
       {"missing", findings.missing}});
}

CommandResult run_doctor(const Arguments&, Session& session) {
  const Findings findings = examine(session);
  return {text_of(findings), json_of(findings)};
}

}  // namespace

Command doctor_command() {
  return {"doctor",
          "print what a bug report needs about program and machine",
          "",
          "Prints version, build, processor, threads, memory, folders and what is missing, in some "
          "ten lines for a bug report. Sends nothing anywhere. Writes an empty file into the "
          "temporary folder and the current folder, and removes it at once.",
          {},
          {},
          {"planish doctor"},
          run_doctor};
}

}  // namespace planish::cli
