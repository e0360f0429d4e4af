# The Python package: what it contains of the library, its wheel, its tests, its benchmark.

PYTHON ?= /usr/bin/python3

# The contract's program, drawing with the shared library beside it: the one that Python draws with.
$(eval $(call program,contract-check-shared,tests/contract/check_contract.c $(CONTRACT_SOURCES),-L$(BUILD) -lgnomon -Wl$(comma)-rpath$(comma)'$$$$ORIGIN' -lm))
$(BUILD)/contract-check-shared: $(BUILD)/libgnomon.so

.PHONY: python-parts
python-parts: $(BUILD)/libgnomon.so $(BUILD)/contract-check-shared $(patsubst %.c,$(BUILD)/%.o,$(wildcard tools/python/src/gnomon/*.c))
	@mkdir -p $(BUILD)/python
	@strip --strip-debug -o $(BUILD)/python/contract-check $(BUILD)/contract-check-shared
	@strip --strip-debug -o $(BUILD)/python/$(SONAME) $(BUILD)/libgnomon.so
	@cp tests/contract/contract.txt $(BUILD)/python/

# Any python3 with cffi makes the same wheel, which is for every CPython from 3.9 on.
.PHONY: wheel
wheel: python-parts ## the Python package as a wheel in build/python/wheel: PYTHON=python3
	@GNOMON_BUILD='$(abspath $(BUILD))' $(PYTHON) tools/python/build_wheel.py $(BUILD)/python/wheel

.PHONY: test-python
test-python: python-parts ## install the Python package in an environment of its own, and run its tests
	@tests/packaging/python.sh $(BUILD)

.PHONY: bench-python
bench-python: test-python ## a thousand pictures of 64x64 from Python, beside OSMesa: MODEL=FILE.obj VIEWS=1000
	@$(if $(MESA_LOADER),$(MESA_LOADER) --library-path $(MESA_LIBRARIES)) $(BUILD)/python/environment/bin/python tools/python/bench.py $(if $(MODEL),--model '$(MODEL)') $(if $(VIEWS),--views $(VIEWS))
