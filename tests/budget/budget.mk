# What the library needs on a Cortex-M7, against tests/budget/limits.csv.

.PHONY: budget
budget: firmware ## memory, stack and instructions on a Cortex-M7 against tests/budget/limits.csv; build/budget.csv
	$(Q)if ! command -v $(FIRMWARE_PREFIX)g++ >/dev/null || ! command -v qemu-system-arm >/dev/null; then \
	  echo "budget: $(FIRMWARE_PREFIX)g++ or qemu-system-arm is not installed, nothing measured"; exit 0; fi; \
	tests/budget/budget.sh $(BUILD)/cortex-m7 $(FIRMWARE_PREFIX) mps2-an500 $(MEASURED_STATES) $(BUILD)/budget.csv
