# What leaves the project: the library as two files, what `make install` puts where, archives and
# packages.

AMALGAMATION_TEXTS = $(wildcard LICENSE include/*.h include/gnomon/*.h src/*/*.[ch])

.PHONY: amalgamation
amalgamation: $(BUILD)/amalgamation/gnomon.c ## the library as two files, build/amalgamation/gnomon.h and gnomon.c

$(BUILD)/amalgamation/gnomon.c: tools/packaging/amalgamate.py $(AMALGAMATION_TEXTS)
	@python3 tools/packaging/amalgamate.py $(@D)
