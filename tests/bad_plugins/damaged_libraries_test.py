#!/usr/bin/env python3
"""Tables that the loader of the system would follow out of the library: told before, with the file, and not loaded."""
import os
import struct

from plugin_test_case import OPTIONS, PluginTestCase, main

LOAD, DYNAMIC, NOTE, TLS, RELRO = 1, 2, 4, 7, 0x6474e552
OFFSET, ADDRESS, IN_FILE, IN_MEMORY = 8, 16, 32, 40  # in a program header of 56 bytes, with the type at 0
TAGS = {"NULL": 0, "NEEDED": 1, "HASH": 4, "STRTAB": 5, "SYMTAB": 6, "RELA": 7, "RELASZ": 8, "RELAENT": 9, "STRSZ": 10,
        "SYMENT": 11, "INIT": 12, "FINI": 13, "SONAME": 14, "PLTREL": 20, "JMPREL": 23, "INIT_ARRAY": 25,
        "INIT_ARRAYSZ": 27, "RELRSZ": 35, "RELR": 36, "RELRENT": 37, "GNU_HASH": 0x6ffffef5, "VERSYM": 0x6ffffff0,
        "RELACOUNT": 0x6ffffff9, "VERNEED": 0x6ffffffe}
FAR = 1 << 40
NO_CODE_AT = 1  # inside the library, but no function


class Library:
    """A library of 64 bits whose tables can be written."""

    def __init__(self, path):
        self.bytes = bytearray(path.read_bytes())
        begin, = struct.unpack_from("<Q", self.bytes, 32)
        count, = struct.unpack_from("<H", self.bytes, 56)
        self.headers = [begin + 56 * i for i in range(count)]

    def read(self, at, form="<Q"):
        return struct.unpack_from(form, self.bytes, at)[0]

    def write(self, at, value, form="<Q"):
        struct.pack_into(form, self.bytes, at, value)

    def segment(self, kind, number=0):
        return [at for at in self.headers if self.read(at, "<I") == kind][number]

    def place(self, address):
        """Where in the file the byte of an address lies."""
        for at in self.headers:
            if self.read(at, "<I") == LOAD and 0 <= address - self.read(at + ADDRESS) < self.read(at + IN_FILE):
                return address - self.read(at + ADDRESS) + self.read(at + OFFSET)
        raise AssertionError(f"no segment holds {address:#x}")

    def entry(self, tag):
        """Where the entry of the dynamic section lies: its tag, 8 bytes on its value."""
        at = self.place(self.read(self.segment(DYNAMIC) + ADDRESS))
        while self.read(at) != TAGS[tag]:
            at += 16
        return at

    def value(self, tag):
        return self.read(self.entry(tag) + 8)

    def table(self, tag):
        return self.place(self.value(tag))

    def set(self, tag, value, name=None):
        at = self.entry(tag)
        self.write(at + 8, value)
        if name is not None:
            self.write(at, TAGS[name])


def packed(library, tag_values):
    """A list of packed relocations in place of entries that a library can do without."""
    for (spare, name), value in tag_values.items():
        library.set(spare, value, name)


def unfilled(library):
    """The relocation that fills the first place of INIT_ARRAY fills the place beside it."""
    at, first = library.table("RELA"), library.value("INIT_ARRAY")
    while library.read(at) != first:
        at += 24
    library.write(at, first + 8)


def without_end(library):
    at = library.place(library.read(library.segment(DYNAMIC) + ADDRESS))
    end = at + library.read(library.segment(DYNAMIC) + IN_FILE)
    for entry in range(at, end, 16):
        if library.read(entry) == TAGS["NULL"]:
            library.write(entry, 0x6000000f)


