# What leaves the project: the library as two files, what `make install` puts where, archives and
# packages.

AMALGAMATION_TEXTS = $(wildcard LICENSE include/*.h include/gnomon/*.h src/*/*.[ch] src/kernel/*/*.h src/*/*.inl src/kernel/*/*.inl)

.PHONY: amalgamation
amalgamation: $(BUILD)/amalgamation/gnomon.c ## the library as two files, build/amalgamation/gnomon.h and gnomon.c

$(BUILD)/amalgamation/gnomon.c: tools/packaging/amalgamate.py $(AMALGAMATION_TEXTS)
	@python3 tools/packaging/amalgamate.py $(@D)

# Installation. A file is MODE:SOURCE:DESTINATION, a link TARGET:NAME. `make uninstall` removes these
# and no others. A source that ends in .in is a template: its text is made where it is installed, since
# two installations of one build may run at a time. CMakeLists.txt installs the same templates, with
# equal content.

LIBDIR ?= $(PREFIX)/lib
INCLUDEDIR ?= $(PREFIX)/include
BINDIR ?= $(PREFIX)/bin
DATADIR ?= $(PREFIX)/share
MANDIR ?= $(DATADIR)/man
CMAKEDIR = $(LIBDIR)/cmake/gnomon

LIBRARY_FILES = $(foreach header,$(sort $(wildcard include/*.h include/gnomon/*.h)),644:$(header):$(INCLUDEDIR)/$(header:include/%=%)) \
	644:$(BUILD)/libgnomon.a:$(LIBDIR)/libgnomon.a \
	755:$(BUILD)/libgnomon.so:$(LIBDIR)/libgnomon.so.$(VERSION) \
	644:tools/packaging/gnomon.pc.in:$(LIBDIR)/pkgconfig/gnomon.pc \
	644:tools/packaging/gnomon-config.cmake.in:$(CMAKEDIR)/gnomon-config.cmake \
	644:tools/packaging/gnomon-config-version.cmake.in:$(CMAKEDIR)/gnomon-config-version.cmake
LIBRARY_LINKS = libgnomon.so.$(VERSION):$(LIBDIR)/$(SONAME) $(SONAME):$(LIBDIR)/libgnomon.so
# MPI=yes installs the command that works over ranks (tools/ranks/ranks.mk).
MPI = no
MPI_BUILD = $(if $(filter-out yes no,$(MPI))$(filter-out 1,$(words $(MPI))),$(error MPI must be yes or no: '$(MPI)'),$(filter yes,$(MPI)))
COMMAND_FILES = 755:$(BUILD)/$(if $(MPI_BUILD),mpi,installed)/gnomon:$(BINDIR)/gnomon \
	644:$(DOCUMENTS):$(MANDIR)/man1/gnomon.1 \
	644:$(BUILD)/documents/gnomon.bash:$(DATADIR)/bash-completion/completions/gnomon \
	644:$(BUILD)/documents/_gnomon:$(DATADIR)/zsh/site-functions/_gnomon
INSTALLED_PLACES = $(foreach file,$(LIBRARY_FILES) $(LIBRARY_LINKS) $(COMMAND_FILES),$(lastword $(subst :, ,$(file))))
INSTALLED_FOLDERS = $(INCLUDEDIR)/gnomon $(CMAKEDIR)

# Make's lists, and so the places in them, are divided by spaces.
CHECK_PLACES = $(foreach place,PREFIX LIBDIR INCLUDEDIR BINDIR DATADIR MANDIR,$(if \
	$(or $(word 2,$($(place))),$(findstring :,$($(place)))),$(error $(place) must be a path without spaces and colons: '$($(place))')))

# From the folder of the CMake files to the headers, so that what is installed may be moved. Headers or
# libraries outside the prefix have no common place to move from: then the path is absolute.
UP = $(subst $(space),/,$(patsubst %,..,$(subst /,$(space),$(CMAKEDIR:$(PREFIX)/%=%))))
INCLUDE_FROM_CONFIG = $(if $(and $(filter $(PREFIX)/%,$(LIBDIR)),$(filter $(PREFIX)/%,$(INCLUDEDIR))),$(UP)/$(INCLUDEDIR:$(PREFIX)/%=%),$(INCLUDEDIR))

FILL_IN = sed -e 's|@GN_VERSION@|$(VERSION)|' -e 's|@GN_PREFIX@|$(PREFIX)|' \
	-e 's|@GN_LIBDIR@|$(LIBDIR:$(PREFIX)/%=$${prefix}/%)|' -e 's|@GN_INCLUDEDIR@|$(INCLUDEDIR:$(PREFIX)/%=$${prefix}/%)|' \
	-e 's|@GN_INCLUDE_FROM_CONFIG@|$(INCLUDE_FROM_CONFIG)|' \
	-e 's|@GN_POINTER_SIZE@|$(shell echo __SIZEOF_POINTER__ | $(CC) -E -P - | tr -d '[:space:]')|'

# $(call install,FILES,LINKS)
define install
$(CHECK_PLACES)@set -e; for file in $(1); do \
	place='$(DESTDIR)'"$${file##*:}"; named="$${file%:*}"; source="$${named#*:}"; \
	test -d "$${place%/*}" || install -d "$${place%/*}"; install -m "$${named%%:*}" "$$source" "$$place"; \
	case "$$source" in *.in) $(FILL_IN) "$$source" >"$$place" ;; esac; done
@set -e; for link in $(2); do ln -sf "$${link%:*}" '$(DESTDIR)'"$${link##*:}"; done
endef

.PHONY: install
install: install-library install-command ## library, headers, pkg-config, CMake, command, man page, completions: PREFIX=/usr/local DESTDIR= MPI=no

.PHONY: install-library
install-library: library ## what of this needs a C compiler alone: no command, man page and completions
	$(call install,$(LIBRARY_FILES),$(LIBRARY_LINKS))

.PHONY: install-command
install-command: $$(if $$(MPI_BUILD),mpi,$(BUILD)/installed/gnomon) $(DOCUMENTS) ## the command, its man page and completions; MPI=yes: the command that works over ranks
	$(call install,$(COMMAND_FILES))

.PHONY: uninstall
uninstall: ## remove what install puts there: PREFIX=/usr/local DESTDIR=
	$(CHECK_PLACES)@for place in $(INSTALLED_PLACES); do rm -f '$(DESTDIR)'"$$place"; done
	@for folder in $(INSTALLED_FOLDERS); do rmdir '$(DESTDIR)'"$$folder" 2>/dev/null || :; done

# The source archive: what git tracks, or, where there is no git, the project's files and folders but
# for what builds leave in them. Its bytes depend on the files alone.

NAME_OF_DIST = gnomon-$(VERSION)
DIST = $(BUILD)/$(NAME_OF_DIST).tar.gz
LIST_FILES = if [ -e .git ] && command -v git >/dev/null; then git ls-files; else find $(PROJECT_FILES) \
	'(' -name build -o -name __pycache__ -o -name '*.egg-info' ')' -prune -o ! -type d -print; fi
PROJECT_FILES = .ci .clang-format .dockerignore .github .gitignore CHANGELOG.md CMakeLists.txt CONTRIBUTING.md Containerfile LICENSE Makefile README.md VERIFICATION.md \
	include meson.build meson_options.txt reference src tests tools
# The time of the last commit, or of the archive that this tree came in.
DIST_TIME = $(or $(SOURCE_DATE_EPOCH),$(shell if [ -e .git ]; then git log -1 --format=%ct 2>/dev/null; else stat -c %Y LICENSE; fi),0)

.PHONY: dist
dist: ## the source archive, build/gnomon-VERSION.tar.gz: equal bytes for equal files
	@mkdir -p $(BUILD)
	@{ $(LIST_FILES); } >$(DIST).list && test -s $(DIST).list || \
		{ rm -f $(DIST).list; echo 'dist: git ls-files, or find without git, does not list the files of the project' >&2; exit 1; }
	@sed 's|^\./||' $(DIST).list | LC_ALL=C sort | tar -c --no-recursion --verbatim-files-from -T - --transform 's|^|$(NAME_OF_DIST)/|' \
		--format=ustar --mtime=@$(DIST_TIME) --owner=0 --group=0 --numeric-owner --mode=u=rwX,go=rX >$(DIST).new || \
		{ rm $(DIST).new $(DIST).list; exit 1; }
	@gzip -9n <$(DIST).new >$(DIST).gz && rm $(DIST).new $(DIST).list && mv $(DIST).gz $(DIST)
	@echo '$(DIST)'

# Debian packages, built from the source archive. The variables name the packager, as in Debian's tools.

DEBFULLNAME ?= The Gnomon authors
DEBEMAIL ?= maintainers@gnomon.invalid
DEB_TREE = $(BUILD)/deb/$(NAME_OF_DIST)

.PHONY: deb
deb: dist ## Debian packages of library, development files, command and libOSMesa, in build/deb
	@command -v dpkg-buildpackage >/dev/null && command -v dh >/dev/null || \
		{ echo "make deb: dpkg-buildpackage or debhelper is missing: 'make setup-verify' installs them" >&2; exit 1; }
	@rm -rf $(BUILD)/deb && mkdir -p $(BUILD)/deb
	@tar -xzf $(DIST) -C $(BUILD)/deb
	@cp -r tools/packaging/debian $(DEB_TREE)/debian
	@cd $(DEB_TREE)/debian && for file in libgnomon.*; do mv $$file libgnomon$(SERIES).$${file#libgnomon.}; done
	@sed -n '/^Permission/,$$ { s/^$$/./; s/^/ /; p }' LICENSE >$(BUILD)/deb/licence
	@sed -i -e 's|@VERSION@|$(VERSION)|' -e 's|@SERIES@|$(SERIES)|' -e 's|@MAINTAINER@|$(DEBFULLNAME) <$(DEBEMAIL)>|' \
		-e "s|@DATE@|$$(LC_ALL=C date -u -R -d @$(DIST_TIME))|" -e '/@LICENSE@/ { r $(BUILD)/deb/licence' -e 'd }' $(DEB_TREE)/debian/control $(DEB_TREE)/debian/changelog $(DEB_TREE)/debian/copyright
	@cd $(DEB_TREE) && env -u MAKEFLAGS -u MAKELEVEL -u MAKEOVERRIDES dpkg-buildpackage -us -uc -b >../build.log 2>&1 || \
		{ tail -n 30 ../build.log; exit 1; }
	@ls $(BUILD)/deb/*.deb
