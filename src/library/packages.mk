# What `make install` copies for CMake and Python beside headers and libraries, and the source archive.

# $$to is the folder of the prefix.
CMAKE_FILE = sed -e 's|@VERSION@|$(VERSION)|' -e 's|@SHARED@|$(notdir $(SHARED))|' \
    -e 's|@OPTIONS@|$(subst $(space),;,$(strip $(TARGET_$(TARGET))))|' \
    -e 's|@DEFINITIONS@|$(subst $(space),;,$(strip $(DEFINED)))|'
INSTALL_PACKAGES = install -d "$$to/lib/cmake/tiltrotor"; \
  for file in tiltrotorConfig tiltrotorConfigVersion; do \
    $(CMAKE_FILE) src/library/$$file.cmake.in > "$$to/lib/cmake/tiltrotor/$$file.cmake"; done; \
  $(if $(SHARED),install -d "$$to/lib/python"; install -m 644 src/python/tiltrotor.py "$$to/lib/python";) \
  install -d "$$to/share/doc/tiltrotor"; install -m 644 LICENSE "$$to/share/doc/tiltrotor";
space := $(subst ,, )

# The tracked files of the last commit: two archives of one commit have the same bytes, whatever the user's git is told.
ARCHIVE := tiltrotor-$(VERSION)
PLAIN_GIT := -c tar.umask=0002 -c core.autocrlf=false -c core.eol=lf -c core.attributesFile=/dev/null
.PHONY: dist
dist: ## write build/tiltrotor-VERSION.tar.gz, the sources of the last commit, the same bytes every time
	$(Q)tests/tool.sh dist git git || exit 0; \
	[ -n '$(COMMIT)' ] || { echo "dist: this is no git tree; the archive is made of a commit"; exit 1; }; \
	case '$(COMMIT)' in *+) echo "dist: changes that are not committed are left out" ;; esac; \
	mkdir -p $(BUILD) && git $(PLAIN_GIT) archive --format=tar --prefix=$(ARCHIVE)/ HEAD | gzip -9 -n >$(BUILD)/$(ARCHIVE).tar.gz.part && \
	mv $(BUILD)/$(ARCHIVE).tar.gz.part $(BUILD)/$(ARCHIVE).tar.gz && echo "$(BUILD)/$(ARCHIVE).tar.gz"

# For Windows by MinGW-w64: the libraries alone, of C and C++ without POSIX, and an example that runs where Wine is; then all that
# an installed copy has.
WINDOWS := x86_64-w64-mingw32
WINDOWS_BUILD := $(BUILD)/$(WINDOWS)
WINDOWS_LIBRARIES := $(addprefix $(WINDOWS_BUILD)/,libtiltrotor.a libtiltrotor-aircraft.a)
# In single precision the linker knows the functions by other names.
WINDOWS_NAMES := $(if $(filter single,$(PRECISION)),s/_0x00070008u/_0x00070004u/; t; s/^    tr_.*/&_single/)
.PHONY: windows
windows: ## build the libraries for Windows, static and DLL, below build/x86_64-w64-mingw32, and there installed/ with files for CMake
	+$(Q)tests/tool.sh windows $(WINDOWS)-g++ g++-mingw-w64-x86-64 || exit 0; set -e; \
	$(MAKE) CROSS_COMPILE=$(WINDOWS)- CXX=$(WINDOWS)-g++ CC=$(WINDOWS)-gcc AR=$(WINDOWS)-ar HOST_CXX='$(HOST_CXX)' ARCH= LDFLAGS= RUNNER= \
	  BUILD=$(WINDOWS_BUILD) $(WINDOWS_LIBRARIES); \
	sed '$(WINDOWS_NAMES)' src/library/tiltrotor.def >$(WINDOWS_BUILD)/tiltrotor.def; \
	(cd $(WINDOWS_BUILD); \
	  $(WINDOWS)-g++ -shared -static tiltrotor.def -Wl,--out-implib,libtiltrotor.dll.a \
	    -Wl,--whole-archive libtiltrotor.a -Wl,--no-whole-archive -o libtiltrotor.dll; \
	  $(WINDOWS)-gcc -std=c99 -O1 $(DEFINED:%=-D%) -I'$(CURDIR)/include' '$(CURDIR)/src/examples/trim_and_fly.c' libtiltrotor.dll.a \
	    -o trim_and_fly.exe); \
	to=$(WINDOWS_BUILD)/installed; rm -rf "$$to"; install -d "$$to/lib"; cp -R include "$$to"; find "$$to/include" -name "*.md" -delete; \
	install -m 644 $(WINDOWS_LIBRARIES) $(addprefix $(WINDOWS_BUILD)/,libtiltrotor.dll libtiltrotor.dll.a tiltrotor.def) "$$to/lib"; \
	$(subst $(notdir $(SHARED)),libtiltrotor.dll,$(INSTALL_PACKAGES)) \
	echo "$(WINDOWS_BUILD)/libtiltrotor.dll"; \
	! tests/tool.sh windows wine wine64 || (cd $(WINDOWS_BUILD); WINEDEBUG=-all wine trim_and_fly.exe)