# Of a library in C: what is damaged, and what is said.
DAMAGE = {
    "headers": (lambda e: e.write(54, 55, "<H"), "its program headers have another size"),
    "headers_far": (lambda e: e.write(32, FAR), "its program headers lie outside the file"),
    "headers_many": (lambda e: e.write(56, 65, "<H"), "it has too many segments"),
    "headers_none": (lambda e: e.write(56, 0, "<H"), "it has no segment to load"),
    "segment_far": (lambda e: e.write(e.segment(LOAD) + OFFSET, FAR), "segment 0 lies outside the file"),
    "segment_size": (lambda e: e.write(e.segment(LOAD, 1) + IN_MEMORY, 1), "segment 1 has a size that cannot be right"),
    "segment_wide": (lambda e: e.write(e.segment(LOAD, 1) + IN_MEMORY, 1 << 63), "segment 1 has a size that cannot be right"),
    "segment_order": (lambda e: e.write(e.segment(LOAD, 1) + ADDRESS, 0), "segment 1 lies on the one before it"),
    "segment_moved": (lambda e: e.write(e.segment(LOAD, 1) + OFFSET, 0), "lies outside its segment"),
    "segment_locked": (lambda e: e.write(e.segment(LOAD, 3) + 4, 4, "<I"), "lies outside its segment"),
    "no_dynamic": (lambda e: e.write(e.segment(DYNAMIC), 0, "<I"), "it has no dynamic section"),
    "dynamic_far": (lambda e: e.write(e.segment(DYNAMIC) + ADDRESS, FAR), "its dynamic section lies outside the segments"),
    "dynamic_end": (without_end, "its dynamic section has no end"),
    "thread_local": (lambda e: [e.write(e.segment(NOTE) + IN_MEMORY, FAR), e.write(e.segment(NOTE), TLS, "<I")],
                     "its thread-local data cannot be right"),
    "protected": (lambda e: e.write(e.segment(RELRO) + IN_MEMORY, 1 << 24), "what is protected after relocation lies outside"),
    "note": (lambda e: e.write(e.segment(NOTE) + ADDRESS, FAR), "a note lies outside the segments"),
    "strings": (lambda e: e.set("STRTAB", FAR), "its dynamic strings lie outside the segments"),
    "strings_size": (lambda e: e.set("STRSZ", FAR), "its dynamic strings lie outside the segments"),
    "name": (lambda e: e.set("RELACOUNT", FAR, "SONAME"), "a name in its dynamic section lies outside its strings"),
    "needed": (lambda e: e.set("RELACOUNT", FAR, "NEEDED"), "the name of a library that it needs lies outside its strings"),
    "no_hash": (lambda e: e.set("GNU_HASH", 0, "RELACOUNT"), "it has no hash table of its symbols"),
    "hash_far": (lambda e: e.set("GNU_HASH", FAR), "the hash table of its symbols is damaged"),
    "hash_words": (lambda e: e.write(e.table("GNU_HASH") + 8, 3, "<I"), "the hash table of its symbols is damaged"),
    "hash_buckets": (lambda e: e.write(e.table("GNU_HASH"), 0, "<I"), "the hash table of its symbols is damaged"),
    "hash_last": (lambda e: e.write(e.table("GNU_HASH") + 24, 1 << 30, "<I"), "the hash table of its symbols is damaged"),
    "old_hash": (lambda e: e.set("GNU_HASH", FAR, "HASH"), "the hash table of its symbols is damaged"),
    "symbols": (lambda e: e.set("SYMTAB", FAR), "its symbols lie outside the segments"),
    "symbols_within": (lambda e: e.set("SYMTAB", e.value("SYMTAB") + 1), "its symbols lie outside the segments"),
    "symbol_size": (lambda e: e.set("SYMENT", 23), "its symbols have another size"),
    "symbol_name": (lambda e: e.write(e.table("SYMTAB") + 24, 1 << 30, "<I"), "the name of a symbol lies outside its strings"),
    "symbol_value": (lambda e: e.write(e.table("STRTAB") - 24 + 8, FAR), "the symbol ig_plugin_v1 lies outside the segments"),
    "symbol_no_code": (lambda e: e.write(e.table("STRTAB") - 24 + 8, NO_CODE_AT), "the symbol ig_plugin_v1 lies outside"),
    "initializers": (lambda e: e.set("INIT_ARRAYSZ", FAR), "the list of its initializers lies outside the segments"),
    "unfilled": (unfilled, "an initializer has no address"),
    "initializer": (lambda e: e.set("INIT", NO_CODE_AT), "its initializer lies outside the segments"),
    "relocation_size": (lambda e: e.set("RELAENT", 23), "its relocations have another form"),
    "relocations": (lambda e: e.set("RELA", FAR), "its relocations lie outside the segments"),
    "relative": (lambda e: e.set("RELACOUNT", FAR), "its relocations lie outside the segments"),
    "relative_few": (lambda e: e.write(e.table("RELA") + 8, 6), "its relocations are damaged"),
    "relocation_place": (lambda e: e.write(e.table("RELA"), FAR), "a relocation leads outside the segments"),
    "relocation_value": (lambda e: e.write(e.table("RELA") + 16, FAR), "a relocation leads outside the segments"),
    "relocation_symbol": (lambda e: [e.set("RELACOUNT", 0), e.write(e.table("RELA") + 8, 99 << 32 | 6)],
                          "a relocation leads outside the segments"),
    "packed": (lambda e: packed(e, {("RELACOUNT", "RELR"): FAR}), "its packed relocations lie outside the segments"),
    "packed_place": (lambda e: packed(e, {("RELACOUNT", "RELR"): e.value("SYMTAB"), ("INIT", "RELRSZ"): 48, ("FINI", "RELRENT"): 8}),
                     "a packed relocation leads outside the segments"),
}

