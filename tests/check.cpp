// The test runner: see usage_text below.
#include "check.hpp"

#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <new>
#include <vector>

#include "tiltrotor/model/aircraft/aircraft_data.hpp"

namespace {

const char* const usage_text =
    "usage: run_tests [--list] [--verbose] [--jobs N] [--skip PREFIX] [NAME ...]\n"
    "  NAME           run the tests whose name contains NAME (several: any of them)\n"
    "  --skip PREFIX  leave out the tests whose name begins with PREFIX\n"
    "  --jobs N       share the tests among N processes, at most 64\n"
    "  --list         print the names only; with --verbose also those left out, whose each is and where it stands\n"
    "  --verbose      print each test's name before it runs, and its time\n"
    "exit status: 0 all passed, 1 a test failed, 2 nothing was run\n";

// A check inside a loop would bury the first failure, the one worth reading.
constexpr int max_failures_printed = 10;
constexpr int max_jobs = 64;

struct Test {
  std::string name;
  const char* file;
  int line;
  check::TestFunction function;
  int aircraft;
};

/// In a function, because registrations in other files may run before this file's own initialisers.
std::vector<Test>& all_tests() {
  static std::vector<Test> tests;
  return tests;
}

const char* running_test = "";
int failures_of_running_test = 0;

struct Options {
  bool list = false;
  bool verbose = false;
  int jobs = 1;
  std::vector<std::string> names;
  std::vector<std::string> skipped_prefixes;
};

bool contains(const Test& test, const std::string& name) { return test.name.find(name) != std::string::npos; }

/// Sorts the tests by place and refuses a name that is used twice.
bool sort_tests() {
  std::vector<Test>& tests = all_tests();
  std::sort(tests.begin(), tests.end(), [](const Test& a, const Test& b) { return a.name < b.name; });
  bool unique = true;
  for (std::size_t i = 1; i < tests.size(); ++i) {
    const Test& a = tests[i - 1];
    const Test& b = tests[i];
    if (a.name != b.name) continue;
    std::fprintf(stderr, "run_tests: test %s is defined twice: %s:%d and %s:%d\n", a.name.c_str(), a.file,
                 a.line, b.file, b.line);
    unique = false;
  }
  std::sort(tests.begin(), tests.end(), [](const Test& a, const Test& b) {
    const int order = std::string(a.file).compare(b.file);
    return order != 0 ? order < 0 : a.line < b.line;
  });
  return unique;
}

bool parse(int count, char** arguments, Options& options) {
  for (int i = 1; i < count; ++i) {
    const std::string argument = arguments[i];
    if (argument == "--list") {
      options.list = true;
    } else if (argument == "--verbose") {
      options.verbose = true;
    } else if (argument == "--skip" && i + 1 < count) {
      options.skipped_prefixes.push_back(arguments[++i]);
    } else if (argument == "--jobs" && i + 1 < count) {
      char* end = nullptr;
      const long jobs = std::strtol(arguments[++i], &end, 10);
      if (*end != '\0' || jobs < 1) return false;
      options.jobs = static_cast<int>(std::min<long>(jobs, max_jobs));
    } else if (argument.empty() || argument[0] == '-') {
      return false;
    } else {
      options.names.push_back(argument);
    }
  }
  return true;
}

bool every_name_matches(const Options& options) {
  bool all_match = true;
  for (const std::string& name : options.names) {
    const auto matches = [&](const Test& test) { return contains(test, name); };
    if (std::any_of(all_tests().begin(), all_tests().end(), matches)) continue;
    std::fprintf(stderr, "run_tests: no test name contains '%s' (--list shows them)\n", name.c_str());
    all_match = false;
  }
  return all_match;
}

bool is_selected(const Test& test, const Options& options) {
  const auto named = [&](const std::string& name) { return contains(test, name); };
  const auto skipped = [&](const std::string& prefix) {
    return test.name.compare(0, prefix.size(), prefix) == 0;
  };
  if (std::any_of(options.skipped_prefixes.begin(), options.skipped_prefixes.end(), skipped)) return false;
  return options.names.empty() || std::any_of(options.names.begin(), options.names.end(), named);
}

bool is_of_this_aircraft(const Test& test) {
  return test.aircraft == check::any_aircraft || test.aircraft == tiltrotor::aircraft_identity().id;
}

// Every test with its aircraft, and how many there are of each kind.
void print_table(const std::vector<Test>& tests) {
  int count[2] = {0, 0};
  for (const Test& test : tests) {
    const bool of_any = test.aircraft == check::any_aircraft;
    ++count[of_any ? 0 : 1];
    std::printf("%-9s %s  %s:%d\n", of_any ? "any" : "XV-15", test.name.c_str(), test.file, test.line);
  }
  std::printf("%d of any aircraft, %d of the XV-15\n", count[0], count[1]);
}

bool run(const Test& test, bool verbose) {
  running_test = test.name.c_str();
  failures_of_running_test = 0;
  if (verbose) {
    std::printf("run   %s\n", running_test);
    std::fflush(stdout);
  }
  const auto start = std::chrono::steady_clock::now();
  try {
    test.function();
  } catch (const std::exception& exception) {
    check::report(false, test.file, test.line, "uncaught exception", exception.what());
  } catch (...) {
    check::report(false, test.file, test.line, "uncaught exception", "not a std::exception");
  }
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  const int unprinted = failures_of_running_test - max_failures_printed;
  if (unprinted > 0) std::printf("  and %d more failed checks\n", unprinted);
  if (failures_of_running_test > 0) std::printf("FAIL  %s\n", running_test);
  if (verbose) std::printf("time  %s %.3f s\n", running_test, elapsed.count());
  std::fflush(stdout);
  return failures_of_running_test == 0;
}

/// What the processes that share the tests know of one another: the next test, how those before it ended, and which one
/// each is at.
struct Shared {
  std::atomic<std::size_t> next{0};
  std::atomic<int> passed{0}, failed{0};
  std::atomic<std::size_t> running[max_jobs] = {};
};

void run_share(const std::vector<Test>& tests, bool verbose, Shared& shared, int job) {
  for (std::size_t i; (i = shared.next++) < tests.size();) {
    shared.running[job] = i;
    ++(run(tests[i], verbose) ? shared.passed : shared.failed);
  }
}

/// A test that ends its process counts as one that failed; the others go on.
void await(pid_t process, int job, const std::vector<Test>& tests, Shared& shared) {
  int ended = 0;
  while (waitpid(process, &ended, 0) < 0 && errno == EINTR) {
  }
  if (WIFEXITED(ended) && WEXITSTATUS(ended) == 0) return;
  ++shared.failed;
  std::printf("FAIL  %s\nit ended its process by %s %d\n", tests[shared.running[job]].name.c_str(),
              WIFSIGNALED(ended) ? "signal" : "status",
              WIFSIGNALED(ended) ? WTERMSIG(ended) : WEXITSTATUS(ended));
}

void run_all(const std::vector<Test>& tests, const Options& options, Shared& shared) {
  if (options.jobs == 1) return run_share(tests, options.verbose, shared, 0);
  std::fflush(stdout);
  static char whole_test[1 << 16];  // what a test prints stays together
  setvbuf(stdout, whole_test, _IOFBF, sizeof whole_test);
  std::vector<pid_t> processes;
  for (int job = 0; job < options.jobs; ++job) {
    const pid_t process = fork();
    if (process == 0) {
      run_share(tests, options.verbose, shared, job);
      std::exit(0);
    }
    if (process < 0) break;
    processes.push_back(process);
  }
  int job = 0;
  for (const pid_t process : processes) await(process, job++, tests, shared);
  run_share(tests, options.verbose, shared, 0);  // what no process was left, or could be begun, to run
}

}  // namespace

