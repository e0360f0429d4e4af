# libOSMesa on Gnomon: build/osmesa/libOSMesa.so.8. registry.py needs Khronos' registry (Debian's package
# khronos-api); it writes the header of all of OpenGL's functions, and those that are not supported.

OSMESA = $(BUILD)/osmesa
GL_XML ?= /usr/share/khronos-api/gl.xml
OSMESA_OWN = $(sort $(wildcard tools/osmesa/*/*.c))
OSMESA_OWN_OBJECTS = $(call objects,$(OSMESA_OWN))
OSMESA_HEADER = $(OSMESA)/gl_registry.h
OSMESA_ENTRIES = $(OSMESA)/entries.c
OSMESA_LIBRARY = $(OSMESA)/libOSMesa.so.8

.PHONY: osmesa
osmesa: $(OSMESA_LIBRARY) ## a drop-in libOSMesa: LD_LIBRARY_PATH=build/osmesa program

$(OSMESA_HEADER): tools/osmesa/registry.py
	@mkdir -p $(@D)
	@python3 tools/osmesa/registry.py '$(GL_XML)' header >$@.new && mv $@.new $@

# Loops over 16 lanes become vectors only if the compiler does not unroll them first, and if it may compute what
# a lane then does not take. Neither changes a result.
OSMESA_FLAGS = -fPIC -fvisibility=hidden -Wconversion -Wdouble-promotion -fno-math-errno -fno-trapping-math \
	$(if $(UNROLLED_FLAGS),--param max-completely-peel-times=8) -I$(OSMESA) -Itools/osmesa
$(BUILD)/tools/osmesa/%.o: EXTRA_FLAGS = $(OSMESA_FLAGS) -DOSMESA_EXECUTES
$(OSMESA_OWN_OBJECTS): | $(OSMESA_HEADER)
$(BUILD)/tools/threads/%.o: EXTRA_FLAGS = -fPIC -fvisibility=hidden

$(OSMESA_ENTRIES): tools/osmesa/registry.py $(OSMESA_OWN_OBJECTS)
	@python3 tools/osmesa/registry.py '$(GL_XML)' entries $(OSMESA_OWN_OBJECTS) >$@.new && mv $@.new $@

$(OSMESA)/entries.o: COMMAND = $(CC) $(PROGRAM_FLAGS) $(OSMESA_FLAGS)
$(OSMESA)/entries.o: $(OSMESA_ENTRIES) $(if_changed)
	$(COMPILE)

# The library's own calls of OpenGL's functions stay within it.
$(eval $(call program,osmesa/libOSMesa.so.8,$(OSMESA_OWN) $(THREADS_SOURCES) $(OSMESA)/entries.o $(LIBRARY),-shared -Wl$(comma)-Bsymbolic -Wl$(comma)-z$(comma)defs \
	-Wl$(comma)--exclude-libs$(comma)ALL -Wl$(comma)-soname$(comma)libOSMesa.so.8 -pthread -lm))

.PHONY: install-osmesa
install-osmesa: $(OSMESA_LIBRARY) ## libOSMesa and GL/osmesa.h: PREFIX=/usr/local DESTDIR=
	$(call install,755:$(OSMESA_LIBRARY):$(LIBDIR)/libOSMesa.so.8 644:tools/osmesa/GL/osmesa.h:$(INCLUDEDIR)/GL/osmesa.h,libOSMesa.so.8:$(LIBDIR)/libOSMesa.so)

OSMESA_RUNS ?= 5
$(BUILD)/tools/bench/osmesa/%.o: EXTRA_FLAGS = -Itools/osmesa

.PHONY: bench-osmesa
bench-osmesa: osmesa ## speed of programs with this libOSMesa beside llvmpipe's: OSMESA_RUNS=5
	@python3 tools/bench/osmesa/bench.py $(BUILD) $(OSMESA_RUNS)
