# The web page: build/web, plain files that any web server or none can serve. The library is in it as
# WebAssembly modules that import nothing: gnomon-simd.wasm, and gnomon.wasm for browsers without
# vectors. `make setup-web` installs the compiler.

WEB = $(BUILD)/web
WEB_CC ?= clang-19
WEB_OPT ?= wasm-opt

# The page's functions, for modules and for native programs. Where the command's report.c is linked,
# page_report.c is not.
PAGE_PARTS = $(addprefix tools/web/page_,allocate.c build.c describe.c draw.c files.c json.c maps.c message.c \
	model.c shapes.c state.c text.c)
PAGE_REPORT = tools/web/page_report.c
PAGE_TOOLS = $(MODELS_SOURCES) $(addprefix tools/gnomon/,blended.c bounds.c camera.c image_alpha.c look.c look_colors.c \
	look_lights.c look_maps.c orbit.c \
	shading.c shadow.c teapot.c teapot_maps.c teapot_scene.c)

# Of the scenes, only what the page draws.
PAGE_SCENE = $(addprefix reference/scene/,scene.c scene_format.c scene_frame.c scene_library.c scene_pixel.c \
	scene_texture.c)
MODULE_TOOLS = $(PAGE_PARTS) $(PAGE_REPORT) $(PAGE_TOOLS) $(PAGE_SCENE) $(addprefix tools/web/less/,decimal.c maths.c \
	no_scene_shaders.c scene_memory.c snprintf.c strtod.c)

# Of the library, what runs on this target; tools/web/less/README.md says what else is left out.
MODULE_LIBRARY = tools/web/less/no_srgb.c $(filter-out %avx2.c %avx512.c %neon.c %sse41.c %portable.c %simd128.c %one_lane.c \
	src/formats/srgb.c,$(LIBRARY_SOURCES))
SIMD_LIBRARY = $(filter-out src/shaders/shaders.c,$(MODULE_LIBRARY)) $(addprefix tools/web/less/,stages_simd.c \
	shading_simd.c shaders_simd.c no_portable.c)
PLAIN_LIBRARY = $(filter-out src/backends/lookup.c,$(MODULE_LIBRARY)) $(addprefix tools/web/less/,lookup.c stages_plain.c)

# What the modules export: the functions of page.h but those for native callers.
PAGE_NATIVE = page_scene page_camera page_use_backend
PAGE_EXPORTS := $(filter-out $(PAGE_NATIVE),$(shell tr '()' '  ' <tools/web/page.h | sed -n 's/^[a-z].*[ *]\(page_[a-z_]*\) .*/\1/p'))

$(BUILD)/tools/web/%.o: EXTRA_FLAGS = -Itools/web

WEB_LEVEL = -Oz
WEB_LINK_TIME = -flto
WEB_TARGET = --target=wasm32-wasi -fvisibility=hidden -ffunction-sections -fdata-sections $(WEB_LEVEL) $(WEB_LINK_TIME) \
	$(WEB_VECTORS)
WEB_FEATURES = -include tools/web/less/features.h
WEB_LIBRARY_FLAGS = $(WEB_TARGET) $(WEB_FEATURES) -std=c99 -pedantic $(WARNINGS) -ffreestanding -fno-math-errno \
	-Iinclude $(FLOAT_FLAGS)
WEB_TOOL_FLAGS = $(WEB_TARGET) -std=c11 -pedantic -D_POSIX_C_SOURCE=200809L -Wall -Wextra -Wshadow -Werror \
	$(FLOAT_FLAGS) $(INCLUDES) -Itools/web
# The stack lies below all data, so that a program that runs out of it stops instead of overwriting.
WEB_LINK = -nostartfiles -Wl,--no-entry -Wl,--gc-sections -Wl,--strip-all -Wl,--stack-first \
	-Wl,-z,stack-size=1048576 $(patsubst %,-Wl$(comma)--export=%,$(PAGE_EXPORTS)) $(WEB_LEVEL)
# What compilers of this target assume of every processor, and vectors. Below address 1024 is only the
# end of the stack.
WEB_OPTIMISE = $(WEB_OPT) -Oz --low-memory-unused --enable-mutable-globals --enable-sign-ext --enable-bulk-memory \
	--enable-nontrapping-float-to-int --enable-simd

# The module without vectors is also the one that explains pixels (page_explain): tools/explain needs
# the page's functions and a back end to compare with, and as a third module it would have a second
# copy of both. Its lanes take addresses as with GN_SMALL, but otherwise do not fit GN_SMALL.
PAGE_EXPLAIN = $(EXPLAIN_SOURCES) tools/web/page_explain.c
$(BUILD)/web-plain/tools/explain/stages.o: COMMAND = $(WEB_CC) $(filter-out -DGN_SMALL -Wshadow,$(WEB_TOOL_FLAGS)) $(WEB_FEATURES) \
	-DEXPLAIN_TEXTURE_PARTS='"../web/less/texture_parts.h"' -Wno-unused-function -Wno-unused-parameter -Wno-shadow