namespace check {

Registration::Registration(const char* name, const char* file, int line, TestFunction function,
                           int aircraft) {
  all_tests().push_back({name, file, line, function, aircraft});
}

bool report(bool passed, const char* file, int line, const std::string& expression,
            const std::string& values) {
  if (passed) return true;
  ++failures_of_running_test;
  if (failures_of_running_test <= max_failures_printed) {
    std::printf("%s:%d: %s: %s%s%s\n", file, line, running_test, expression.c_str(),
                values.empty() ? "" : ": ", values.c_str());
  }
  return false;
}

void note(const std::string& text) { std::printf("note  %s: %s\n", running_test, text.c_str()); }

}  // namespace check

int main(int count, char** arguments) {
  constexpr int exit_nothing_run = 2;
  Options options;
  if (!parse(count, arguments, options)) {
    std::fputs(usage_text, stderr);
    return exit_nothing_run;
  }
  if (!sort_tests() || !every_name_matches(options)) return exit_nothing_run;
  // A make that a test calls is none of the one that called the tests.
  for (const char* const name : {"MAKEFLAGS", "MFLAGS", "MAKELEVEL"}) unsetenv(name);

  std::vector<Test> selected, left_out;
  for (const Test& test : all_tests())
    if (is_selected(test, options)) (is_of_this_aircraft(test) ? selected : left_out).push_back(test);
  if (options.list && options.verbose) {
    selected.insert(selected.end(), left_out.begin(), left_out.end());
    print_table(selected);
    return 0;
  }
  if (options.verbose)
    for (const Test& test : left_out) std::printf("out   %s\n", test.name.c_str());
  if (selected.empty()) {
    std::fprintf(stderr, "run_tests: there is no test to run%s\n",
                 left_out.empty() ? "" : ": those selected know numbers of the XV-15");
    return exit_nothing_run;
  }
  if (options.list) {
    for (const Test& test : selected) std::printf("%s\n", test.name.c_str());
    return 0;
  }
  void* const memory =
      mmap(nullptr, sizeof(Shared), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) {
    std::fputs("run_tests: no memory to share\n", stderr);
    return exit_nothing_run;
  }
  Shared& shared = *new (memory) Shared;
  run_all(selected, options, shared);
  // One that ended its process as if all was well.
  const int lost = static_cast<int>(selected.size()) - shared.passed - shared.failed;
  if (lost > 0) std::printf("%d tests ended their processes before they ended themselves\n", lost);
  const int failed = shared.failed + std::max(lost, 0);
  std::printf("%d passed, %d failed", shared.passed.load(), failed);
  if (!left_out.empty())
    std::printf(", %d left out: they know numbers of the XV-15, and this is the %s (--verbose names them)",
                static_cast<int>(left_out.size()), tiltrotor::aircraft_identity().name);
  std::printf("\n");
  return failed == 0 ? 0 : 1;
}
