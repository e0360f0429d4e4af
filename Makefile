# Gnomon: `make help` lists the targets.

CC ?= gcc
CXX ?= g++
AR ?= ar
PKG_CONFIG ?= pkg-config
CFLAGS ?= -O3 -g
PREFIX ?= /usr/local
BUILD ?= build

WARNINGS = -Wall -Wextra -Wconversion -Wdouble-promotion -Wshadow -Werror

# The library's own flags come after the user's: without them a compiler may fuse or
# reassociate floating-point operations, and bits would change.
FLOAT_FLAGS = -fno-fast-math -ffp-contract=off
LIBRARY_FLAGS = -std=c99 -pedantic $(WARNINGS) $(CFLAGS) -ffreestanding -fvisibility=hidden \
	-fPIC -Iinclude -fno-math-errno -fno-stack-protector $(FLOAT_FLAGS)
PROGRAM_FLAGS = -std=c11 -pedantic -D_POSIX_C_SOURCE=200809L -Wall -Wextra -Wshadow -Werror \
	$(CFLAGS) $(FLOAT_FLAGS) -Iinclude -Ireference/scene -Ireference/osmesa $(SANITIZE)

LIBRARY_SOURCES = $(sort $(wildcard src/*/*.c))
SCENE_SOURCES = $(sort $(wildcard reference/scene/*.c))
OSMESA_SOURCES = $(sort $(wildcard reference/osmesa/*.c))
COMMAND_SOURCES = $(sort $(wildcard tools/gnomon/*.c))
BENCH_SOURCES = $(sort $(wildcard tools/bench/*.c))
PARITY_SOURCES = $(sort $(wildcard tests/parity/*.c))
UNIT_SOURCES = $(sort $(wildcard tests/unit/*.c))
PROPERTY_SOURCES = $(sort $(wildcard tests/property/*.c))
EXHAUSTIVE_SOURCES = $(sort $(wildcard tests/exhaustive/*.c))
HEADERS = $(sort $(wildcard include/*.h include/gnomon/*.h))

# The property runner: libtheft where there is one, otherwise our own.
THEFT_FOUND := $(shell $(PKG_CONFIG) --exists libtheft 2>/dev/null && echo yes)
ifeq ($(THEFT_FOUND),yes)
THEFT_CFLAGS := $(shell $(PKG_CONFIG) --cflags libtheft)
THEFT_LIBS := $(shell $(PKG_CONFIG) --libs libtheft)
THEFT_SOURCES =
else
THEFT_CFLAGS = -Itests/theft
THEFT_LIBS =
THEFT_SOURCES = $(sort $(filter-out tests/theft/selftest.c,$(wildcard tests/theft/*.c)))
endif

objects = $(patsubst %.c,$(BUILD)/%.o,$(1))

.PHONY: all
all: library $(BUILD)/gnomon

.PHONY: help
help: ## this list
	@awk -F ':.*## ' '/^[a-z][a-z-]*:.*## /{printf "  make %-20s %s\n", $$1, $$2}' Makefile

.PHONY: setup
setup: ## install what building and testing needs (Debian, as root)
	@tools/setup.sh

# The library

.PHONY: library
library: $(BUILD)/libgnomon.a $(BUILD)/libgnomon.so ## the library, static and shared

$(BUILD)/libgnomon.a: $(call objects,$(LIBRARY_SOURCES))
	@echo '  AR $@'
	@$(AR) rcs $@ $^

$(BUILD)/libgnomon.so: $(call objects,$(LIBRARY_SOURCES))
	@echo '  LD $@'
	@$(CC) $(CFLAGS) -shared -nostdlib -Wl,-z,defs -Wl,-soname,libgnomon.so.0 $^ -o $@

$(BUILD)/src/%.o: src/%.c Makefile
	@mkdir -p $(@D)
	@echo '  CC $<'
	@$(CC) $(LIBRARY_FLAGS) $(SANITIZE) -MMD -MP -c $< -o $@

$(BUILD)/%.o: %.c Makefile
	@mkdir -p $(@D)
	@echo '  CC $<'
	@$(CC) $(PROGRAM_FLAGS) $(EXTRA_FLAGS) -MMD -MP -c $< -o $@

$(BUILD)/tests/theft/%.o $(BUILD)/tests/property/%.o: EXTRA_FLAGS = $(THEFT_CFLAGS) -Itests/parity

# Programs

$(BUILD)/gnomon: $(call objects,$(COMMAND_SOURCES) $(SCENE_SOURCES) $(OSMESA_SOURCES)) $(BUILD)/libgnomon.a
	@echo '  LD $@'
	@$(CC) $(CFLAGS) $(SANITIZE) $^ -o $@ -lassimp -lpng -lstb -lOSMesa -lm

$(BUILD)/parity: $(call objects,$(PARITY_SOURCES) $(SCENE_SOURCES) $(OSMESA_SOURCES)) $(BUILD)/libgnomon.a
	@echo '  LD $@'
	@$(CC) $(CFLAGS) $(SANITIZE) $^ -o $@ -lOSMesa -lm

$(BUILD)/unit-tests: $(call objects,$(UNIT_SOURCES)) $(BUILD)/libgnomon.a
	@echo '  LD $@'
	@$(CC) $(CFLAGS) $(SANITIZE) $^ -o $@ -lcmocka -lm

$(BUILD)/theft-selftest: $(call objects,$(THEFT_SOURCES)) $(BUILD)/tests/theft/selftest.o
	@echo '  LD $@'
	@$(CC) $(CFLAGS) $(SANITIZE) $^ -o $@ -lcmocka -lm

$(BUILD)/property-tests: $(call objects,$(PROPERTY_SOURCES) $(THEFT_SOURCES) $(SCENE_SOURCES) \
		$(filter-out tests/parity/gate.c,$(PARITY_SOURCES))) $(BUILD)/libgnomon.a
	@echo '  LD $@'
	@$(CC) $(CFLAGS) $(SANITIZE) $^ -o $@ $(THEFT_LIBS) -lm

$(BUILD)/bench: $(call objects,$(BENCH_SOURCES) $(SCENE_SOURCES) $(OSMESA_SOURCES)) $(BUILD)/libgnomon.a
	@echo '  LD $@'
	@$(CC) $(CFLAGS) $^ -o $@ -lOSMesa -lm

$(BUILD)/exhaustive: $(call objects,$(EXHAUSTIVE_SOURCES)) $(BUILD)/libgnomon.a
	@echo '  LD $@'
	@$(CC) $(CFLAGS) $^ -o $@ -lmpfr -lm

-include $(shell find $(BUILD) -name '*.d' 2>/dev/null)

.PHONY: clean
clean: ## remove what was built
	rm -rf $(BUILD)
