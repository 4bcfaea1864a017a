# tiltrotor: everything is built below $(BUILD); `make help` lists the goals.
#
# Variables:  CXX, CXXFLAGS, LDFLAGS   the usual ones                     (CXXFLAGS=-O3)
#             ARCH=native              value of -march; empty: portable code
#             CROSS_COMPILE=           tool prefix, for example aarch64-linux-gnu-
#             TARGET=                  cortex-m7 or cortex-m4f: no operating system, libraries only
#             RUNNER=                  starts a program of another machine; found for the usual CROSS_COMPILE
#             PRECISION=single         tr_real of the C interface is float
#             HOST_CXX, HOST_CXXFLAGS  compiler of the table generator, which runs on this machine
#             AIRCRAFT=xv15            folder below tables/ that is compiled in
#             BUILD=build              give each variant (sanitizers, clang, cross) its own
#             TESTS=                   arguments of the test runner: names to select, --skip, --verbose
#             WERROR=1                 warnings are errors
#             V=1                      show complete commands
#             PREFIX, DESTDIR          where `make install` copies to

VERSION  := 0.1.0
AIRCRAFT ?= xv15
BUILD    ?= build
PREFIX   ?= /usr/local

# ---- tools and flags ----

CROSS_COMPILE ?=
# Make's built-in values would win over ?=, hence the question where they come from.
ifeq ($(origin CXX),default)
CXX := $(CROSS_COMPILE)g++
endif
ifeq ($(origin CC),default)
CC := $(CROSS_COMPILE)gcc
endif
ifeq ($(origin AR),default)
AR := $(CROSS_COMPILE)ar
endif
HOST_CXX     ?= $(if $(CROSS_COMPILE),g++,$(CXX))
CLANG_FORMAT ?= clang-format

# "native" means this machine: wrong for a cross compiler, and some compilers do not know the word.
ARCH       ?= $(if $(CROSS_COMPILE),,native)
accepts     = $(shell $(CXX) $(1) -E -x c++ /dev/null >/dev/null 2>&1 && echo $(1))
ARCH_FLAGS := $(if $(filter native,$(ARCH)),$(call accepts,-march=native),$(ARCH:%=-march=%))
TARGET_cortex-m7  := -mcpu=cortex-m7 -mthumb -mfpu=fpv5-d16 -mfloat-abi=hard -ffunction-sections -fdata-sections
TARGET_cortex-m4f := -mcpu=cortex-m4 -mthumb -mfpu=fpv4-sp-d16 -mfloat-abi=hard -ffunction-sections -fdata-sections
ARCH_FLAGS += $(TARGET_$(TARGET))
# aarch64-linux-gnu- is run by qemu-aarch64, arm-linux-gnueabihf- by qemu-arm, when installed.
MACHINE := $(firstword $(subst -, ,$(CROSS_COMPILE)))
RUNNER  ?= $(if $(and $(findstring linux,$(CROSS_COMPILE)),$(shell command -v qemu-$(MACHINE))),\
             qemu-$(MACHINE) -L /usr/$(CROSS_COMPILE:%-=%))

CXXFLAGS      ?= -O3
HOST_CXXFLAGS ?= -O1
WARNINGS      := -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wdouble-promotion -Wno-psabi $(if $(WERROR),-Werror)
# -ffp-contract=off: a fused multiply-add rounds once instead of twice, and the compiler fuses differently in scalar
#   and in vector code. Without fusing, the value of a plain evaluation and the value part of a dual number are equal
#   bit for bit, on every machine.
# -fno-tree-slp-vectorize: g++ 12 forms fused multiply-adds there in spite of the flag above.
# -Wno-psabi: on 32-bit ARM g++ notes at every std::vector that its ABI changed with version 7.
# -fno-math-errno: nobody reads errno after sqrt(); setting it costs a branch per call and stops vectorisation.
FLAGS      := -std=c++17 $(CXXFLAGS) $(ARCH_FLAGS) -ffp-contract=off -fno-tree-slp-vectorize -fno-math-errno \
              $(WARNINGS) -Iinclude
HOST_FLAGS := -std=c++17 $(HOST_CXXFLAGS) $(WARNINGS) -Iinclude -Isrc
FLAGS      += $(if $(filter single,$(PRECISION)),-DTR_SINGLE_PRECISION)
CORE_FLAGS := -fno-exceptions -fno-rtti
# The numbers are made in the library; the program around it need not be fast, but quick to build.
PROGRAM_FLAGS := $(if $(filter -O3,$(CXXFLAGS)),-O1)
ND_FLAGS   := -DTILTROTOR_NUMERICAL_DIFFERENCES=1
PRIVATE    := -Isrc -I$(BUILD)/generated -DTILTROTOR_VERSION=\"$(VERSION)\"
TEST_FLAGS := -Itests '-DTILTROTOR_SOURCE_DIR="$(CURDIR)"' '-DTILTROTOR_BINARY_DIR="$(abspath $(BUILD))"' \
              '-DTILTROTOR_RUNNER="$(strip $(RUNNER))"'
