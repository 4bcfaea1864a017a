# Goals that try to break the product and count what they tried.

# The readers of the table generator, for the tests that feed them; it runs on this machine, the tests on the target.
TABLEGEN_PARTS   := $(filter-out %/main.o,$(TABLEGEN_SOURCE:src/%.cpp=$(BUILD)/program/%.o))
ENVELOPE_OBJECTS := $(BUILD)/tests/properties/envelope.o
OBJECTS          += $(TABLEGEN_PARTS) $(ENVELOPE_OBJECTS)
$(TABLEGEN_PARTS) $(ENVELOPE_OBJECTS): $(BUILD)/flags.stamp $(BUILD)/tests.stamp | $(GENERATED)
$(BUILD)/run_tests: $(TABLEGEN_PARTS)

.PHONY: envelope fuzz fuzzers coverage coverage-measured trace lint mutate
optimised = -O1 -g1 -fno-omit-frame-pointer
sanitized = $(optimised) -fsanitize=address,undefined -fno-sanitize-recover=all
# Older sanitizers crash at random where the kernel spreads addresses widely.
fixed_layout = $(shell setarch $$(uname -m) -R true 2>/dev/null && echo setarch $$(uname -m) -R)

# ---- envelope ----

STATES  ?= 1000000
FLIGHTS ?= 10000
MISSIONS ?= 1000
SHARD   ?= 1/1
envelope: $(BUILD)/envelope ## STATES=1000000 random states, FLIGHTS=10000 random flights and MISSIONS=1000 missions of 60 s; SHARD=k/n: a part
	$(Q)$(RUNNER) $(BUILD)/envelope $(STATES) $(FLIGHTS) $(MISSIONS) $(SHARD)

$(BUILD)/envelope: $(ENVELOPE_OBJECTS) $(FLOAT_OBJECT) $(BUILD)/libanalyses.a $(BUILD)/libtiltrotor.a
	$(link)
	$(Q)$(CXX) $(FLAGS) $(LDFLAGS) $(filter %.o %.a,$^) $(LDLIBS) -o $@

# ---- fuzzing ----

SECONDS ?= 60
FUZZ_TARGETS := c_interface solvers command_line state_file feedback_file tables
FUZZ_CXX ?= clang++
has_fuzzer = echo 'extern "C" int LLVMFuzzerTestOneInput(const char*, long) { return 0; }' | \
             $(FUZZ_CXX) -fsanitize=fuzzer,address,undefined -x c++ - -o /dev/null 2>/dev/null
each = $$(( ($(SECONDS) + $(words $(FUZZ_TARGETS)) - 1) / $(words $(FUZZ_TARGETS)) ))
fuzz: ## SECONDS=60 of mutated input for every reader, solver and the C interface, under the sanitizers
	+$(Q)set -e; if $(has_fuzzer); then \
	  $(MAKE) BUILD=$(BUILD)/fuzz CXX='$(FUZZ_CXX)' ARCH= \
	    CXXFLAGS='$(sanitized) -fsanitize=fuzzer-no-link -DTILTROTOR_FUZZER' fuzzers; \
	  for target in $(FUZZ_TARGETS); do \
	    mkdir -p $(BUILD)/fuzz/found/$$target; \
	    $(fixed_layout) $(BUILD)/fuzz/fuzz_$$target -max_total_time=$(each) -max_len=4096 -timeout=20 -print_final_stats=1 \
	      -artifact_prefix=$(BUILD)/fuzz/$$target- $(BUILD)/fuzz/found/$$target tests/fuzz/corpus/$$target \
	      >$(BUILD)/fuzz/$$target.log 2>&1 || { tail -n 40 $(BUILD)/fuzz/$$target.log; exit 1; }; \
	    echo "fuzz $$target: $$(awk '/number_of_executed_units/ { print $$2 }' $(BUILD)/fuzz/$$target.log) inputs," \
	      "$$(grep -o 'cov: [0-9]*' $(BUILD)/fuzz/$$target.log | tail -n 1 | cut -c 6-) edges reached, nothing found"; \
	  done; \
	else \
	  echo "fuzz: not installed: $(FUZZ_CXX) with libFuzzer (Debian: clang libclang-rt-dev of its version)," \
	    "the plain driver mutates the corpus at random"; \
	  $(MAKE) BUILD=$(BUILD)/fuzz ARCH= CXXFLAGS='$(sanitized)' $(BUILD)/fuzz/run_tests; \
	  FUZZ_SECONDS=$(each) $(fixed_layout) $(BUILD)/fuzz/run_tests fuzz_; \
	fi

