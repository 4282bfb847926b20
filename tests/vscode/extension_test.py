#!/usr/bin/env python3
"""The extension of VS Code: it compiles, packs, and its protocol libraries talk with both servers.

  extension_test.py --isogloss PATH --source FOLDER --folder FOLDER

The packages are those of package-lock.json; they are installed into FOLDER once. Exit status 77, with the reason, where
node, npm or the registry is missing.
"""
import argparse
import hashlib
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import zipfile

SKIPPED = 77
OLDEST_NODE = 18
HERE = pathlib.Path(__file__).resolve().parent
LEFT_OUT = {"node_modules", "out"}


def skip(reason):
    print(f"skipped: {reason}")
    sys.exit(SKIPPED)


def run(*command, cwd, timeout=300):
    done = subprocess.run(command, cwd=cwd, capture_output=True, text=True, errors="replace", timeout=timeout,
                          check=False, env={**os.environ, "npm_config_update_notifier": "false"})
    return done.returncode, done.stdout + done.stderr


def check(what, result):
    status, text = result
    print(f"{what}: {'ok' if status == 0 else 'FAILED'}")
    if status != 0:
        print(text[-6000:])
        sys.exit(1)
    return text


def copy_sources(source, folder):
    """What the extension is made of, as it is now; installed packages stay."""
    folder.mkdir(parents=True, exist_ok=True)
    for old in folder.iterdir():
        if old.name not in {"node_modules", "installed"}:
            shutil.rmtree(old) if old.is_dir() else old.unlink()
    for entry in source.iterdir():
        if entry.name in LEFT_OUT or entry.suffix == ".vsix":
            continue
        if entry.is_dir():
            shutil.copytree(entry, folder / entry.name)
        else:
            shutil.copy2(entry, folder / entry.name)
    for script in HERE.glob("*.mjs"):
        shutil.copy2(script, folder / script.name)


def install(folder):
    stamp = folder / "installed"
    wanted = hashlib.sha256((folder / "package-lock.json").read_bytes()).hexdigest()
    if stamp.exists() and stamp.read_text() == wanted:
        return
    status, text = run("npm", "ci", "--ignore-scripts", "--no-audit", "--no-fund", "--prefer-offline", cwd=folder)
    if status != 0 and re.search(r"ENOTFOUND|EAI_AGAIN|ECONNREFUSED|ETIMEDOUT|ECONNRESET|E40[1347]|E50\d|network", text):
        skip("the packages of the extension cannot be fetched: " + text.strip().splitlines()[0])
    check("npm ci", (status, text))
    stamp.write_text(wanted)


def check_package(folder):
    package = json.loads((folder / "package.json").read_text())
    with zipfile.ZipFile(folder / "isogloss.vsix") as packed:
        names = {n.removeprefix("extension/") for n in packed.namelist() if n.startswith("extension/")}
    wanted = {"out/extension.js", "package.json"}
    wanted |= {g["path"].removeprefix("./") for g in package["contributes"]["grammars"]}
    wanted |= {g["configuration"].removeprefix("./") for g in package["contributes"]["languages"]}
    found = {n.lower() for n in names}
    missing = {n for n in wanted if n.lower() not in found}
    texts = {"readme.md", "license.txt", "license"} & found
    if missing or len(texts) < 2:
        print("the packed extension lacks", missing or "its README or licence", "of", sorted(names))
        sys.exit(1)
    strangers = {n for n in found if n.startswith(("node_modules", "src", "test"))}
    if strangers:
        print("the packed extension holds", strangers)
        sys.exit(1)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--isogloss", required=True)
    parser.add_argument("--source", type=pathlib.Path, required=True)
    parser.add_argument("--folder", type=pathlib.Path, required=True)
    options = parser.parse_args()
    for tool in ("node", "npm"):
        if shutil.which(tool) is None:
            skip(f"{tool} is not installed")
    version = run("node", "--version", cwd=".")[1].strip()
    if int(re.match(r"v(\d+)", version).group(1)) < OLDEST_NODE:
        skip(f"node {version} is older than {OLDEST_NODE}")
    copy_sources(options.source / "host/editors/vscode", options.folder)
    install(options.folder)
    check("npm run package", run("npm", "run", "package", cwd=options.folder))
    check_package(options.folder)
    for script in ("grammar_test.mjs", "debug_test.mjs", "language_test.mjs"):
        text = check(script, run("node", script, options.isogloss, str(options.source), cwd=options.folder, timeout=120))
        print(text.rstrip())


if __name__ == "__main__":
    main()