$(BUILD)/web-plain/tools/explain/explain.o: COMMAND = $(WEB_CC) $(WEB_TOOL_FLAGS) -DEXPLAIN_ROWS=8

# $(call web_module,NAME,DIRECTORY,FLAGS,FILES OF THE LIBRARY,OTHER FILES,OTHER EXPORTS)
define web_module
$(BUILD)/$(2)/%.o: WEB_VECTORS = $(3)
$(BUILD)/$(2)/%.o: COMMAND = $$(WEB_CC) $$(WEB_TOOL_FLAGS)
$(patsubst %.c,$(BUILD)/$(2)/%.o,$(4)): COMMAND = $$(WEB_CC) $$(WEB_LIBRARY_FLAGS)
$(BUILD)/$(2)/%.o: %.c $$(if_changed)
	$$(COMPILE)

$(BUILD)/$(2)/$(1): COMMAND = $$(WEB_CC) $$(WEB_TARGET) $$(WEB_LINK) $(patsubst %,-Wl$(comma)--export=%,$(6)) $(patsubst %.c,$(BUILD)/$(2)/%.o,$(4) $(MODULE_TOOLS) $(5)) -lm
$(BUILD)/$(2)/$(1): $(patsubst %.c,$(BUILD)/$(2)/%.o,$(4) $(MODULE_TOOLS) $(5)) $$(if_changed)
	@echo '  LD $$(@:$(BUILD)/%=%)'
	@$$(COMMAND) -o $$(@D)/linked.wasm
	@$$(WEB_OPTIMISE) $$(@D)/linked.wasm -o $$@
	@$$(record)
endef

# The C library, which is not bitcode, calls its functions.
$(BUILD)/web-simd/tools/web/less/maths.o $(BUILD)/web-plain/tools/web/less/maths.o: WEB_LINK_TIME =

# Most of a picture's time is spent in shaders: half as long again at -Oz. The first picture waits for maps.
$(BUILD)/web-simd/tools/web/less/shading_simd.o: WEB_LEVEL = -O2
$(BUILD)/web-simd/tools/gnomon/teapot.o $(BUILD)/web-simd/tools/gnomon/teapot_maps.o: WEB_LEVEL = -O2

$(eval $(call web_module,gnomon-simd.wasm,web-simd,-msimd128,$(SIMD_LIBRARY)))
$(eval $(call web_module,gnomon.wasm,web-plain,-DGN_SMALL,$(PLAIN_LIBRARY),$(PAGE_EXPLAIN),page_explain))

WEB_MODULES = $(BUILD)/web-simd/gnomon-simd.wasm $(BUILD)/web-plain/gnomon.wasm

# Files that are served as they are, with their folders.
WEB_STATIC = $(shell cd tools/web; find . -name '*.html' -o -name '*.css' -o -name '*.js' -o -name '*.mjs' -o -name '*.svg' -o -name '*.webmanifest')

# Where the page will be served, with a slash at the end. Previews of shared links need it: they take the address of
# a picture only whole.
WEB_ADDRESS ?=

.PHONY: web web-modules web-tools
web: web-modules ## the web page: build/web, to be served by any web server
	@for file in $(WEB_STATIC); do mkdir -p $(WEB)/$$(dirname $$file) && cp tools/web/$$file $(WEB)/$$file || exit 1; done
	@sed 's|@ADDRESS@|$(WEB_ADDRESS)|' tools/web/index.html >$(WEB)/index.html
	@cp $(WEB_MODULES) $(WEB)
	@cp tools/pictures/teapot.png $(WEB)/preview.png
	@test ! -f tests/contract/pictures.txt || cp tests/contract/pictures.txt $(WEB)/pictures.txt

web-tools:
	@for tool in $(WEB_CC) $(WEB_OPT); do command -v $$tool >/dev/null || \
		{ echo "make web: $$tool is missing; 'make setup-web' installs it" >&2; exit 1; }; done
	@echo 'int page;' | $(WEB_CC) --target=wasm32-wasi -include stdlib.h -x c -c - -o /dev/null 2>/dev/null || \
		{ echo "make web: $(WEB_CC) finds no C library for wasm32-wasi; 'make setup-web' installs it" >&2; exit 1; }

web-modules: web-tools
	@$(MAKE) --no-print-directory $(WEB_MODULES)