fuzzers: $(FUZZ_TARGETS:%=$(BUILD)/fuzz_%)
$(BUILD)/fuzz_tables: $(TABLEGEN_PARTS)
$(BUILD)/fuzz_command_line $(BUILD)/fuzz_state_file $(BUILD)/fuzz_feedback_file: $(PROGRAM_PARTS)
$(FUZZ_TARGETS:%=$(BUILD)/fuzz_%): $(BUILD)/fuzz_%: $(BUILD)/tests/fuzz/test_%.o $(FLOAT_OBJECT) $(BUILD)/libanalyses.a $(BUILD)/libtiltrotor.a
	$(link)
	$(Q)$(CXX) $(FLAGS) $(LDFLAGS) -fsanitize=fuzzer $(filter %.o,$^) $(filter %.a,$^) $(LDLIBS) -o $@

# ---- other machines ----

test-cross: $(BUILD)/reference_flight ## test on other machines, emulated: every test of numbers, and the reference flight bit for bit
	$(Q)$(BUILD)/reference_flight >$(BUILD)/reference_flight.txt
	+$(Q)set -e; for tools in $(CROSS_TOOLS); do \
	  tests/tool.sh "test-cross $$tools" $$tools-g++ g++-$$tools qemu-$${tools%%-*} qemu-user || continue; \
	  $(MAKE) CROSS_COMPILE=$$tools- CXX=$$tools-g++ CC=$$tools-gcc AR=$$tools-ar HOST_CXX='$(HOST_CXX)' ARCH= LDFLAGS= \
	    RUNNER="qemu-$${tools%%-*} -L /usr/$$tools" BUILD=$(BUILD)/$$tools CXXFLAGS=-O1 TESTS='$(CROSS_TESTS)' $(BUILD)/$$tools/reference_flight test; \
	  qemu-$${tools%%-*} -L /usr/$$tools $(BUILD)/$$tools/reference_flight | cmp - $(BUILD)/reference_flight.txt; \
	  echo "$$tools: the reference flight is that of this machine, bit for bit"; done
CROSS_TOOLS ?= aarch64-linux-gnu riscv64-linux-gnu arm-linux-gnueabihf
# Not those of the compilers, tools and pages here, and not the slow ones: an emulator takes 20 times as long.
CROSS_TESTS ?= --skip build_ --skip tools_ --skip house_ --skip pages_ --skip slow_

# ---- coverage ----

# Conditions and decisions (MC/DC) need clang 18 or later.
COVERAGE_CXX ?= $(shell command -v clang++-19 || echo clang++)
coverage: ## statement, branch and condition/decision coverage of include/ and src/ by all tests, with what is not covered
	+$(Q)if tools=$$(tests/coverage/tools.sh '$(COVERAGE_CXX)' '$(mapped)'); then \
	  LLVM_PROFILE_FILE='$(abspath $(BUILD))/coverage/profiles/%2m.profraw' COVERAGE_TOOLS="$$(echo $$tools)" \
	  $(MAKE) BUILD=$(BUILD)/coverage CXX='$(COVERAGE_CXX)' HOST_CXX='$(COVERAGE_CXX)' ARCH= \
	    CXXFLAGS='$(mapped)' HOST_CXXFLAGS='$(mapped)' coverage-measured; fi
mapped = -O1 -fprofile-instr-generate -fcoverage-mapping $(call if_accepted,-fcoverage-mcdc)
if_accepted = $(shell $(COVERAGE_CXX) -fprofile-instr-generate -fcoverage-mapping $(1) -E -x c++ /dev/null >/dev/null 2>&1 && echo $(1))

coverage-measured: all $(BUILD)/run_tests
	$(Q)rm -rf $(BUILD)/profiles
	$(Q)$(BUILD)/run_tests $(SHARED_OUT) $(TESTS)
	$(Q)tests/coverage/report.sh $(COVERAGE_TOOLS) $(BUILD)

# ---- requirements ----

trace: all $(BUILD)/run_tests ## check that every requirement has tests, that they exist and pass
	$(Q)tests/trace.sh $(BUILD)/run_tests

# ---- static checks ----

LINTED := $(filter-out src/examples/% src/firmware/%,$(call find,src,*.cpp))
lint: $(GENERATED) ## clang-tidy and cppcheck on src/ and the headers it includes
	$(Q)tests/lint.sh "-std=c++17 -Iinclude $(PRIVATE)" $(LINTED)

# ---- mutation ----

MUTANTS ?= 60
mutate: $(GENERATED) ## break MUTANTS=60 operators and constants of include/ one at a time; the tests should notice
	$(Q)CXX='$(CXX)' tests/mutation/mutate.sh $(MUTANTS) $(BUILD)
