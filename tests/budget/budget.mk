# What the library needs on a Cortex-M7, and the stack it needs on x86-64, against tests/budget/limits.csv.

# Call graphs for the widest vectors, whose stack is the largest; nothing of this runs. Clang writes none.
STACK_OBJECTS := $(if $(CROSS_COMPILE),,$(if $(findstring x86_64,$(shell $(CXX) -dumpmachine 2>/dev/null)),\
                   $(if $(call accepts,-fcallgraph-info=su),\
                     $(addprefix $(BUILD)/stack/,library/c_entry.o library/c_processor.o library/c_aircraft.o library/c_conditions.o library/c_controls.o library/c_outputs.o library/c_flight.o library/c_trim.o library/c_systems.o library/c_ranges.o library/c_entry_checks.o library/c_system_model.o library/c_system_outputs.o library/c_linear.o library/c_rigid_model.o library/c_rotor_expansion.o library/c_exponential_step.o library/c_sensors.o library/c_entry_sensors.o library/c_directional.o library/c_saved.o library/c_words.o library/c_analyses.o library/c_plain_names.o isolated_rotor.o))))
STACK_FLAGS   := $(LIBRARY_FLAGS) -march=x86-64-v4 -fcallgraph-info=su

# A compiler cache keeps no call graphs.
$(STACK_OBJECTS): export CCACHE_DISABLE := 1
$(STACK_OBJECTS): $(BUILD)/flags.stamp $(BUILD)/stack.stamp
$(BUILD)/stack/library/%.o: src/library/%.cpp
	$(call compile,$(STACK_FLAGS),call graph)
$(BUILD)/stack/%.o: tests/budget/%.cpp
	$(call compile,$(STACK_FLAGS),call graph)
-include $(STACK_OBJECTS:.o=.d)

.PHONY: budget budget-measured
budget: ## memory, stack and instructions on a Cortex-M7, stack on x86-64, against tests/budget/limits.csv; build/budget.csv
	+$(Q)if $(call firmware_tools,budget); then $(MAKE) --no-print-directory budget-measured; fi

budget-measured: firmware $(STACK_OBJECTS)
	$(Q)tests/budget/budget.sh $(BUILD)/cortex-m7 $(FIRMWARE_PREFIX) mps2-an500 $(MEASURED_STATES) $(BUILD)/budget.csv \
	  $(STACK_OBJECTS:.o=.ci)
