"""Runs ASAM's checkers on many files in one process, by the python of their own environment.

Reads lines ``kind<TAB>input<TAB>result`` from standard input, kind being ``opendrive`` or
``openscenario``, and writes one result file (XQAR) per line. Starting python and importing
scipy costs ten times as much as checking a file: hence one process for all files.
"""

import functools
import importlib
import logging
import sys

import xmlschema
from qc_baselib import Configuration, Result  # type: ignore[import-not-found]

BUNDLES = {"opendrive": "qc_opendrive", "openscenario": "qc_openscenario"}


def run(kind: str, source: str, target: str) -> None:
    """Check one file with its checker bundle and write the result."""
    main = importlib.import_module(f"{BUNDLES[kind]}.main")
    constants = importlib.import_module(f"{BUNDLES[kind]}.constants")
    config = Configuration()
    config.set_config_param("InputFile", source)
    result = Result()
    result.register_checker_bundle(
        name=constants.BUNDLE_NAME, description=kind, version=constants.BUNDLE_VERSION, summary=""
    )
    result.set_result_version(version=constants.BUNDLE_VERSION)
    main.run_checks(config, result)
    result.copy_param_from_config(config)
    result.write_to_file(target)


if __name__ == "__main__":
    logging.disable(logging.CRITICAL)
    # The OpenDRIVE 1.8 schema takes 0.6 s to build; the checker would build it for each file.
    vars(xmlschema)["XMLSchema11"] = functools.lru_cache(maxsize=2)(xmlschema.XMLSchema11)
    for line in sys.stdin:
        run(*line.rstrip("\n").split("\t"))