DEPENDENCIES := -MMD -MP

# ---- what there is ----

find = $(sort $(shell find $(1) -name '$(2)' 2>/dev/null))

HEADERS         := $(call find,include,*.h) $(call find,include,*.hpp)
TABLES          := $(call find,tables/$(AIRCRAFT),*.csv)
PUBLISHED       := $(call find,tests/validation,*.csv)
TABLEGEN_SOURCE := $(call find,src/tablegen,*.cpp)
LIBRARY_SOURCE  := $(call find,src/library,*.cpp)
PROGRAM_SOURCE  := $(call find,src/cli,*.cpp) $(call find,src/report,*.cpp)
TEST_SOURCE     := $(wildcard tests/check.cpp) $(call find,tests,test_*.cpp)
BENCH_SOURCE    := $(wildcard bench/*.cpp)

TABLEGEN_OBJECTS   := $(TABLEGEN_SOURCE:src/%.cpp=$(BUILD)/host/%.o)
LIBRARY_OBJECTS    := $(LIBRARY_SOURCE:src/%.cpp=$(BUILD)/ad/%.o)
# The instances name their policy and the tables have none: these are compiled once, for both libraries.
COMMON_SOURCE      := $(filter %/aircraft_data.cpp %/analysis_double.cpp %/analysis_float.cpp,$(LIBRARY_SOURCE))
COMMON_OBJECTS     := $(COMMON_SOURCE:src/%.cpp=$(BUILD)/ad/%.o)
LIBRARY_ND_OBJECTS := $(COMMON_OBJECTS) $(patsubst src/%.cpp,$(BUILD)/nd/%.o,$(filter-out $(COMMON_SOURCE),$(LIBRARY_SOURCE)))
PROGRAM_OBJECTS    := $(PROGRAM_SOURCE:src/%.cpp=$(BUILD)/program/%.o)
TEST_OBJECTS       := $(TEST_SOURCE:tests/%.cpp=$(BUILD)/tests/%.o)
BENCH_OBJECTS      := $(BENCH_SOURCE:bench/%.cpp=$(BUILD)/bench/%.o)
OBJECTS            := $(TABLEGEN_OBJECTS) $(sort $(LIBRARY_OBJECTS) $(LIBRARY_ND_OBJECTS)) $(PROGRAM_OBJECTS) \
                      $(TEST_OBJECTS) $(BENCH_OBJECTS)

GENERATED  := $(if $(TABLEGEN_SOURCE),$(BUILD)/generated/aircraft_tables.inc) $(BUILD)/generated/reference_points.inc \
              $(BUILD)/generated/identity.inc
# Everything of the program but main(): tests look into it.
PROGRAM_PARTS := $(filter-out %/main.o,$(PROGRAM_OBJECTS))
LIBRARIES  := $(BUILD)/libtiltrotor.a $(BUILD)/libtiltrotor-nd.a
PROGRAMS   := $(if $(TARGET),,$(if $(PROGRAM_SOURCE),$(BUILD)/tiltrotor $(BUILD)/tiltrotor-nd))
BENCHMARKS := $(BENCH_SOURCE:bench/%.cpp=$(BUILD)/bench_%)

# ---- goals ----

.PHONY: all run validate test test-cross bench headers format install clean help FORCE
.DELETE_ON_ERROR:
Q := $(if $(V),,@)

all: $(LIBRARIES) $(PROGRAMS) ## build both libraries and both programs (the default)

run: all ## run the whole study; figures and numbers go to build/report
	$(Q)$(BUILD)/tiltrotor report
	@echo "$(CURDIR)/build/report/index.html"

validate: all ## every number against its published one, the worst first; fails where the list of known exceedances is not true
	$(Q)$(BUILD)/tiltrotor report --validate

test: all $(BUILD)/run_tests ## build and run every test, or TESTS="name ..."
	$(Q)$(RUNNER) $(BUILD)/run_tests $(TESTS)

test-cross: $(BUILD)/reference_flight ## test on other machines, emulated: the same tests, and the reference flight bit for bit
	$(Q)$(BUILD)/reference_flight >$(BUILD)/reference_flight.txt
	+$(Q)set -e; for tools in $(CROSS_TOOLS); do \
	  tests/tool.sh "test-cross $$tools" $$tools-g++ g++-$$tools qemu-$${tools%%-*} qemu-user || continue; \
	  $(MAKE) CROSS_COMPILE=$$tools- BUILD=$(BUILD)/$$tools CXXFLAGS=-O1 $(BUILD)/$$tools/reference_flight test; \
	  qemu-$${tools%%-*} -L /usr/$$tools $(BUILD)/$$tools/reference_flight | cmp - $(BUILD)/reference_flight.txt; \
	  echo "$$tools: the reference flight is that of this machine, bit for bit"; done
CROSS_TOOLS ?= aarch64-linux-gnu riscv64-linux-gnu arm-linux-gnueabihf

headers: $(HEADERS:%=alone/%) ## compile every public header alone, warnings are errors

format: ## lay out every source with clang-format
	$(Q)if tests/tool.sh format $(CLANG_FORMAT) clang-format; then \
	  find include src tests bench -name '*.[ch]pp' -o -name '*.h' | xargs $(CLANG_FORMAT) $(FORMAT_FLAGS); fi
FORMAT_FLAGS ?= -i

install: all ## copy headers, libraries, program and pkg-config file to DESTDIR/PREFIX
	$(Q)set -e; to='$(DESTDIR)$(PREFIX)'; \
	install -d "$$to/bin" "$$to/lib/pkgconfig"; \
	for header in $(HEADERS); do \
	  install -d "$$to/$$(dirname $$header)"; install -m 644 $$header "$$to/$$header"; done; \
	install -m 644 $(LIBRARIES) "$$to/lib"; \
	install -m 755 $(BUILD)/tiltrotor "$$to/bin"; \
	printf '%s\n' 'prefix=$(abspath $(PREFIX))' 'includedir=$${prefix}/include' 'libdir=$${prefix}/lib' '' \
	  'Name: tiltrotor' 'Description: Tilt-rotor flight mechanics with exact derivatives' \
	  'Version: $(VERSION)' 'Cflags: -I$${includedir} $(strip $(ARCH_FLAGS) $(if $(filter single,$(PRECISION)),-DTR_SINGLE_PRECISION))' 'Libs: -L$${libdir} -ltiltrotor -lm' \
	  > "$$to/lib/pkgconfig/tiltrotor.pc"

clean: ## remove the build directory
	rm -rf '$(BUILD)'

# Goals by what they are for; "use" is all the others.
HELP_check   := test test-cross trace envelope fuzz coverage mutate headers lint format
HELP_measure := bench bench-peers bench-instructions
HELP_target  := hash firmware test-firmware budget
help: ## list the goals
	@sed -n 's/^\([a-z-]*\):.*## \(.*\)/\1 \2/p' $(filter-out %.d,$(MAKEFILE_LIST)) | \
	  awk -v check='$(HELP_check)' -v measure='$(HELP_measure)' -v target='$(HELP_target)' ' \
	    function assign(group, goals,    n, i, goal) { \
	      for (n = split(goals, goal, " "); i++ < n;) group_of[goal[i]] = group } \
	    BEGIN { assign("check", check); assign("measure", measure); assign("target", target) } \
	    { goal = $$1; sub(/^[^ ]* /, ""); group = goal in group_of ? group_of[goal] : "use"; \
	      lines[group] = lines[group] sprintf("  %-19s %s\n", goal, $$0) } \
	    END { for (n = split("use check measure target", name, " "); k++ < n;) \
	            printf "%s\n%s", name[k], lines[name[k]] }'

include bench/bench.mk

# ---- stamps: files that change when what they record changes, so that a new flag or a removed source rebuilds ----

STAMP_flags   := $(CXX) $(shell $(CXX) --version 2>/dev/null | head -n 1) $(FLAGS) $(CORE_FLAGS) $(PRIVATE)
STAMP_host    := $(HOST_CXX) $(HOST_FLAGS)
STAMP_tables  := $(TABLES) $(PUBLISHED)
STAMP_sources := $(AR) $(LDFLAGS) $(LDLIBS) $(OBJECTS)

$(BUILD)/flags.stamp $(BUILD)/host.stamp $(BUILD)/tables.stamp $(BUILD)/sources.stamp: $(BUILD)/%.stamp: FORCE
	@mkdir -p $(@D)
	@printf '%s\n' '$(STAMP_$*)' | cmp -s - $@ || printf '%s\n' '$(STAMP_$*)' > $@

# What every output names: aircraft and commit, the latter empty outside a git tree and with a + where files differ from
# it. One small source includes it, so that a commit rebuilds nothing else.
COMMIT   := $(shell test "$$(git rev-parse --show-toplevel 2>/dev/null)" = "$$(pwd -P)" && \
              GIT_OPTIONAL_LOCKS=0 git describe --always --abbrev=12 --exclude='*' --dirty=+ 2>/dev/null)
IDENTITY := "$(AIRCRAFT)", "$(COMMIT)"
$(BUILD)/generated/identity.inc: FORCE
	@mkdir -p $(@D)
	@printf '%s\n' '$(IDENTITY)' | cmp -s - $@ || printf '%s\n' '$(IDENTITY)' > $@

# ---- the aircraft, as constant arrays ----

link = @echo "  link    $@"; mkdir -p $(@D)

$(BUILD)/tablegen: $(TABLEGEN_OBJECTS)
	$(link)
	$(Q)$(HOST_CXX) $(HOST_FLAGS) $(TABLEGEN_OBJECTS) -o $@

# Written beside its place and moved there only when complete.
$(BUILD)/generated/aircraft_tables.inc: $(BUILD)/tablegen $(TABLES) $(BUILD)/tables.stamp
	@echo "  tables  tables/$(AIRCRAFT)"; mkdir -p $(@D)
	$(Q)$(BUILD)/tablegen tables/$(AIRCRAFT) $@.part && mv $@.part $@ || { rm -f $@.part; exit 1; }

# Published numbers that the report lays over its curves, as text inside the program: it runs without the source tree.
$(BUILD)/generated/reference_points.inc: $(PUBLISHED) $(BUILD)/tables.stamp
	@echo "  points  tests/validation"; mkdir -p $(@D)
	$(Q)for set in $(PUBLISHED); do \
	  printf '{"%s", R"csv(' "$$(basename "$$set" .csv)" && cat "$$set" && printf ')csv"},\n' || exit 1; \
	done > $@.part && mv $@.part $@

# ---- libraries and programs ----

$(BUILD)/libtiltrotor.a: $(LIBRARY_OBJECTS)
$(BUILD)/libtiltrotor-nd.a: $(LIBRARY_ND_OBJECTS)
$(LIBRARIES): $(BUILD)/sources.stamp
	@echo "  archive $@"; rm -f $@
	$(Q)$(AR) rcs $@ $(filter %.o,$^)

$(BUILD)/tiltrotor: $(PROGRAM_OBJECTS) $(BUILD)/libtiltrotor.a
$(BUILD)/tiltrotor-nd: $(PROGRAM_OBJECTS) $(BUILD)/libtiltrotor-nd.a
$(BUILD)/run_tests: $(TEST_OBJECTS) $(PROGRAM_PARTS) $(BUILD)/libtiltrotor.a
$(BENCHMARKS): $(BUILD)/bench_%: $(BUILD)/bench/%.o $(BUILD)/libtiltrotor.a
$(BUILD)/tiltrotor $(BUILD)/tiltrotor-nd $(BUILD)/run_tests $(BENCHMARKS): $(BUILD)/sources.stamp
	$(link)
	$(Q)$(CXX) $(FLAGS) $(LDFLAGS) $(filter %.o %.a,$^) $(LDLIBS) -o $@

# ---- objects ----

# $(call compile,FLAGS,REMARK)
define compile
	@echo "  compile $<$(if $(2), ($(2)))"; mkdir -p $(@D)
	$(Q)$(CXX) $(FLAGS) $(PRIVATE) $(1) $(DEPENDENCIES) -c $< -o $@
endef

# The generated tables must exist before the first compilation; from then on the dependency files know who reads them.
$(sort $(LIBRARY_OBJECTS) $(LIBRARY_ND_OBJECTS)) $(PROGRAM_OBJECTS) $(TEST_OBJECTS) $(BENCH_OBJECTS): \
  $(BUILD)/flags.stamp | $(GENERATED)

$(BUILD)/ad/%.o: src/%.cpp
	$(call compile,$(CORE_FLAGS))

$(BUILD)/nd/%.o: src/%.cpp
	$(call compile,$(CORE_FLAGS) $(ND_FLAGS),numerical differences)

$(BUILD)/program/%.o: src/%.cpp
	$(call compile,$(PROGRAM_FLAGS))

$(BUILD)/tests/%.o: tests/%.cpp
	$(call compile,$(TEST_FLAGS))

$(BUILD)/bench/%.o: bench/%.cpp
	$(call compile,$(BENCH_FLAGS))

$(BUILD)/host/%.o: src/%.cpp $(BUILD)/host.stamp
	@echo "  compile $< (host)"; mkdir -p $(@D)
	$(Q)$(HOST_CXX) $(HOST_FLAGS) $(DEPENDENCIES) -c $< -o $@

include src/firmware/firmware.mk src/examples/examples.mk tests/budget/budget.mk tests/verification.mk

# A header that needs another one included first is broken; C headers must also please a C99 compiler.
.PHONY: $(HEADERS:%=alone/%)
$(HEADERS:%=alone/%): alone/include/%:
	@echo "  header  $*"
	$(Q)echo '#include "$*"' | $(CXX) $(FLAGS) $(CORE_FLAGS) -Werror -fsyntax-only -x c++ -
	$(if $(filter %.h,$*),$(Q)echo '#include "$*"' | \
	  $(CC) -std=c99 -Wall -Wextra -Wpedantic -Werror -Iinclude -fsyntax-only -x c -)

-include $(OBJECTS:.o=.d)
