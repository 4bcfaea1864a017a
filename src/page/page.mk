# The page: the C interface as WebAssembly and what is around it, in one file that needs nothing else.

PAGE_CC     ?= clang
PAGE_CXX    ?= clang++
PAGE_LD     ?= wasm-ld
PAGE_TARGET := --target=wasm32-wasi --sysroot=/usr
BROWSER     ?= chromium
# As the other libraries are made. Not -msimd128: with it clang 14 makes code whose derivatives are wrong, which test-page notices.
PAGE_COMMON := $(PAGE_TARGET) -O2 -ffp-contract=off -fno-math-errno -Iinclude -Isrc
PAGE_CXX_FLAGS := $(PAGE_COMMON) -std=c++17 $(CORE_FLAGS) -Dtiltrotor=tiltrotor_library_double -fvisibility=hidden
PAGE_C_FLAGS   := $(PAGE_COMMON) -std=c99 -Wall -Wextra -Wpedantic
PAGE_SCRIPTS := $(addprefix src/page/,module.js numbers.js svg.js chart.js address.js levels.js components.js corridor.js roots.js trim_bars.js \
                  side_view.js front_view.js phasors.js sensitivities.js explore.js \
                  sticks.js recorder.js cockpit.js matrices.js fly.js self_test.js still.js start.js)
PAGE_PARTS   := src/page/explore.html src/page/style.css $(PAGE_SCRIPTS)
PAGE_OBJECTS := $(patsubst src/%.cpp,$(BUILD)/page/%.o,$(C_SOURCE)) \
                $(BUILD)/page/page/page.o $(BUILD)/page/page/component_forces.o $(BUILD)/page/firmware/reference_flight.o $(BUILD)/page/firmware/text.o
PAGE_EXPORTS := $(shell sed -n 's/^[a-z].*[ *]\(page_[a-z_]*\).*/--export=\1/p' src/page/page.h)
PAGE         := $(BUILD)/report/explore.html
STAMP_page    = $(call COMPILER,$(PAGE_CXX)) $(PAGE_CXX_FLAGS) $(PAGE_C_FLAGS) $(PRIVATE)
OBJECTS      += $(PAGE_OBJECTS)

# The shim on this machine, for the tests.
PAGE_ON_HOST := $(BUILD)/on_host/page/page.o $(BUILD)/ad/page/component_forces.o $(BUILD)/firmware/reference_flight.o $(BUILD)/firmware/text.o
OBJECTS      += $(BUILD)/ad/page/component_forces.o
$(BUILD)/ad/page/component_forces.o: $(BUILD)/flags.stamp | $(GENERATED)
$(BUILD)/run_tests: $(PAGE_ON_HOST)
$(BUILD)/on_host/page/page.o: src/page/page.c $(wildcard src/page/*.h) $(FIRMWARE_HEADERS) $(BUILD)/c.stamp
	@echo "  compile $<"; mkdir -p $(@D)
	$(Q)$(CC) $(C_FLAGS) -c $< -o $@

# The compiler may have a launcher before it and flags behind.
page_tools = tests/tool.sh $(1) $(lastword $(filter-out -%,$(PAGE_CXX))) clang $(PAGE_LD) lld '$(PAGE_CXX) $(PAGE_TARGET):cmath' libc++-dev-wasm32 \
               '$(PAGE_CC) $(PAGE_TARGET):string.h' wasi-libc

.PHONY: page test-page
page: ## the model in a browser, to explore and to fly: report/explore.html, one file that needs nothing else
	+$(Q)if $(call page_tools,page); then $(MAKE) --no-print-directory $(PAGE); fi

test-page: ## the page in a headless browser: the bits of this machine, no error, its controls moved
	+$(Q)$(call page_tools,test-page) $(BROWSER) chromium || exit 0; set -e; \
	$(MAKE) --no-print-directory $(PAGE) $(BUILD)/reference_flight $(BUILD)/tiltrotor; \
	$(BUILD)/reference_flight >$(BUILD)/reference_flight.txt; \
	src/page/test.sh '$(BROWSER)' '$(abspath $(PAGE))' $(BUILD)/reference_flight.txt $(BUILD)/page $(abspath $(BUILD))/tiltrotor

$(BUILD)/page/%.o: src/%.cpp $(BUILD)/page.stamp | $(GENERATED)
	@echo "  compile $< (page)"; mkdir -p $(@D)
	$(Q)$(PAGE_CXX) $(PAGE_CXX_FLAGS) $(PRIVATE) $(DEPENDENCIES) -c $< -o $@

$(BUILD)/page/%.o: src/%.c $(BUILD)/page.stamp
	@echo "  compile $< (page)"; mkdir -p $(@D)
	$(Q)$(PAGE_CC) $(PAGE_C_FLAGS) $(DEPENDENCIES) -c $< -o $@

$(BUILD)/page/tiltrotor.wasm: $(PAGE_OBJECTS)
	$(link)
	$(Q)$(PAGE_LD) --no-entry --gc-sections --strip-all --stack-first -z stack-size=1048576 --initial-memory=4194304 \
	  --max-memory=4194304 $(PAGE_EXPORTS) $^ -L/usr/lib/wasm32-wasi -lc -o $@

# Of every aircraft: they are the pilots'.
PAGE_LIMITS := tables/xv15/published/handling_qualities.csv
$(PAGE): $(BUILD)/page/tiltrotor.wasm $(PAGE_PARTS) $(PAGE_LIMITS) src/page/assemble.sh LICENSE
	@echo "  page    $@"; mkdir -p $(@D)
	$(Q)src/page/assemble.sh $< LICENSE $(or $(MADE_TABLES),tables/$(AIRCRAFT)) $(PAGE_LIMITS) $(PAGE_PARTS) >$@.part && mv $@.part $@
