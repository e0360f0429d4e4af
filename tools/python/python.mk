# The Python package: what it contains of the library, its wheel, its tests, its benchmark.

PYTHON ?= /usr/bin/python3

# The contract's program, drawing with the shared library beside it: the one that Python draws with.
$(eval $(call program,contract-check-shared,tests/contract/check_contract.c $(CONTRACT_SOURCES),-L$(BUILD) -lgnomon -Wl$(comma)-rpath$(comma)'$$$$ORIGIN' -lm))
$(BUILD)/contract-check-shared: $(BUILD)/libgnomon.so

.PHONY: python-parts
python-parts: $(BUILD)/libgnomon.so $(BUILD)/contract-check-shared $(addprefix $(BUILD)/tools/python/src/gnomon/,views.o load.o)
	@mkdir -p $(BUILD)/python
	@strip --strip-debug -o $(BUILD)/python/contract-check $(BUILD)/contract-check-shared
	@strip --strip-debug -o $(BUILD)/python/$(SONAME) $(BUILD)/libgnomon.so
	@cp tests/contract/contract.txt $(BUILD)/python/

.PHONY: python
python: python-parts ## the Python package as a wheel in build/python/wheel
	@mkdir -p $(BUILD)/python/wheel
	@GNOMON_BUILD='$(abspath $(BUILD))' $(PYTHON) -m pip wheel --quiet --no-build-isolation --no-deps --no-index \
		--wheel-dir $(BUILD)/python/wheel ./tools/python
	@ls $(BUILD)/python/wheel/*.whl

.PHONY: test-python
test-python: python-parts ## install the Python package in an environment of its own, and run its tests
	@tests/packaging/python.sh $(BUILD)

.PHONY: bench-python
bench-python: test-python ## a thousand pictures of 64x64 from Python, beside OSMesa: MODEL=FILE.obj VIEWS=1000
	@$(if $(MESA_LOADER),$(MESA_LOADER) --library-path $(MESA_LIBRARIES)) $(BUILD)/python/environment/bin/python tools/python/bench.py $(if $(MODEL),--model '$(MODEL)') $(if $(VIEWS),--views $(VIEWS))
