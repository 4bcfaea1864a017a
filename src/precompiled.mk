# One header, compiled once for the program and the tests; PRECOMPILED=no: without, as with ccache, which would remember less.

PRECOMPILED ?= $(if $(findstring ccache,$(CXX)),no,yes)
$(call one_of,PRECOMPILED,yes no)
PRECOMPILED_HEADER := $(if $(filter yes,$(PRECOMPILED)),$(BUILD)/precompiled.hpp)

$(BUILD)/precompiled.hpp.gch: src/library/common_headers.hpp $(BUILD)/flags.stamp | $(GENERATED)
	@echo "  compile $<"; mkdir -p $(@D)
	$(Q)echo '#include "library/common_headers.hpp"' > $(BUILD)/precompiled.hpp
	$(Q)$(CXX) $(FLAGS) $(PRIVATE) $(PROGRAM_FLAGS) $(EXTERN) $(DEPENDENCIES) -x c++-header $(BUILD)/precompiled.hpp -o $@
-include $(BUILD)/precompiled.hpp.d
# These compile the headers in another way.
$(BUILD)/tests/math/%_portable.o: PRECOMPILED_HEADER :=
