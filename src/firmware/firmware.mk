# The reference flight on this machine, and as images for a Cortex-M7 (double) and a Cortex-M4F (single precision).

FIRMWARE_PREFIX ?= arm-none-eabi-
FIRMWARE_FRAMES ?= 600
MEASURED_STATES ?= 1000
FIRMWARE_ROM    ?= 512K
FIRMWARE_RAM    ?= 115K
FIRMWARE_STACK  ?= 16K
C_FLAGS := -std=c99 $(if $(TARGET),-Os,-O2) $(CPPFLAGS) $(CFLAGS) $(ARCH_FLAGS) -ffp-contract=off -Wall -Wextra -Wpedantic $(if $(WERROR),-Werror) \
           $(DEFINED:%=-D%) -Iinclude -Isrc
FIRMWARE_HEADERS := $(wildcard src/firmware/*.h include/tiltrotor/*.h)

.PHONY: hash firmware test-firmware

$(BUILD)/firmware/%.o: src/firmware/%.c $(FIRMWARE_HEADERS) $(BUILD)/c.stamp
	@echo "  compile $<"; mkdir -p $(@D)
	$(Q)$(CC) $(C_FLAGS) -c $< -o $@

$(BUILD)/reference_flight: $(addprefix $(BUILD)/firmware/,flight_on_host.o reference_flight.o)
$(BUILD)/vehicle_flight: $(addprefix $(BUILD)/firmware/,vehicle_on_host.o vehicle_flight.o)
$(BUILD)/reference_flight $(BUILD)/vehicle_flight: $(BUILD)/firmware/text.o $(BUILD)/libtiltrotor.a
	$(link)
	$(Q)$(CXX) $(FLAGS) $(LDFLAGS) $(filter %.o,$^) $(filter %.a,$^) $(LDLIBS) -o $@

hash: $(BUILD)/reference_flight ## hash of the reference flight, the same on every machine
	$(Q)$(RUNNER) $(BUILD)/reference_flight >$(BUILD)/hash.txt || { cat $(BUILD)/hash.txt; echo "hash: the flight failed"; exit 1; }
	$(Q)awk -v machine="$$($(CC) -dumpmachine)" '/^hash|^precision/ { printf "%s %s\n", machine, $$0 }' $(BUILD)/hash.txt

ifdef TARGET
# In these objects short functions are not put into their callers, and loops not doubled: 26 KB for a fortieth of a
# Jacobian. It buys -O3 for the rotors of the aircraft with systems.
$(patsubst %,$(BUILD)/ad/library/c_%.o,analyses exponential_step linear rotor_expansion): FLAGS += $(call accepts,-fno-inline-small-functions -fno-unswitch-loops -fno-split-loops)

BOARD_OBJECTS := $(addprefix $(BUILD)/firmware/,board.o text.o)
IMAGES := $(BUILD)/flight.elf $(BUILD)/vehicle.elf $(BUILD)/measure.elf
$(BUILD)/flight.elf: $(addprefix $(BUILD)/firmware/,flight_image.o reference_flight.o)
$(BUILD)/vehicle.elf: $(addprefix $(BUILD)/firmware/,vehicle_image.o vehicle_flight.o)
$(BUILD)/measure.elf: $(addprefix $(BUILD)/firmware/,measure_image.o measure.o vehicle_flight.o)
# A and B of the vehicle take 15 KB. The image that measures calls everything, steps by the exponential as well.
$(BUILD)/measure.elf: FIRMWARE_ROM := 576K
$(BUILD)/vehicle.elf $(BUILD)/measure.elf: FIRMWARE_RAM := 130K
$(IMAGES): $(BOARD_OBJECTS) $(BUILD)/libtiltrotor.a src/firmware/board.ld
	$(link)
	$(Q)$(CC) $(ARCH_FLAGS) -nostartfiles -T src/firmware/board.ld -Wl,--gc-sections -Wl,-Map=$@.map \
	  -Wl,--defsym=ROM_SIZE=$(FIRMWARE_ROM),--defsym=RAM_SIZE=$(FIRMWARE_RAM),--defsym=STACK_SIZE=$(FIRMWARE_STACK) \
	  $(filter %.o,$^) $(filter %.a,$^) -lm -lc -lgcc -o $@
endif

# $(call image_make,TARGET,PRECISION): make for another target, whatever this make was told. Loops of more than 8 turns
# stay loops: written out, those over the partials of a dual number would take a third of the code of an image. Loops
# that copy are not replaced by calls, which cost more than the short copies of a dual number.
image_make = CCACHE_DISABLE=1 $(MAKE) --no-print-directory CROSS_COMPILE=$(FIRMWARE_PREFIX) CXX=$(FIRMWARE_PREFIX)g++ \
  CC=$(FIRMWARE_PREFIX)gcc AR=$(FIRMWARE_PREFIX)ar HOST_CXX='$(HOST_CXX)' TARGET=$(1) PRECISION=$(2) SLOPES=single ARCH= RUNNER= \
  CXXFLAGS='-O3 --param max-completely-peel-times=8 -fno-tree-loop-distribute-patterns \
  -fcallgraph-info=su -fstack-usage' LDFLAGS= BUILD=$(BUILD)/$(1)
images = $(patsubst %,$(BUILD)/$(1)/%.elf,flight vehicle measure)

# $(call firmware_tools,GOAL): what building the images, and flying them, needs
firmware_builders = tests/tool.sh $(1) $(FIRMWARE_PREFIX)g++ gcc-arm-none-eabi \
                      $(FIRMWARE_PREFIX)g++:cmath libstdc++-arm-none-eabi-newlib
firmware_tools    = $(firmware_builders) qemu-system-arm qemu-system-arm

firmware: ## images of the reference flight for Cortex-M7 and Cortex-M4F
	+$(Q)if $(call firmware_builders,firmware); then \
	  $(call image_make,cortex-m7,double) $(call images,cortex-m7) && \
	  $(call image_make,cortex-m4f,single) $(call images,cortex-m4f) && \
	  $(FIRMWARE_PREFIX)size $(call images,cortex-m7) $(call images,cortex-m4f); fi

# The host's own flights, with the slopes of the images: the hashes must be equal.
test-firmware: ## fly the images in an emulator and compare with the flight on this machine
	+$(Q)$(call firmware_tools,test-firmware) || exit 0; set -e; \
	$(MAKE) --no-print-directory firmware; \
	for precision in double single; do \
	  $(MAKE) --no-print-directory PRECISION=$$precision SLOPES=single BUILD=$(BUILD)/$$precision $(BUILD)/$$precision/reference_flight $(BUILD)/$$precision/vehicle_flight; done; \
	for flight in reference vehicle; do \
	  image=$${flight%reference}; image=$${image:-flight}; \
	  src/firmware/compare.sh "cortex-m7 $$flight" mps2-an500 $(BUILD)/cortex-m7/$$image.elf \
	    "$(RUNNER) $(BUILD)/double/$${flight}_flight" $(FIRMWARE_FRAMES); \
	  src/firmware/compare.sh "cortex-m4f $$flight" mps2-an386 $(BUILD)/cortex-m4f/$$image.elf \
	    "$(RUNNER) $(BUILD)/single/$${flight}_flight" $(FIRMWARE_FRAMES); done
