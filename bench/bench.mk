# Benchmarks: every bench/NAME.cpp becomes $(BUILD)/bench_NAME; results go to $(BUILD)/bench/results.csv.

.PHONY: bench bench-peers bench-instructions

BENCH_FLAGS = '-DTILTROTOR_FLAGS="$(FLAGS)"'
MEASURED   := $(filter-out %/bench_instructions $(BUILD)/bench_peers_%,$(BENCHMARKS))

bench: $(MEASURED) ## measure speed, print the timing tables
	$(Q)set -e; for benchmark in $(MEASURED); do $$benchmark $(BUILD)/bench; done
	+$(Q)$(beside_clang)
	@echo; echo "$(abspath $(BUILD))/bench/results.csv"

# The model once more, by clang++ where it is installed, and its times over those of this compiler.
CLANG_BUILD := $(BUILD)/bench/clang++
beside_clang = if [ '$(CXX)' != g++ ] || ! command -v clang++ >/dev/null; then echo "bench: no clang++ beside $(CXX)"; \
	else set -e; mkdir -p $(CLANG_BUILD)/bench; \
	  $(MAKE) --no-print-directory BUILD=$(CLANG_BUILD) CXX=clang++ CC=clang $(CLANG_BUILD)/bench_model; \
	  $(CLANG_BUILD)/bench_model $(CLANG_BUILD)/bench; echo; echo " clang++ over $(CXX)"; \
	  awk -F, 'NR == FNR { time[$$1] = $$2; next } $$3 == "us" && $$1 in time { printf "  %-44s %12.3f -\n", $$1, $$2 / time[$$1] }' \
	    $(BUILD)/bench/results.csv $(CLANG_BUILD)/bench/results.csv; fi

# ---- other libraries, measured side by side when they are installed ----

PEERS := ceres eigen_autodiff sacado adolc eigen lapack

PEER_HEADER_ceres            := ceres/jet.h
PEER_HEADER_eigen_autodiff   := Eigen/Core
PEER_HEADER_sacado           := Sacado_No_Kokkos.hpp
PEER_HEADER_adolc            := adolc/adtl.h
PEER_HEADER_eigen            := Eigen/Dense
PEER_HEADER_lapack           := cstddef
PEER_PACKAGES_ceres          := libceres-dev
PEER_PACKAGES_eigen_autodiff := libeigen3-dev
PEER_PACKAGES_sacado         := libtrilinos-sacado-dev libtrilinos-kokkos-dev libtrilinos-teuchos-dev libopenmpi-dev
PEER_PACKAGES_adolc          := libadolc-dev libboost-dev
PEER_PACKAGES_eigen          := libeigen3-dev
PEER_PACKAGES_lapack         := liblapack-dev
PEER_FLAGS_ceres             := -isystem/usr/include/eigen3
PEER_FLAGS_eigen_autodiff    := -isystem/usr/include/eigen3
PEER_FLAGS_eigen             := -isystem/usr/include/eigen3
PEER_FLAGS_sacado            := -isystem/usr/include/trilinos -DOMPI_SKIP_MPICXX \
                                -isystem/usr/lib/$(shell uname -m)-linux-gnu/openmpi/include
PEER_LIBS_adolc              := -ladolc
PEER_LIBS_lapack             := -llapack
PEER_LIBS_sacado             := -ltrilinos_teuchoscomm -ltrilinos_teuchosparameterlist -ltrilinos_teuchoscore -lmpi

$(foreach peer,$(PEERS),$(eval $(BUILD)/bench/peers_$(peer).o: BENCH_FLAGS += $(PEER_FLAGS_$(peer)) -w))
$(foreach peer,$(PEERS),$(eval $(BUILD)/bench_peers_$(peer): LDLIBS += $(PEER_LIBS_$(peer))))

bench-peers: ## measure other differentiation and linear algebra libraries beside it
	$(foreach peer,$(PEERS),$(call measure_peer,$(peer)))

# One after another, whatever -j says. A peer is there when a program of one line compiles. What the compiler says about
# foreign headers (some of it no flag silences) goes to a file.
define measure_peer
	+$(Q)if printf '#include <$(PEER_HEADER_$(1))>\nint main() {}\n' | \
	    $(CXX) -std=c++17 $(PEER_FLAGS_$(1)) -x c++ - -o /dev/null $(PEER_LIBS_$(1)) 2>/dev/null; then \
	  mkdir -p $(BUILD)/bench; log=$(BUILD)/bench/peers_$(1).log; \
	  if $(MAKE) --no-print-directory $(BUILD)/bench_peers_$(1) >$$log 2>&1; then $(BUILD)/bench_peers_$(1) $(BUILD)/bench; \
	  else echo "bench-peers: $(1) is installed and does not compile, see $$log"; exit 1; fi; \
	else echo "bench-peers: not installed: $(1) (Debian: $(PEER_PACKAGES_$(1))), left out"; fi

endef

# ---- instructions: independent of load and clock, hence a check for every change ----

# One instruction set and one version of a compiler make counts comparable; valgrind knows no AVX-512.
# After a change that is meant: cp build/bench/g++/instructions.csv bench/limits.csv, and clang alike.
COUNTED := $(BUILD)/instructions

COUNTED_GXX   := $(if $(findstring clang,$(CXX)),g++,$(CXX))
COUNTED_CLANG := $(if $(findstring clang,$(CXX)),$(CXX),clang++)

bench-instructions: ## count instructions with g++ and clang++, compare with bench/limits.csv and limits_clang.csv
	+$(Q)if ! tests/tool.sh bench-instructions valgrind valgrind; then :; \
	elif [ "$$(uname -m)" != x86_64 ]; then echo "bench-instructions: the limits are for x86-64, nothing counted"; \
	else set -e; $(call count_with,g++,12,$(COUNTED_GXX),limits.csv); $(call count_with,clang,14,$(COUNTED_CLANG),limits_clang.csv); fi

# $(call count_with,KIND,VERSION,COMPILER,LIMITS)
count_with = version=$$($(3) -dumpversion 2>/dev/null || echo none); \
	if [ "$${version%%.*}" != $(2) ]; then \
	  echo "bench-instructions: bench/$(4) is for $(1) $(2) (Debian: $(1)-$(2)), not for $(3), version $$version: nothing counted"; \
	else echo " $(3) $$version"; \
	  $(MAKE) --no-print-directory BUILD=$(COUNTED)/$(1) CXX='$(3)' ARCH=x86-64-v3 CXXFLAGS=-O3 $(COUNTED)/$(1)/bench_instructions; \
	  bench/count_instructions.sh $(COUNTED)/$(1)/bench_instructions bench/$(4) $(BUILD)/bench/$(1); fi