# Of a library in C++, which needs others and their versions.
DAMAGE_WITH_VERSIONS = {
    "plt_form": (lambda e: e.set("PLTREL", 17), "its relocations have another form"),
    "plt_lost": (lambda e: e.set("JMPREL", 0, "RELACOUNT"), "its relocations have another form"),
    "versions": (lambda e: e.set("VERSYM", FAR), "the versions of its symbols are damaged"),
    "version_of": (lambda e: e.write(e.table("VERSYM") + 2, 0x7000, "<H"), "the versions of its symbols are damaged"),
    "version_need": (lambda e: e.set("VERNEED", FAR), "the versions of its symbols are damaged"),
    "version_file": (lambda e: e.write(e.table("VERNEED") + 4, 0, "<I"), "the versions of its symbols are damaged"),
    "version_next": (lambda e: e.write(e.table("VERNEED") + 12, 1 << 30, "<I"), "the versions of its symbols are damaged"),
    "version_name": (lambda e: e.write(e.table("VERNEED") + e.read(e.table("VERNEED") + 8, "<I") + 8, 1 << 30, "<I"),
                     "the versions of its symbols are damaged"),
}


class DamagedLibraries(PluginTestCase):
    def check(self, plugin, damage):
        sound = OPTIONS.plugins / plugin / f"{plugin}.so"
        for name, (spoil, _) in damage.items():
            library = Library(sound)
            spoil(library)
            self.assertNotEqual(library.bytes, sound.read_bytes(), name)
            (self.path / f"{name}.so").write_bytes(library.bytes)
        done = self.doctor(self.path)
        self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
        for name, (_, expected) in damage.items():
            with self.subTest(name):
                line = next(line for line in done.stdout.splitlines() if f"/{name}.so: " in line)
                self.assertIn(expected, line)
                self.assertIn("[IG-0301]", line)

    def test_each_table_is_looked_at_before_loading(self):
        self.check("newer_minor", DAMAGE)

    def test_versions_are_looked_at_before_loading(self):
        self.check("throws_in_build", DAMAGE_WITH_VERSIONS)

    def test_other_forms_of_the_tables_are_loaded(self):
        for plugin in ("old_hash", "packed_relocations"):
            with self.subTest(plugin):
                if not (OPTIONS.plugins / plugin).exists():
                    self.skipTest(f"the linker makes no {plugin}")
                done = self.doctor(OPTIONS.plugins / plugin)
                self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
                self.assertIn(f"{plugin} 1.0.0: 1 syntaxes", done.stdout)

    def test_a_chain_of_an_old_hash_table_has_an_end(self):
        library = Library(OPTIONS.plugins / "old_hash" / "old_hash.so")
        buckets = library.read(library.table("HASH"), "<I")
        for chain in range(library.read(library.table("HASH") + 4, "<I")):
            library.write(library.table("HASH") + 8 + 4 * buckets + 4 * chain, 1, "<I")
        (self.path / "old_hash.so").write_bytes(library.bytes)
        done = self.doctor(self.path)
        self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
        self.assertIn("(the hash table of its symbols is damaged) [IG-0301]", done.stdout)

    def test_files_that_are_no_libraries(self):
        sound = (OPTIONS.plugins / "newer_minor" / "newer_minor.so").read_bytes()
        files = {
            "empty.so": b"",
            "text.so": b"this is not a library, whatever its name says\n" * 100,
            "magic.so": b"\x7fELF",
            "header.so": sound[:64],
            "half.so": sound[:len(sound) // 2],
            "other_machine.so": sound[:18] + struct.pack("<H", 0xf3) + sound[20:],
        }
        for name, content in files.items():
            (self.path / name).write_bytes(content)
        (self.path / "folder.so").mkdir()
        (self.path / "dangling.so").symlink_to("nowhere.so")
        os.mkfifo(self.path / "pipe.so")
        done = self.doctor(self.path)
        self.assertEqual(done.returncode, 1, done.stderr)
        for name in [*files, "folder.so", "dangling.so", "pipe.so"]:
            with self.subTest(name):
                line = next(line for line in done.stdout.splitlines() if f"/{name}: " in line)
                self.assertRegex(line, r"\[IG-030[1-3]\]")

    def test_a_damaged_table_of_sections_never_crashes_the_look_before_loading(self):
        sound = bytearray((OPTIONS.plugins / "newer_minor" / "newer_minor.so").read_bytes())
        sections = struct.unpack_from("<Q", sound, 40)[0]
        damage = {"sections_far": (40, 1 << 40), "sections_inside": (40, sections + 8), "no_sections": (40, 0),
                  "many_sections": (60, 0xffff), "names_far": (62, 0xfff0), "entry_size": (58, 1)}
        for name, (offset, value) in damage.items():
            copy = bytearray(sound)
            struct.pack_into("<Q" if offset == 40 else "<H", copy, offset, value)
            (self.path / f"{name}.so").write_bytes(copy)
        for section in range(1, 12):
            copy = bytearray(sound)
            struct.pack_into("<QQ", copy, sections + 64 * section + 24, 1 << 60, 1 << 60)
            (self.path / f"section_{section}.so").write_bytes(copy)
        done = self.doctor(self.path)
        self.assertIn(done.returncode, (0, 1), done.stderr)
        self.assertIn("Not loaded", done.stdout)


if __name__ == "__main__":
    main()
