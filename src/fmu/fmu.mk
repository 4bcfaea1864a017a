# The functional mock-up unit: binary, descriptions and sources, zipped. It is of double precision and of a machine with
# an operating system.

.PHONY: fmu fmu-archive
ifdef PORTABLE_INSTALL
fmu: ## build/tiltrotor.fmu, FMI 3.0 for Model Exchange and Co-Simulation; portable code unless ARCH is given
	+$(Q)$(MAKE) --no-print-directory ARCH= BUILD='$(BUILD)/portable' FMU='$(BUILD)/tiltrotor.fmu' fmu-archive
else
fmu: fmu-archive
endif

FMU          ?= $(BUILD)/tiltrotor.fmu
FMU_FOLDER   := $(BUILD)/fmu
FMU_PLATFORM := $(firstword $(subst -, ,$(shell $(CXX) -dumpmachine 2>/dev/null)))-linux
FMU_BINARY   := $(FMU_FOLDER)/binaries/$(FMU_PLATFORM)/tiltrotor.so
FMU_OBJECTS  := $(patsubst src/%.cpp,$(BUILD)/ad/%.o,$(filter-out %/describe.cpp,$(wildcard src/fmu/*.cpp)))
FMU_SOURCES  := $(C_SOURCE) $(filter-out src/fmu/describe.cpp,$(wildcard src/fmu/*.cpp))

ifeq ($(TARGET)$(PRECISION),double)
OBJECTS += $(FMU_OBJECTS) $(BUILD)/program/fmu/describe.o
$(FMU_OBJECTS) $(BUILD)/program/fmu/describe.o: $(BUILD)/flags.stamp | $(GENERATED)

$(FMU_BINARY): $(C_OBJECTS) $(FMU_OBJECTS) src/fmu/exported.map $(BUILD)/sources.stamp
	$(link)
	$(Q)$(CXX) $(FLAGS) -shared -Wl,--version-script=src/fmu/exported.map $(LDFLAGS) $(filter %.o,$^) $(LDLIBS) -o $@

$(BUILD)/describe_fmu: $(BUILD)/program/fmu/describe.o $(FMU_OBJECTS) $(BUILD)/libtiltrotor.a
	$(link)
	$(Q)$(CXX) $(FLAGS) $(LDFLAGS) $^ $(LDLIBS) -o $@

$(FMU_FOLDER)/modelDescription.xml: $(BUILD)/describe_fmu
	@echo "  write   $@"; mkdir -p $(@D)
	$(Q)$(RUNNER) $< model > $@.part && mv $@.part $@

# One folder finds every include: there are importers that know no other.
$(FMU_FOLDER)/sources/buildDescription.xml: $(BUILD)/describe_fmu $(FMU_SOURCES) $(HEADERS) | $(GENERATED)
	@echo "  write   $@"; rm -rf $(@D); mkdir -p $(@D)
	$(Q)for file in $(FMU_SOURCES) $(HEADERS) $(wildcard src/library/*.hpp src/fmu/*.hpp src/fmu/*.h); do \
	  to="$(@D)/$${file#*/}"; mkdir -p "$$(dirname "$$to")"; cp $$file "$$to"; done; \
	cp $(BUILD)/generated/aircraft_tables.inc $(@D); \
	$(RUNNER) $< build $(FMU_SOURCES:src/%=%) > $@.part && mv $@.part $@

# The tests load it.
$(BUILD)/run_tests: | $(FMU_BINARY) $(FMU_FOLDER)/modelDescription.xml $(FMU_FOLDER)/sources/buildDescription.xml

# A copy of one date, in one order: two builds give the same bytes.
fmu-archive: $(FMU_BINARY) $(FMU_FOLDER)/modelDescription.xml $(FMU_FOLDER)/sources/buildDescription.xml
	$(Q)set -e; to="$$(pwd)/$(FMU)"; case '$(FMU)' in /*) to='$(FMU)' ;; esac; \
	packed=$(FMU_FOLDER)/packed; rm -rf "$$to" "$$packed"; mkdir -p "$$packed/documentation/licenses" "$$packed/terminalsAndIcons"; \
	cp -R $(FMU_FOLDER)/modelDescription.xml $(FMU_FOLDER)/binaries $(FMU_FOLDER)/sources "$$packed"; \
	cp src/fmu/terminalsAndIcons.xml src/fmu/icon.svg src/fmu/icon.png "$$packed/terminalsAndIcons"; \
	cp src/fmu/README.md "$$packed/documentation"; cp LICENSE "$$packed/documentation/licenses/license.txt"; \
	find "$$packed" -exec touch -t 198001010000 {} +; cd "$$packed"; \
	if command -v zip >/dev/null; then find . -type f | LC_ALL=C sort | zip -q -X -@ "$$to"; \
	elif command -v python3 >/dev/null; then python3 -m zipfile -c "$$to" *; \
	else echo "fmu: not installed: zip (Debian: zip), left as the folder $(FMU_FOLDER)/packed"; exit 0; fi; \
	echo "  fmu     $(FMU)"
else
fmu-archive:
	@echo "fmu: of double precision and of a machine with an operating system, left out"
endif
