# Examples, built as a user builds them: against an installed copy and nothing else.

EXAMPLES_PREFIX := $(abspath $(BUILD))/installed
.PHONY: examples
examples: ## install below build/installed, build and run the examples against that copy alone
	+$(Q)$(MAKE) --no-print-directory install DESTDIR= PREFIX='$(EXAMPLES_PREFIX)'
	$(Q)CC='$(CC)' CXX='$(CXX)' RUNNER='$(strip $(RUNNER))' src/examples/check.sh '$(EXAMPLES_PREFIX)'
