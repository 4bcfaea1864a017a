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

$(FMU_FOLDER)/index.html: $(BUILD)/describe_fmu
	@echo "  write   $@"; mkdir -p $(@D)
	$(Q)$(RUNNER) $< page > $@.part && mv $@.part $@

# One folder finds every include: there are importers that know no other.
$(FMU_FOLDER)/sources/buildDescription.xml: $(BUILD)/describe_fmu $(FMU_SOURCES) $(HEADERS) | $(GENERATED)
	@echo "  write   $@"; rm -rf $(@D); mkdir -p $(@D)
	$(Q)for file in $(FMU_SOURCES) $(HEADERS) $(wildcard src/library/*.hpp src/fmu/*.hpp src/fmu/*.h); do \
	  to="$(@D)/$${file#*/}"; mkdir -p "$$(dirname "$$to")"; cp $$file "$$to"; done; \
	cp $(BUILD)/generated/aircraft_tables.inc $(@D); \
	$(RUNNER) $< build $(FMU_SOURCES:src/%=%) > $@.part && mv $@.part $@

# The tests load it.
FMU_PARTS := $(FMU_BINARY) $(FMU_FOLDER)/modelDescription.xml $(FMU_FOLDER)/index.html $(FMU_FOLDER)/sources/buildDescription.xml
$(BUILD)/run_tests: | $(FMU_PARTS)

fmu-archive: $(FMU_PARTS)
	$(Q)sh src/fmu/pack.sh $(FMU_FOLDER) '$(FMU)' && if test -f '$(FMU)'; then echo "  fmu     $(FMU)"; fi
else
fmu-archive:
	@echo "fmu: of double precision and of a machine with an operating system, left out"
endif
