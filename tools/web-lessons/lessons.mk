# The lessons of tools/examples as pages that run in place: build/web/lessons. All lessons are one
# WebAssembly module without imports, once with SIMD and once without; a page loads one of them. Needs
# clang with wasm32, lld, wasi-libc, python3-markdown-it and python3-pygments.

WEB_LESSONS = $(WEB)/lessons
WEB_LESSON_BUILD = $(BUILD)/web-lessons

# Of back ends a module has the portable one alone, whose lanes are vectors where there is SIMD. So it is
# small, and nearly as fast as with a back end for SIMD beside it. Few browsers lack SIMD: the module for
# them is smaller still, and slower.
WEB_LESSON_FORM_plain = -Os
WEB_LESSON_FORM_simd = -O2 -msimd128
WEB_LESSON_LIBRARY_FLAGS = --target=wasm32-wasi -std=c99 -pedantic $(WARNINGS) -ffreestanding -Iinclude \
	-fno-math-errno -DGN_ONLY_PORTABLE $(FLOAT_FLAGS)
WEB_LESSON_PROGRAM_FLAGS = --target=wasm32-wasi -Wall -Wextra -Wshadow -Werror -Iinclude $(FLOAT_FLAGS)
WEB_LESSON_EXPORTS = $(addprefix -Wl$(comma)--export=lesson_,name add_file move_slider run exit_status picture \
	picture_size printed printed_size slider_count slider_name slider_value slider_first slider_least slider_most \
	slider_is_int)
WEB_LESSON_SOURCES = $(LESSONS:%=tools/examples/%.c) tools/examples/obj_tga.c \
	tools/web-lessons/lesson_stdio.c tools/web-lessons/lesson_page.c $(LIBRARY_SOURCES)

# The first two characters of a lesson's name are its number.
lesson_number = $(firstword $(subst _, ,$(notdir $(1))))

# $(call lesson_module,FORM,NAME): the rules of one module.
define lesson_module
$(WEB_LESSON_BUILD)/$(1)/src/%.o: COMMAND = $$(WEB_CC) $$(WEB_LESSON_LIBRARY_FLAGS) $(WEB_LESSON_FORM_$(1))
$(WEB_LESSON_BUILD)/$(1)/tools/web-lessons/%.o: COMMAND = $$(WEB_CC) -std=c11 -pedantic $$(WEB_LESSON_PROGRAM_FLAGS) \
	$(WEB_LESSON_FORM_$(1))
$(WEB_LESSON_BUILD)/$(1)/tools/examples/%.o: COMMAND = $$(WEB_CC) -std=c99 $$(WEB_LESSON_PROGRAM_FLAGS) \
	$(WEB_LESSON_FORM_$(1)) -DLESSON_ON_PAGE -include tools/web-lessons/lesson_stdio.h \
	-Dmain=lesson_main_$$(call lesson_number,$$*)

$(WEB_LESSON_BUILD)/$(1)/%.o: %.c $$(if_changed)
	$$(COMPILE)

$(WEB_LESSON_BUILD)/$(2): COMMAND = $$(WEB_CC) --target=wasm32-wasi -nostartfiles -Wl,--no-entry -Wl,--strip-all \
	-Wl,--stack-first -Wl,-z,stack-size=262144 $$(WEB_LESSON_EXPORTS) $(WEB_LESSON_SOURCES:%.c=$(WEB_LESSON_BUILD)/$(1)/%.o)
$(WEB_LESSON_BUILD)/$(2): $(WEB_LESSON_SOURCES:%.c=$(WEB_LESSON_BUILD)/$(1)/%.o) $$(if_changed)
	$$(LINK)
endef

$(eval $(call lesson_module,plain,lessons.wasm))
$(eval $(call lesson_module,simd,lessons-simd.wasm))

web: web-lessons

.PHONY: web-lessons
web-lessons: web-tools ## the lessons as web pages that run in place: build/web/lessons/index.html
	@$(MAKE) --no-print-directory -s $(WEB_LESSON_BUILD)/lessons.wasm $(WEB_LESSON_BUILD)/lessons-simd.wasm $(LESSON_MODELS)
	@$(PYTHON) tools/web-lessons/make_pages.py $(BUILD)/examples $(WEB_LESSON_BUILD) $(WEB_LESSONS)
