#include <array>
#include <cstdio>
#include <cstdlib>

#include <fcntl.h>
#include <io.h>
#include <objbase.h>
#include <shellapi.h>
#include <windows.h>

#include "platform/windows/wide.h"
#include "shell/host.h"

namespace planish::cli {

namespace {

std::atomic<bool> interrupted = false;

/// The first event asks to stop. For the second one the system's own handler ends the program.
/// Where the window is closed, the system ends it when this returns or after some seconds: until
/// then it may finish. The system calls this on a thread of its own.
BOOL WINAPI on_console_event(DWORD event) {
  constexpr DWORD k_longest = 60'000;  // ms; the system waits less
  const bool is_first = !interrupted.exchange(true);
  if (event != CTRL_C_EVENT && event != CTRL_BREAK_EVENT) Sleep(k_longest);
  return is_first ? TRUE : FALSE;
}

UINT code_page_before = 0;

void put_code_page_back() {
  SetConsoleOutputCP(code_page_before);
}

/// What the program prints is UTF-8. The console keeps its encoding after the program's end, and so
/// gets the old one back.
void print_in_utf8() {
  code_page_before = GetConsoleOutputCP();  // 0 without a console
  if (code_page_before == 0 || code_page_before == CP_UTF8) return;
  SetConsoleOutputCP(CP_UTF8);
  std::atexit(put_code_page_back);
}

bool is_console(DWORD standard_handle) {
  DWORD mode = 0;
  return GetConsoleMode(GetStdHandle(standard_handle), &mode) != 0;
}

/// A text of the registry; empty where it has none.
std::string registry_text(const wchar_t* key, const wchar_t* name) {
  std::array<wchar_t, 256> text = {};
  DWORD bytes = sizeof text;
  const LSTATUS status =
      RegGetValueW(HKEY_LOCAL_MACHINE, key, name, RRF_RT_REG_SZ, nullptr, text.data(), &bytes);
  return status == ERROR_SUCCESS ? utf8_of_wide(text.data()) : std::string();
}

}  // namespace

RunContext prepare_process() {
  _setmode(_fileno(stdout), _O_BINARY);
  _setmode(_fileno(stderr), _O_BINARY);
  SetErrorMode(
      SEM_FAILCRITICALERRORS);  // an empty drive is an error and not a question in a window
  print_in_utf8();
  SetConsoleCtrlHandler(on_console_event, TRUE);
  return {.err_is_terminal = is_console(STD_ERROR_HANDLE),
          .interrupted = &interrupted,
          .open_document = open_document,
          .system_facts = system_facts};
}

std::vector<std::string> command_words(int, char**) {
  int count = 0;
  wchar_t** const words = CommandLineToArgvW(GetCommandLineW(), &count);
  std::vector<std::string> texts;
  for (int w = 1; w < count; ++w)
    texts.push_back(utf8_of_wide(words[w]));
  LocalFree(static_cast<void*>(words));
  return texts;
}

SystemFacts system_facts() {
  const wchar_t* const system = L"SOFTWARE\\Microsoft\\Windows NT\\CurrentVersion";
  SystemFacts facts;
  facts.name = registry_text(system, L"ProductName") + ", build " +
               registry_text(system, L"CurrentBuild") + ", x86_64";
  facts.processor =
      registry_text(L"HARDWARE\\DESCRIPTION\\System\\CentralProcessor\\0", L"ProcessorNameString");
  facts.document_opener = "Windows";  // ShellExecuteEx() is always there
  return facts;
}

std::string open_document(const std::filesystem::path& path) {
  // The shell may hand the file to a program by COM. It gets the name with backslashes, as a URL
  // otherwise might be seen in it.
  const bool has_com = SUCCEEDED(CoInitializeEx(nullptr, COINIT_APARTMENTTHREADED));
  const std::wstring name = std::filesystem::path(path).make_preferred().native();
  SHELLEXECUTEINFOW document = {};
  document.cbSize = sizeof document;
  document.fMask = SEE_MASK_FLAG_NO_UI | SEE_MASK_NOASYNC;  // no questions; this program ends next
  document.lpVerb = L"open";
  document.lpFile = name.c_str();
  document.nShow = SW_SHOWNORMAL;
  const bool is_open = ShellExecuteExW(&document) != 0;
  const DWORD error = GetLastError();
  if (has_com) CoUninitialize();
  if (is_open) return {};
  return error == ERROR_NO_ASSOCIATION ? "Windows knows no program for such files"
                                       : "Windows error " + std::to_string(error);
}

bool has_own_window() {
  std::array<DWORD, 2> processes = {};
  const DWORD count = GetConsoleProcessList(processes.data(), static_cast<DWORD>(processes.size()));
  STARTUPINFOW start = {};
  GetStartupInfoW(&start);  // another program that reads what this one prints gave it the streams
  return count == 1 && (start.dwFlags & STARTF_USESTDHANDLES) == 0;
}

void end_at_once(std::string_view message, int exit_code) noexcept {
  DWORD written = 0;
  WriteFile(GetStdHandle(STD_ERROR_HANDLE), message.data(), static_cast<DWORD>(message.size()),
            &written, nullptr);
  if (code_page_before != 0) put_code_page_back();
  TerminateProcess(GetCurrentProcess(), static_cast<UINT>(exit_code));
  std::abort();  // not reached
}

}  // namespace planish::cli
