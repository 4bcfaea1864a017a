# tiltrotor: everything is built below $(BUILD); `make help` lists the goals.
#
# Variables:  CXX, CXXFLAGS, LDFLAGS   the usual ones                     (CXXFLAGS=-O3)
#             ARCH=native              value of -march; empty: portable code, which `make install` copies unless ARCH is given
#             CROSS_COMPILE=           tool prefix, for example aarch64-linux-gnu-
#             TARGET=                  cortex-m7 or cortex-m4f: no operating system, libraries only, in build/TARGET
#             RUNNER=                  starts a program of another machine; found for the usual CROSS_COMPILE
#             PRECISION=double         or single: tr_real of the C interface is float
#             SLOPES=double            or single: slopes of the airframe's large tables, 55 KB less; the firmware's
#             HOST_CXX, HOST_CXXFLAGS  compiler of the table generator, which runs on this machine
#             AIRCRAFT=xv15            folder below tables/ that is compiled in: xv15, scaled_xv15 or one of your own
#             BUILD=build              give each variant (sanitizers, clang, cross) its own
#             TESTS=                   arguments of the test runner: names to select, --skip, --verbose
#             PRECOMPILED=yes          or no: one header compiled once for the program and the tests; no with ccache
#             WERROR=1                 warnings are errors
#             V=1                      show complete commands
#             PREFIX, DESTDIR          where `make install` copies to

VERSION  := 0.2.0
AIRCRAFT ?= xv15
TARGET   ?=
BUILD    ?= build$(TARGET:%=/%)
PREFIX   ?= /usr/local
DESTDIR  ?=
PRECISION ?= double
SLOPES   ?= double
TESTS    ?=
WERROR   ?=
V        ?=

# On every core unless told otherwise (make -j1): a given -j wins over this one.
CORES := $(shell nproc 2>/dev/null || getconf _NPROCESSORS_ONLN)
ifeq ($(MAKELEVEL),0)
MAKEFLAGS += -j$(or $(CORES),1)
endif
ifneq ($(filter clean,$(MAKECMDGOALS)),)
.NOTPARALLEL:
endif

