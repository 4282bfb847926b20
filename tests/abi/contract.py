#!/usr/bin/env python3
"""Compares the C contract with its checked-in description, host/abi/isogloss.abi.

  contract.py check                    the header matches the description
  contract.py check --edit append:ig_syntax --expect compatible
                                       a copy of the header, edited, is judged as expected
  contract.py write                    rewrites the description; refuses a change that would break a plugin

The description is what abidw prints for a small library that reaches every type (host/abi/probe.c). Compatible means:
every struct keeps its members, with names, offsets and types, and gets new ones only at its end and only when it begins
with struct_size; a member called reserved may get a name. abidiff alone cannot tell an insertion from growth: its
suppressions let both pass.
"""
import argparse
import re
import shutil
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as xml
from pathlib import Path

ABI = Path(__file__).resolve().parents[2] / "host" / "abi"
DESCRIPTION = ABI / "isogloss.abi"
ABIDW = ["abidw", "--no-corpus-path", "--no-comp-dir-path", "--no-show-locs", "--no-elf-needed", "--no-architecture",
         "--no-parameter-names"]


def describe(header, compiler):
    """The abidw text of the probe library built from this header text."""
    with tempfile.TemporaryDirectory() as folder:
        Path(folder, "isogloss.h").write_text(header)
        for name in ("probe.c", "isogloss_axis.h", "isogloss_flow.h", "isogloss_import.h", "isogloss_machine_code.h",
                     "isogloss_provenance.h", "isogloss_scan.h", "isogloss_tool.h", "isogloss_view.h"):
            shutil.copy(ABI / name, folder)
        subprocess.run([compiler, "-std=c11", "-g", "-O0", "-fPIC", "-shared", f"-ffile-prefix-map={folder}=.",
                        "-o", "probe.so", "probe.c"], cwd=folder, check=True)
        return subprocess.run([*ABIDW, "probe.so"], cwd=folder, check=True, capture_output=True, text=True).stdout


def structs(description):
    """{struct: [(offset, member, type)]}, and {typedef: type}, unions among the structs."""
    root = xml.fromstring(description)
    by_id = {node.get("id"): node for node in root.iter() if node.get("id")}

    def spell(type_id):
        node = by_id[type_id]
        kind, inner = node.tag, node.get("type-id")
        if kind in ("class-decl", "union-decl", "type-decl", "typedef-decl", "enum-decl"):
            return node.get("name")
        if kind == "pointer-type-def":
            return spell(inner) + "*"
        if kind == "qualified-type-def":
            return spell(inner) + " const" * (node.get("const") == "yes")
        if kind == "array-type-def":
            return spell(inner) + "".join(f"[{part.get('length')}]" for part in node.iter("subrange"))
        if kind == "function-type":
            arguments = ", ".join(spell(part.get("type-id")) for part in node.iter("parameter"))
            return f"{spell(node.find('return').get('type-id'))} ({arguments})"
        raise ValueError(f"abidw wrote a <{kind}> that this script does not know")

    members, typedefs = {}, {}
    for node in root.iter():
        if node.tag in ("class-decl", "union-decl") and node.get("is-declaration-only") != "yes":
            members[node.get("name")] = [
                (int(part.get("layout-offset-in-bits", 0)) // 8, part.find("var-decl").get("name"),
                 spell(part.find("var-decl").get("type-id"))) for part in node.iter("data-member")]
        elif node.tag == "typedef-decl":
            typedefs[node.get("name")] = spell(node.get("type-id"))
    return members, typedefs


def gets_name(old, new):
    """A reserved member, which is zero until an addition gives it a meaning."""
    return old[1] == "reserved" and (old[0], old[2]) == (new[0], new[2])


def breaks(before, after):
    """What a plugin or host built with `before` would suffer from `after`, one line each."""
    old_structs, old_typedefs = before
    new_structs, new_typedefs = after
    for name, old in old_structs.items():
        new = new_structs.get(name)
        if new is None:
            yield f"{name} is gone"
            continue
        for old_member, new_member in zip(old, new):
            if old_member != new_member and not gets_name(old_member, new_member):
                yield "{}: {} at {} ({}) is now {} at {} ({})".format(
                    name, old_member[1], old_member[0], old_member[2], new_member[1], new_member[0], new_member[2])
                break
        else:
            if len(new) < len(old):
                yield f"{name}: {old[len(new)][1]} is gone"
            elif len(new) > len(old) and old[0][1] != "struct_size":
                yield f"{name} has no struct_size, so it cannot grow by {new[len(old)][1]}"
    for name, old in old_typedefs.items():
        if new_typedefs.get(name) != old:
            yield f"typedef {name}: {old} is now {new_typedefs.get(name)}"


def edit(header, instruction):
    """A copy of the header with one change to the members of one struct."""
    verb, name = instruction.split(":")
    start = re.search(rf"(?:struct|union) {name} {{\n", header).end()
    end = header.index("\n}", start) + 1
    body = re.sub(r"/\*.*?\*/", "", header[start:end], flags=re.S)
    members = [part.strip() + ";" for part in body.split(";") if part.strip()]
    middle = len(members) // 2
    if verb == "append":
        members.append("void (*added)(void);")
    elif verb == "insert":
        members.insert(middle, "void (*added)(void);")
    elif verb == "swap":
        other = next(i for i in range(middle, 0, -1) if members[i] != members[middle])
        members[middle], members[other] = members[other], members[middle]
    elif verb == "remove":
        members.pop()
    elif verb == "name":
        members = [re.sub(r"\breserved;$", "named;", member) for member in members]
    elif verb == "rename":
        members[middle] = re.sub(r"\w+;$", "renamed;", members[middle])
    elif verb == "retype":
        members[middle] = re.sub(r"^\S+", "float", members[middle].removeprefix("const "))
    else:
        raise ValueError(f"unknown edit {verb}")
    return header[:start] + "  " + "\n  ".join(members) + "\n" + header[end:]


def main():
    arguments = argparse.ArgumentParser()
    arguments.add_argument("action", choices=["check", "write"])
    arguments.add_argument("--edit", help="append|insert|swap|remove|name|rename|retype:STRUCT")
    arguments.add_argument("--expect", choices=["compatible", "incompatible"], default="compatible")
    arguments.add_argument("--compiler", default="cc")
    arguments.add_argument("--force", action="store_true", help="write although it breaks plugins (before a release)")
    options = arguments.parse_args()

    header = (ABI / "isogloss.h").read_text()
    lines = header.count("\n")
    if lines >= 500:
        sys.exit(f"isogloss.h has {lines} lines; the contract stays under 500")
    if options.edit:
        header = edit(header, options.edit)
    now = describe(header, options.compiler)
    found = list(breaks(structs(DESCRIPTION.read_text()), structs(now))) if DESCRIPTION.exists() else []
    for line in found:
        print(line)

    if options.action == "write":
        if found and not options.force:
            sys.exit("not written: plugins in the field would break. A new major version is a new symbol; before the "
                     "first release, --force.")
        DESCRIPTION.write_text(now)
        print(f"wrote {DESCRIPTION.name}")
        return
    verdict = "incompatible" if found else "compatible"
    if verdict != options.expect:
        sys.exit(f"the contract is {verdict}, expected {options.expect}")
    print(f"the contract is {verdict}, as expected")


main()