# $(call one_of,NAME,VALUES): what is no value of the list is refused
one_of = $(if $(and $(filter 1,$(words $($(1)))),$(filter $(2),$($(1)))),,$(error $(1)=$($(1)) is none of: $(2)))
$(call one_of,PRECISION,double single)
$(call one_of,SLOPES,double single)
DEFINED := $(if $(filter single,$(PRECISION)),TR_SINGLE_PRECISION) $(if $(filter single,$(SLOPES)),TILTROTOR_SINGLE_SLOPES)
$(if $(TARGET),$(call one_of,TARGET,cortex-m7 cortex-m4f))
$(call one_of,AIRCRAFT,$(patsubst tables/%/identity.csv,%,$(wildcard tables/*/identity.csv)))
$(if $(WERROR),$(call one_of,WERROR,1))
$(if $(V),$(call one_of,V,1))
# $(call folder,NAME,FOLDER): what is no place for what is built is refused
folder = $(call refused,$(shell tests/folder.sh $(1) '$(subst ','\'',$(2))'))
refused = $(if $(1),$(error $(1)))
$(call folder,BUILD,$(BUILD))
# Those of `make install`: the environment may hold another PREFIX.
ifneq ($(filter install,$(MAKECMDGOALS)),)
$(call folder,PREFIX,$(PREFIX))
$(if $(DESTDIR),$(call folder,DESTDIR,$(DESTDIR)))
endif
ifneq ($(TARGET),)
NO_SYSTEM := $(filter run validate test test-cross bench bench-instructions hash envelope examples trace,$(MAKECMDGOALS))
$(call refused,$(if $(NO_SYSTEM),TARGET=$(TARGET) has libraries alone: $(NO_SYSTEM) is for machines with an operating system))
endif

# ---- tools and flags ----

CROSS_COMPILE ?= $(if $(TARGET),arm-none-eabi-)
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

$(foreach name,CXX CC AR HOST_CXX,$(if $(strip $($(name))),,$(error $(name) is empty: name a program)))

# "native" means this machine: wrong for a cross compiler, and some compilers do not know the word.
PORTABLE_INSTALL := $(if $(filter undefined,$(origin ARCH)),$(if $(CROSS_COMPILE),,yes))
ARCH       ?= $(if $(CROSS_COMPILE),,native)
accepts     = $(shell $(CXX) $(1) -E -x c++ /dev/null >/dev/null 2>&1 && echo $(1))
$(if $(filter-out native,$(ARCH)),$(if $(call accepts,-march=$(ARCH)),,$(error ARCH='$(ARCH)' is no -march of $(CXX))))
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
# -fno-tree-slp-vectorize: g++ 12 forms fused multiply-adds there in spite of the flag above; clang does not, and needs it.
# -Wno-psabi: on 32-bit ARM g++ notes at every std::vector that its ABI changed with version 7.
# -fno-math-errno: nobody reads errno after sqrt(); setting it costs a branch per call and stops vectorisation.
SLP        := $(or $(call accepts,-fslp-vectorize),-fno-tree-slp-vectorize)
FLAGS       = -std=c++17 $(CPPFLAGS) $(CXXFLAGS) $(ARCH_FLAGS) -ffp-contract=off $(SLP) -fno-math-errno \
              $(WARNINGS) -Iinclude
HOST_FLAGS := -std=c++17 $(HOST_CXXFLAGS) -ffp-contract=off -fno-tree-slp-vectorize $(WARNINGS) -Iinclude -Isrc
FLAGS      += $(DEFINED:%=-D%)
CORE_FLAGS := -fno-exceptions -fno-rtti
# The functions behind the C interface live in a namespace of their own and are hidden: the linker keeps one of several
# equal inline functions, and that of a program that includes the headers may be compiled with any flags.
# One set of objects for the archive and the shared library.
LIBRARY_FLAGS = $(CORE_FLAGS) -Dtiltrotor=tiltrotor_library_$(PRECISION) -fvisibility=hidden $(if $(TARGET),,-fPIC)
# The numbers are made in the library; the program and the tests around it need not be fast, but quick to build.
PROGRAM_FLAGS := $(if $(filter -O3,$(CXXFLAGS)),-O1)
ND_FLAGS   := -DTILTROTOR_NUMERICAL_DIFFERENCES=1
EXTERN     := -DTILTROTOR_EXTERN_INSTANCES
PRIVATE    := -Isrc -I$(BUILD)/generated -DTILTROTOR_VERSION=\"$(VERSION)\"
TEST_FLAGS := -Itests '-DTILTROTOR_SOURCE_DIR="$(CURDIR)"' '-DTILTROTOR_BINARY_DIR="$(abspath $(BUILD))"' \
              '-DTILTROTOR_RUNNER="$(strip $(RUNNER))"' '-DTILTROTOR_CXX="$(CXX)"' '-DTILTROTOR_CROSS="$(CROSS_COMPILE)"'
DEPENDENCIES := -MMD -MP

# ---- what there is ----

find = $(sort $(shell find $(1) -name '$(2)' 2>/dev/null))

HEADERS         := $(call find,include,*.h) $(call find,include,*.hpp)
PUBLISHED       := $(call find,tables/$(AIRCRAFT)/published,*.csv)
# Some aircraft are made from another one, by make.sh of their folder.
MADE_TABLES     := $(if $(wildcard tables/$(AIRCRAFT)/make.sh),$(BUILD)/tables/$(AIRCRAFT))
TABLES          := $(filter-out $(PUBLISHED),$(call find,tables/$(AIRCRAFT),*.csv)) $(MADE_TABLES:%=%/identity.csv)
TABLEGEN_SOURCE := $(call find,src/tablegen,*.cpp)
LIBRARY_SOURCE  := $(call find,src/library,*.cpp)
PROGRAM_SOURCE  := $(call find,src/pilot src/text src/plot src/study src/cli,*.cpp)
TEST_SOURCE     := $(wildcard tests/check.cpp) $(call find,tests,test_*.cpp)
BENCH_SOURCE    := $(wildcard bench/*.cpp)

TABLEGEN_OBJECTS   := $(TABLEGEN_SOURCE:src/%.cpp=$(BUILD)/host/%.o)
# Behind the C interface, and what the program and the tests compile of the headers. The tables have no policy of
# differentiation and the instances name theirs: these are compiled once for both.
C_SOURCE           := $(filter %/aircraft_data.cpp,$(LIBRARY_SOURCE)) $(filter src/library/c_%.cpp,$(LIBRARY_SOURCE))
AIRCRAFT_OBJECT    := $(BUILD)/cpp/library/headers_aircraft.o
C2_OBJECT          := $(BUILD)/cpp/library/headers_c2_aircraft.o
COMMON_OBJECTS     := $(patsubst %,$(BUILD)/cpp/library/%.o,analysis_double analysis_model analysis_moved analysis_systems \
                        analysis_motion analysis_closed_loop analysis_vehicle_outputs c_processor c_compiled) $(AIRCRAFT_OBJECT) $(C2_OBJECT)
C_OBJECTS          := $(C_SOURCE:src/%.cpp=$(BUILD)/ad/%.o)
LIBRARY_OBJECTS    := $(C_OBJECTS) $(AIRCRAFT_OBJECT)
LIBRARY_ND_OBJECTS := $(BUILD)/ad/library/aircraft_data.o $(AIRCRAFT_OBJECT) \
                      $(patsubst src/%.cpp,$(BUILD)/nd/%.o,$(filter src/library/c_%.cpp,$(C_SOURCE)))
FLOAT_OBJECT       := $(BUILD)/cpp/library/analysis_float.o
ANALYSES           := $(BUILD)/libanalyses.a $(BUILD)/libanalyses-nd.a
ANALYSES_OBJECTS   := $(COMMON_OBJECTS) $(BUILD)/cpp/library/analyses.o $(BUILD)/cpp-nd/library/analyses.o $(FLOAT_OBJECT)
PROGRAM_OBJECTS    := $(PROGRAM_SOURCE:src/%.cpp=$(BUILD)/program/%.o)
TEST_OBJECTS       := $(TEST_SOURCE:tests/%.cpp=$(BUILD)/tests/%.o)
BENCH_OBJECTS      := $(BENCH_SOURCE:bench/%.cpp=$(BUILD)/bench/%.o)
OBJECTS            := $(TABLEGEN_OBJECTS) $(sort $(LIBRARY_OBJECTS) $(LIBRARY_ND_OBJECTS) $(ANALYSES_OBJECTS)) $(PROGRAM_OBJECTS) \
                      $(TEST_OBJECTS) $(BENCH_OBJECTS)

GENERATED  := $(if $(TABLEGEN_SOURCE),$(BUILD)/generated/aircraft_tables.inc $(BUILD)/generated/c2_tables.inc) $(BUILD)/generated/reference_points.inc \
              $(BUILD)/generated/identity.inc $(BUILD)/generated/mission.inc
# Everything of the program but main(): tests look into it.
PROGRAM_PARTS := $(filter-out %/main.o,$(PROGRAM_OBJECTS))
LIBRARIES  := $(BUILD)/libtiltrotor.a $(BUILD)/libtiltrotor-nd.a
# The upper half of TR_API_VERSION.
INTERFACE  := $(shell sed -n 's/^.define TR_API_VERSION 0x0*\([0-9]*\)0008u/\1/p' include/tiltrotor/tiltrotor.h)
SHARED     := $(if $(TARGET),,$(BUILD)/libtiltrotor.so.$(INTERFACE))
PROGRAMS   := $(if $(TARGET),,$(if $(PROGRAM_SOURCE),$(BUILD)/tiltrotor $(BUILD)/tiltrotor-nd))
BENCHMARKS := $(BENCH_SOURCE:bench/%.cpp=$(BUILD)/bench_%)

# ---- goals ----

.PHONY: all run validate test test-cross bench headers format install clean help FORCE
.DELETE_ON_ERROR:
Q := $(if $(V),,@)

all: $(if $(TARGET),,$(ANALYSES)) $(BUILD)/libtiltrotor.a $(SHARED) $(PROGRAMS) ## build the library, static and shared, and both programs (the default)

run: all ## run the whole study; figures and numbers go to build/report
	$(Q)$(RUNNER) $(BUILD)/tiltrotor report --output '$(abspath $(BUILD))/report'

validate: all ## every number against its published one, the worst first; fails where the list of known exceedances is not true
	$(Q)$(RUNNER) $(BUILD)/tiltrotor report --validate --output '$(abspath $(BUILD))/report'

test: all $(BUILD)/run_tests ## build and run every test, or TESTS="name ..."
	$(Q)$(RUNNER) $(BUILD)/run_tests $(SHARED_OUT) $(TESTS)
# As many processes as make was given or took.
SHARED_OUT = --jobs $(or $(patsubst -j%,%,$(filter -j%,$(MAKEFLAGS))),1)

headers: $(HEADERS:%=alone/%) ## compile every public header alone, warnings are errors

format: ## lay out every source with clang-format
	$(Q)if tests/tool.sh format $(CLANG_FORMAT) clang-format; then \
	  find include src tests bench -name '*.[ch]pp' -o -name '*.[ch]' | xargs $(CLANG_FORMAT) $(FORMAT_FLAGS); fi
FORMAT_FLAGS ?= -i

ifdef PORTABLE_INSTALL
install: ## copy headers, libraries, program, files for pkg-config, CMake and Python to DESTDIR/PREFIX; portable code unless ARCH is given
	+$(Q)$(MAKE) --no-print-directory ARCH= BUILD='$(BUILD)/portable' install
else
install: all $(LIBRARIES) $(BUILD)/libtiltrotor-aircraft.a
	$(Q)set -e; prefix='$(PREFIX)'; case "$$prefix" in /*) ;; *) prefix="$(CURDIR)/$$prefix" ;; esac; \
	to='$(DESTDIR)'"$$prefix"; install -d "$$to/lib/pkgconfig"; \
	for header in $(HEADERS); do \
	  install -d "$$to/$$(dirname $$header)"; install -m 644 $$header "$$to/$$header"; done; \
	install -m 644 $(LIBRARIES) $(BUILD)/libtiltrotor-aircraft.a "$$to/lib"; \
	$(if $(SHARED),install -m 755 $(SHARED) "$$to/lib"; ln -sf $(notdir $(SHARED)) "$$to/lib/libtiltrotor.so";) \
	$(INSTALL_PACKAGES) \
	$(if $(PROGRAMS),install -d "$$to/bin"; install -m 755 $(BUILD)/tiltrotor "$$to/bin";) \
	printf '%s\n' "prefix=$$prefix" 'includedir=$${prefix}/include' 'libdir=$${prefix}/lib' '' \
	  'Name: tiltrotor' 'Description: Tilt-rotor flight mechanics with exact derivatives' 'Version: $(VERSION)' \
	  'Cflags: -I"$${includedir}" $(strip -ffp-contract=off $(TARGET_$(TARGET)) $(DEFINED:%=-D%))' \
	  'Libs: -L"$${libdir}" $(if $(SHARED),-Wl$(comma)-rpath$(comma)"$${libdir}" )-ltiltrotor -ltiltrotor-aircraft -lm' \
	  > "$$to/lib/pkgconfig/tiltrotor.pc"
endif
comma := ,

clean: ## remove the build directory
	@if [ -n "$$(ls -A $(BUILD) 2>/dev/null)" ] && [ -z "$$(find $(BUILD)/ -maxdepth 2 -name '*.stamp')" ]; then \
	  echo "clean: BUILD=$(BUILD) holds other files and nothing built, left as it is"; exit 1; fi
	rm -rf $(BUILD)

# Goals by what they are for; "use" is all the others.
HELP_check   := test test-cross trace envelope fuzz coverage mutate headers lint format test-page
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

# Flags that only a few objects see have a stamp of their own; in tests.stamp stands the place of the tree as well.
COMPILER       = $(1) $(shell $(1) --version 2>/dev/null | head -n 1)
STAMP_flags   := $(call COMPILER,$(CXX)) $(FLAGS) $(PRIVATE) $(PROGRAM_FLAGS) $(LIBRARY_FLAGS) $(ND_FLAGS) $(EXTERN)
STAMP_tests   := $(TEST_FLAGS)
STAMP_host    := $(call COMPILER,$(HOST_CXX)) $(HOST_FLAGS)
STAMP_tables  := $(TABLES) $(PUBLISHED)
STAMP_sources := $(AR) $(LDFLAGS) $(LDLIBS) $(OBJECTS)
STAMP_c        = $(call COMPILER,$(CC)) $(C_FLAGS)
STAMP_bench    = $(BENCH_FLAGS) $(foreach peer,$(PEERS),$(PEER_FLAGS_$(peer)))
STAMP_stack    = $(STACK_FLAGS)
STAMPS        := $(foreach kind,flags tests host tables sources c bench stack page,$(BUILD)/$(kind).stamp)

$(STAMPS): $(BUILD)/%.stamp: FORCE
	@mkdir -p $(@D)
	@printf '%s\n' '$(subst ','\'',$(STAMP_$*))' | cmp -s - $@ || printf '%s\n' '$(subst ','\'',$(STAMP_$*))' > $@

# What `version` and the page name beside the aircraft: the commit, empty outside a git tree and with a + where files differ from
# it. One small source includes it, so that a commit rebuilds nothing else.
COMMIT   := $(shell test "$$(git rev-parse --show-toplevel 2>/dev/null)" = "$$(pwd -P)" && \
              GIT_OPTIONAL_LOCKS=0 git describe --always --abbrev=12 --exclude='*' --dirty=+ 2>/dev/null)
IDENTITY := "$(COMMIT)"
$(BUILD)/generated/identity.inc: FORCE
	@mkdir -p $(@D)
	@printf '%s\n' '$(IDENTITY)' | cmp -s - $@ || printf '%s\n' '$(IDENTITY)' > $@

# ---- the aircraft, as constant arrays ----

link = @echo "  link    $@"; mkdir -p $(@D)

$(BUILD)/tablegen: $(TABLEGEN_OBJECTS)
	$(link)
	$(Q)$(HOST_CXX) $(HOST_FLAGS) $(TABLEGEN_OBJECTS) -o $@

# Written beside its place and moved there only when complete; what the C2 fit moved stands beside it.
$(BUILD)/generated/%_tables.inc: $(BUILD)/tablegen $(TABLES) $(BUILD)/tables.stamp
	@echo "  tables  tables/$(AIRCRAFT)$(if $(filter c2,$*),: C2 fit)"; mkdir -p $(@D)
	$(Q)$(BUILD)/tablegen $(or $(MADE_TABLES),tables/$(AIRCRAFT)) $@.part $(filter single,$(SLOPES)) $(if $(filter c2,$*),c2 >$(@D)/c2_fit.csv) && mv $@.part $@ || { rm -f $@.part; exit 1; }

# The tests compare this aircraft with the XV-15, whichever is compiled in.
$(BUILD)/generated/scaled_xv15_tables.inc: $(BUILD)/tablegen $(BUILD)/tables/scaled_xv15/identity.csv
	@echo "  tables  tables/scaled_xv15"; mkdir -p $(@D)
	$(Q)$(BUILD)/tablegen $(BUILD)/tables/scaled_xv15 $@.part $(filter single,$(SLOPES)) && mv $@.part $@ || { rm -f $@.part; exit 1; }
$(BUILD)/tests/properties/test_scaled_tables.o: $(BUILD)/generated/scaled_xv15_tables.inc

# identity.csv is written last.
$(BUILD)/tables/%/identity.csv: tables/%/make.sh tables/%/identity.csv $(call find,tables/xv15,*.csv)
	@echo "  make    tables/$*"; mkdir -p $(@D)
	$(Q)sh $< tables/xv15 $(@D)

# Published numbers that the report lays over its curves, as text inside the program: it runs without the source tree.
$(BUILD)/generated/reference_points.inc: $(PUBLISHED) $(BUILD)/tables.stamp
	@echo "  points  tables/$(AIRCRAFT)/published"; mkdir -p $(@D)
	$(Q)for set in $(PUBLISHED); do \
	  printf '{"%s", R"csv(' "$$(basename "$$set" .csv)" && cat "$$set" && printf ')csv"},\n' || exit 1; \
	done > $@.part && mv $@.part $@

# The mission of the report, in the program for the same reason.
$(BUILD)/generated/mission.inc: src/examples/mission.txt
	@mkdir -p $(@D)
	$(Q)(printf 'R"txt(' && cat $< && printf ')txt"\n') > $@.part && mv $@.part $@

# ---- libraries and programs ----

$(BUILD)/libtiltrotor.a: $(LIBRARY_OBJECTS)
$(BUILD)/libtiltrotor-nd.a: $(LIBRARY_ND_OBJECTS)
$(BUILD)/libtiltrotor-aircraft.a: $(AIRCRAFT_OBJECT) $(C2_OBJECT)
$(BUILD)/libanalyses.a: $(COMMON_OBJECTS) $(BUILD)/cpp/library/analyses.o
$(BUILD)/libanalyses-nd.a: $(COMMON_OBJECTS) $(BUILD)/cpp-nd/library/analyses.o
$(LIBRARIES) $(ANALYSES) $(BUILD)/libtiltrotor-aircraft.a: $(BUILD)/sources.stamp
	@echo "  archive $@"; rm -f $@
	$(Q)$(AR) rcs $@ $(filter %.o,$^)

$(BUILD)/libtiltrotor.so.$(INTERFACE): $(C_OBJECTS) src/library/exported.map $(BUILD)/sources.stamp
	$(link)
	$(Q)$(CXX) $(FLAGS) -shared -Wl,-soname,$(@F) -Wl,--version-script=src/library/exported.map $(LDFLAGS) \
	  $(filter %.o,$^) $(LDLIBS) -o $@

$(BUILD)/tiltrotor: $(PROGRAM_OBJECTS) $(BUILD)/libanalyses.a
$(BUILD)/tiltrotor-nd: $(PROGRAM_OBJECTS) $(BUILD)/libanalyses-nd.a
$(BUILD)/run_tests: $(TEST_OBJECTS) $(PROGRAM_PARTS) $(FLOAT_OBJECT) $(BUILD)/libanalyses.a $(BUILD)/libtiltrotor.a
$(BENCHMARKS): $(BUILD)/bench_%: $(BUILD)/bench/%.o $(FLOAT_OBJECT) $(BUILD)/libanalyses.a $(BUILD)/libtiltrotor.a
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
$(sort $(LIBRARY_OBJECTS) $(LIBRARY_ND_OBJECTS) $(ANALYSES_OBJECTS)) $(PROGRAM_OBJECTS) $(TEST_OBJECTS) $(BENCH_OBJECTS): \
  $(BUILD)/flags.stamp | $(GENERATED)
$(TEST_OBJECTS): $(BUILD)/tests.stamp
$(BENCH_OBJECTS): $(BUILD)/bench.stamp
# Ask what the processor can do: must themselves run on every one.
$(addprefix %/,c_processor.o c_entry.o c_entry_sensors.o c_entry_checks.o c_words.o c_plain_names.o processor_check.o): ARCH_FLAGS := $(TARGET_$(TARGET))

# On a target, code that no step runs through is made small: its operations and their order stay.
SMALL := $(if $(TARGET),aircraft conditions outputs ranges saved sensors system_model system_outputs systems trim)
$(SMALL:%=$(BUILD)/ad/library/c_%.o): FLAGS += -Os
$(BUILD)/ad/%.o: src/%.cpp
	$(call compile,$(LIBRARY_FLAGS))
$(BUILD)/nd/%.o: src/%.cpp
	$(call compile,$(LIBRARY_FLAGS) $(ND_FLAGS),numerical differences)

$(BUILD)/cpp/%.o: src/%.cpp
	$(call compile,$(CORE_FLAGS) $(EXTERN),for the program)

$(BUILD)/cpp-nd/%.o: src/%.cpp
	$(call compile,$(CORE_FLAGS) $(EXTERN) $(ND_FLAGS),for the program; numerical differences)

include src/precompiled.mk
$(BUILD)/program/%.o: src/%.cpp $(PRECOMPILED_HEADER:%=%.gch)
	$(call compile,$(PROGRAM_FLAGS) $(EXTERN) $(PRECOMPILED_HEADER:%=-include %))

$(BUILD)/tests/%.o: tests/%.cpp $(PRECOMPILED_HEADER:%=%.gch)
	$(call compile,$(PROGRAM_FLAGS) $(TEST_FLAGS) $(EXTERN) $(PRECOMPILED_HEADER:%=-include %))

$(BUILD)/bench/%.o: bench/%.cpp
	$(call compile,$(BENCH_FLAGS) $(EXTERN))

$(BUILD)/host/%.o: src/%.cpp $(BUILD)/host.stamp
	@echo "  compile $< (host)"; mkdir -p $(@D)
	$(Q)$(HOST_CXX) $(HOST_FLAGS) $(DEPENDENCIES) -c $< -o $@

include src/library/packages.mk src/firmware/firmware.mk src/fmu/fmu.mk src/page/page.mk src/examples/examples.mk tests/budget/budget.mk tests/verification.mk

# A header that needs another one included first is broken; C headers must also please a C99 compiler.
.PHONY: $(HEADERS:%=alone/%)
$(HEADERS:%=alone/%): alone/include/%:
	@echo "  header  $*"
	$(Q)echo '#include "$*"' | $(CXX) $(FLAGS) $(CORE_FLAGS) -Werror -fsyntax-only -x c++ -
	$(if $(filter %.h,$*),$(Q)printf '#include "$*"\nextern int not_empty;\n' | \
	  $(CC) -std=c99 -Wall -Wextra -Wpedantic -Werror -Iinclude -fsyntax-only -x c -)

-include $(OBJECTS:.o=.d)

# ---- values of variables that the parts included above read ----

without = $(if $(1),$(call without,$(wordlist 2,$(words $(1)),$(1)),$(subst $(firstword $(1)),,$(2))),$(2))
number  = $(if $($(1)),$(if $(call without,0 1 2 3 4 5 6 7 8 9,$($(1))),,$(call without,0,$($(1)))))
$(foreach name,CLANG_FORMAT FUZZ_CXX COVERAGE_CXX FIRMWARE_PREFIX,$(if $(strip $($(name))),,\
  $(error $(name) is empty: name a program)))
$(foreach name,SECONDS MUTANTS FIRMWARE_FRAMES MEASURED_STATES,$(if $(call number,$(name)),,\
  $(error $(name)='$($(name))' is no whole number of 1 or more)))
$(foreach name,STATES FLIGHTS MISSIONS,$(if $(or $(call number,$(name)),$(filter 0,$($(name)))),,\
  $(error $(name)='$($(name))' is no whole number of 0 or more)))

# ---- a misspelt variable on the command line would change nothing, silently ----

# Those that ?= gives a value above and in what is included, and the usual ones.
VARIABLES := $(sort CXX CC AR CXXFLAGS CFLAGS CPPFLAGS LDFLAGS LDLIBS LINTED SHELL \
               $(shell sed -n 's/^\([A-Z_]*\) *?=.*/\1/p' $(filter-out %.d,$(MAKEFILE_LIST))))
UNKNOWN   := $(sort $(foreach name,$(.VARIABLES),$(if $(filter command,$(origin $(name))),$(name))))
UNKNOWN   := $(filter-out $(VARIABLES) MAKEFLAGS MFLAGS MAKEOVERRIDES,$(UNKNOWN))
$(if $(UNKNOWN),$(error unknown variable $(UNKNOWN); there are $(VARIABLES)))
