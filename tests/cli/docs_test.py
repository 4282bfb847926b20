#!/usr/bin/env python3
"""The reference that `isogloss docs` writes: whole, linked, well-formed, and harmless whatever a vendor's texts hold.

  docs_test.py --isogloss PATH --plugins DIR    (DIR holds docs_vendor.so)
"""
import argparse
import collections
import html.parser
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest
import urllib.parse

OPTIONS = None

VENDOR = """<Dialect xmlns="urn:isogloss:dialect:1" name="vendor" title="Presses &lt;b&gt;of&lt;/b&gt; a vendor" extends="fanuc">
  <Plugins> <Plugin name="docs_vendor"/> </Plugins>
  <Chain> <InsertBefore syntax="LinearMotionSyntax"> <VendorPressSyntax force="3"/> </InsertBefore> </Chain>
</Dialect>
"""
VOID = {"meta", "link", "br", "hr", "input"}
TAGS = set("""html head meta title link body header a nav div input ul main h1 h2 h3 script p li ol code pre em strong table
thead tbody tr th td article figure figcaption del ins blockquote br hr svg style text rect path g""".split())


class Parser(html.parser.HTMLParser):
    """Faults of one page, its links, the places on it, and its text."""

    def __init__(self, text):
        super().__init__()
        self.stack, self.faults, self.links, self.ids = [], [], [], collections.Counter()
        self.tags, self.words, self.loaded = collections.Counter(), [], []
        self.feed(text)
        self.close()
        if self.stack:
            self.faults.append(f"open at the end: {self.stack}")

    def handle_starttag(self, tag, attrs):
        self.tags[tag] += 1
        if tag not in TAGS | {"title"}:
            self.faults.append(f"<{tag}> at {self.getpos()}")
        for name, value in attrs:
            if name == "id":
                self.ids[value] += 1
            if name == "href" and tag == "a":
                self.links.append(value)
            elif name in ("href", "src", "data"):
                self.loaded.append(value)
            if name.startswith("on") or name == "srcdoc" or (name == "style" and tag != "rect"):
                self.faults.append(f"{name}= at {self.getpos()}")
        if tag not in VOID:
            self.stack.append(tag)

    def handle_startendtag(self, tag, attrs):
        self.handle_starttag(tag, attrs)
        if tag not in VOID:
            self.handle_endtag(tag)

    def handle_endtag(self, tag):
        if not self.stack or self.stack[-1] != tag:
            self.faults.append(f"</{tag}> at {self.getpos()} closes {self.stack[-1:]}")
        else:
            self.stack.pop()

    def handle_data(self, data):
        self.words.append(data)

    @property
    def text(self):
        return "".join(self.words)


def plain(text):
    """Without line ends and the marks of code."""
    return " ".join(text.replace("`", "").split())


def run(*arguments, status=0):
    environment = {k: v for k, v in os.environ.items() if not k.startswith(("ISOGLOSS_", "XDG_"))}
    done = subprocess.run([OPTIONS.isogloss, *map(str, arguments)], capture_output=True, text=True, timeout=120,
                          check=False, env=environment)
    if done.returncode != status:
        raise AssertionError(f"{arguments}: status {done.returncode}\n{done.stdout}\n{done.stderr}")
    return done


class Docs(unittest.TestCase):
    """One reference in each form, of all that is installed and of a vendor."""

    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.path = pathlib.Path(folder.name)
        (cls.path / "dialects").mkdir()
        (cls.path / "dialects/vendor.xml").write_text(VENDOR)
        cls.places = ["--plugins", OPTIONS.plugins, "--dialects", cls.path / "dialects"]
        cls.done = run("docs", "-o", cls.path / "site", *cls.places)
        cls.site = cls.path / "site"
        cls.pages = {str(p.relative_to(cls.site)): Parser(p.read_text()) for p in sorted(cls.site.rglob("*.html"))}
        run("docs", "-o", cls.path / "text", "--format", "markdown", *cls.places)
        cls.texts = {str(p.relative_to(cls.path / "text")): p.read_text()
                     for p in sorted((cls.path / "text").rglob("*.md"))}

    def listed(self, what, *more):
        return json.loads(run("list", what, "--json", *self.places, *more).stdout)

    def names(self):
        """Rows of name, page with place, and what it is, as the search box has them."""
        script = (self.site / "names.js").read_text()
        rows = json.loads(script[script.index("["):].rstrip().rstrip(";").replace(",\n]", "\n]"))
        self.assertNotIn("<", script)
        return rows

    def page_of(self, name):
        links = {link for other, link, _ in self.names() if other == name}
        self.assertTrue(links, f"{name} is not in names.js")
        return {link.partition("#")[0] for link in links}

    def test_the_path_of_the_first_page_is_printed(self):
        self.assertEqual(self.done.stdout, f"{self.site}/index.html\n")

    def test_pages_are_well_formed_and_hold_no_foreign_tag(self):
        for name, page in self.pages.items():
            self.assertEqual(page.faults, [], name)
            self.assertEqual([i for i, n in page.ids.items() if n > 1], [], name)
            self.assertEqual(page.tags["script"], 2, name)
            self.assertEqual((page.tags["h1"], page.tags["main"]), (1, 1), name)

    def test_every_link_and_anchor_resolves(self):
        seen = 0
        for name, page in self.pages.items():
            for link in page.links + page.loaded:
                if link.startswith("https://example.com/"):
                    self.assertEqual(name, "pages/vendor_press_syntax.html")
                    continue
                self.assertNotRegex(link, r"^\w+:|^//", name)
                file, _, anchor = urllib.parse.unquote(link).partition("#")
                target = os.path.normpath(os.path.join(os.path.dirname(name), file)) if file else name
                if target in self.pages:
                    self.assertTrue(not anchor or anchor in self.pages[target].ids, f"{name}: {link}")
                else:
                    self.assertTrue((self.site / target).is_file(), f"{name}: {link}")
                seen += 1
        self.assertGreater(seen, 10000)
        reached, waiting = set(), ["index.html"]
        while waiting:
            name = waiting.pop()
            if name in reached:
                continue
            reached.add(name)
            for link in self.pages[name].links:
                target = os.path.normpath(os.path.join(os.path.dirname(name), link.partition("#")[0] or name))
                waiting += [target] if target in self.pages else []
        self.assertEqual(set(self.pages) - reached, set(), "pages that no link reaches")

    def test_nothing_comes_from_the_network(self):
        loaded = {os.path.basename(link) for page in self.pages.values() for link in page.loaded}
        self.assertEqual(loaded, {"style.css", "names.js", "search.js"})
        for name in ("style.css", "search.js"):
            self.assertNotRegex((self.site / name).read_text(), r"url\(|@import|https?:|fetch|XMLHttp", name)

    def test_everything_that_is_installed_has_its_page(self):
        rows = self.names()
        known = {name for name, _, _ in rows}
        for what, key in (("syntaxes", "Id"), ("dependencies", "Id"), ("importers", "Id"), ("dialects", "Name"),
                          ("plugins", "Name"), ("fields", "Path"), ("diagnostics", "Code")):
            self.assertEqual({row[key] for row in self.listed(what)} - known, set(), what)
        for name, link, _ in rows:
            file, _, anchor = link.partition("#")
            self.assertIn(file, self.pages, name)
            self.assertTrue(not anchor or anchor in self.pages[file].ids, link)

    def test_a_syntax_shows_options_fields_and_cases(self):
        for syntax in self.listed("syntaxes"):
            (name,) = {page for page in self.page_of(syntax["Id"]) if page.startswith("pages/")}
            page = self.pages[name]
            self.assertIn(plain(syntax["Summary"]), plain(page.text), name)
            for option in syntax["Options"]:
                for key in ("Name", "Default", "Unit", "Doc"):
                    self.assertIn(plain(option.get(key, "")), plain(page.text), name)
                if "Minimum" in option:
                    self.assertRegex(page.text, f"(from )?{option['Minimum']:g}( to|\\b)", name)
                for choice in option.get("Choices", "").split("|"):
                    self.assertIn(choice, page.text, name)
            for field in syntax["Fields"]:
                self.assertIn(field["Path"], page.text, name)
                self.assertIn(", ".join(field["Access"]), page.text, name)
            if syntax["HasPage"]:
                self.assertGreater(page.tags["figcaption"], 1, name)

    def test_a_field_shows_who_writes_and_reads_it(self):
        text = (self.site / "fields/dwell.html").read_text()
        row = text[text.index('id="Dwell.Time"'):]
        row = row[:row.index("</tr>")]
        field = next(f for f in self.listed("fields") if f["Path"] == "Dwell.Time")
        for label, key in (("Written by", "Writers"), ("Read by", "Readers")):
            cell = re.search(f'<td data-label="{label}">(.*?)</td>', row, re.S)[1]
            self.assertEqual(re.findall(r"<code>(\w+)</code>", cell), field[key])

    def test_a_diagnostic_shows_text_explanation_and_example(self):
        for d in self.listed("diagnostics"):
            page = self.pages[f"diagnostics/{d['Code'].split('-')[0].lower()}.html"]
            for key in ("Code", "Severity", "Text", "Explanation", "Example"):
                self.assertIn(plain(d[key]), plain(page.text), d["Code"])

    def test_codes_by_dialect(self):
        text = (self.site / "codes.html").read_text()
        rows = dict(re.findall(r'<tr id="([^"]+)">(.*?)</tr>', text, re.S))
        dialects = [d["Name"] for d in self.listed("dialects")]
        for dialect in dialects:
            page = self.pages[f"dialects/{dialect}.html"]
            for row in self.listed("codes", "-d", dialect):
                self.assertIn(row["Code"], rows)
                if row["Kind"] == "code":
                    self.assertIn(row["Code"], page.text)
        self.assertIn("PeckDrillingCycleSyntax", rows["G83"])
        self.assertRegex(rows["M181"], r"VendorPressSyntax.*vendor\.html")
        self.assertNotIn("fanuc.html", rows["M181"])

    def test_a_dialect_shows_its_chain_as_a_graph_and_a_table(self):
        for dialect in self.listed("dialects"):
            chain = json.loads(run("dialect", dialect["Name"], "--graph", "--json", *self.places).stdout)
            text = (self.site / f"dialects/{dialect['Name']}.html").read_text()
            graph = text[text.index("<svg"):text.index("</svg>")]
            for stage in chain["Stages"]:
                for syntax in stage["Syntaxes"]:
                    self.assertIn(f">{syntax['As']}<", graph)
                    self.assertIn(f">{syntax['As']}<", text.replace(graph, ""))
        self.assertIn('href="../pages/vendor_press_syntax.html"', graph)
        self.assertIn("force=&quot;3&quot;", text)

    def test_a_machine_shows_its_tables_with_the_source_of_each_row(self):
        text = (self.site / "machines/klartext-5axis.html").read_text()
        page = self.pages["machines/klartext-5axis.html"]
        for link in ("../dialects/heidenhain.html", "#axes", "#table.tooloffsettable", "../pages/tool_offset_table.html"):
            self.assertIn(link, page.links)
        tools = text[text.index('id="table.tooloffsettable"'):]
        tools = tools[:tools.index("</table>")]
        self.assertRegex(tools, r'<td data-label="H">112.25</td>.*?<code>machine.xml:\d+</code>')
        self.assertRegex(tools, r"<code>backup/TOOL.T:\d+</code>")
        axes = text[text.index('id="axes"'):]
        axes = axes[:axes.index("</table>")]
        self.assertRegex(axes, r'<code>Maximum</code>.*?<td data-label="X">300</td>')
        self.assertRegex(axes, r'<code>Datum</code>.*?<td data-label="Z">420</td>', "named positions")
        self.assertIn("RETRACT.H", text[text.index('id="programs"'):])
        self.assertIn("../machines/klartext-5axis.html", self.pages["dialects/heidenhain.html"].links)
        self.assertIn("any, because the file holds tables alone", self.pages["machines/ac-table.html"].text)
        for machine in self.listed("machines"):
            self.assertIn(f"machines/{machine['Name']}.html", self.page_of(machine["Name"]))

    def test_a_vendor_stands_beside_ours(self):
        for name in ("syntaxes", "plugins", "dialects", "diagnostics", "fields", "codes"):
            self.assertRegex((self.site / f"{name}.html").read_text(), "(?i)vendor|VEN-0001", name)
        page = self.pages["pages/vendor_press_syntax.html"]
        for link in ("dwell_syntax.html", "peck_drilling_cycle_syntax.html", "../fields/dwell.html#Dwell.Time",
                     "../codes.html#G83", "../diagnostics/iso.html#ISO-0302", "#notes",
                     "vendor_press_syntax.cases.html", "../plugins/docs_vendor.html"):
            self.assertIn(link, page.links)
        text = (self.site / "pages/vendor_press_syntax.html").read_text()
        self.assertRegex(text, r"<figcaption>Before</figcaption><pre><code>\{\n<del>  &quot;Parsing")
        self.assertRegex(text, r"<figcaption>After</figcaption><pre><code>\{\n  &quot;Kept")
        self.assertRegex(text, r"<ins>  &quot;VendorPress")
        self.assertIn("<figcaption>Diagnostics any</figcaption>", text)
        self.assertIn("<figcaption>Options and tables</figcaption>", text)
        self.assertNotIn("#BeforeBuild", page.text)

    def test_dangerous_text_is_text(self):
        everything = {name: (self.site / name).read_text() for name in self.pages}
        for name, text in everything.items():
            self.assertNotRegex(text, r'(?i)(href|src)="?\s*(javascript|data|vbscript)|<script>|<img|<b>|<s>|<i>|<u>', name)
        page = self.pages["pages/vendor_press_syntax.html"]
        for shown in ('<script>alert("page")</script>', "<img src=x onerror=alert(1)>", '<div onclick="alert(3)">',
                      "</script><script>alert(4)</script>", "<kept> & so on", "<b>bold</b>"):
            self.assertIn(shown, page.text)
        self.assertNotIn("picture.png", "".join(page.loaded + page.links))
        self.assertIn("</p><script>alert(5)</script>", self.pages["diagnostics/ven.html"].text)

    def test_links_that_lead_nowhere_are_reported(self):
        dead = re.findall(r"the page of (\w+) links to '([^']+)'.*\[IG-0176\]", self.done.stderr)
        self.assertEqual(dead, [("VendorPressSyntax", link) for link in (
            "javascript:alert(1)", "javascript&#58;alert(2)", "no_such_page.md", "https://example.com/picture.png")])
        self.assertNotIn("IG-0176", run("docs", "-o", self.path / "ours").stderr)

    def test_markdown_has_the_same_pages_and_whole_links(self):
        self.assertEqual({name[:-5] for name in self.pages}, {name[:-3] for name in self.texts})
        for name, text in self.texts.items():
            prose = re.sub(r"^```.*?^```", "", text, flags=re.S | re.M)
            prose = re.sub(r"(?<!`)(`+)(?!`).*?(?<!`)\1(?!`)", "", prose)
            self.assertNotRegex(prose.replace("<br>", ""), r"</?(script|img|div|b|s|i|u|p)\b", name)
            for link in re.findall(r"\[[^\[\]]*\]\(([^)\s]+)\)", prose):
                if link.startswith(("https://", "#")):
                    continue
                file, _, anchor = link.partition("#")
                target = os.path.normpath(os.path.join(os.path.dirname(name), file))
                if target.endswith(".svg"):
                    self.assertIn("<svg", (self.path / "text" / target).read_text())
                    continue
                self.assertIn(target, self.texts, f"{name}: {link}")
                self.assertTrue(not anchor or f'<a id="{anchor}">' in self.texts[target], f"{name}: {link}")
        vendor = self.texts["pages/vendor_press_syntax.md"]
        self.assertIn("&lt;script>alert(\"page\")&lt;/script>", vendor)
        self.assertNotRegex(vendor, r"\[[^\]]*\]\(javascript")

    def test_only_a_folder_of_its_own_is_filled(self):
        mine = self.path / "mine"
        mine.mkdir()
        (mine / "letter.txt").write_text("Dear")
        done = run("docs", "-o", mine, status=2)
        self.assertIn("[IG-0175]", done.stderr)
        self.assertEqual([p.name for p in mine.iterdir()], ["letter.txt"])
        self.assertIn("[IG-0511]", run("docs", "-o", mine / "letter.txt", status=2).stderr)
        self.assertIn("[IG-0511]", run("docs", "-o", mine / "letter.txt/deeper", status=2).stderr)

    def test_a_second_reference_replaces_the_first(self):
        site, victim = self.path / "again", self.path / "victim.txt"
        site.mkdir()
        victim.write_text("stays")
        run("docs", "-o", site, *self.places)
        (site / "note.txt").write_text("mine")
        with (site / ".isogloss-docs").open("a") as listed:
            listed.write("../victim.txt\n")
        self.assertTrue((site / "pages/vendor_press_syntax.html").is_file())
        run("docs", "-o", site)
        self.assertFalse((site / "pages/vendor_press_syntax.html").exists())
        run("docs", "-o", site, "--format", "markdown")
        self.assertEqual(list(site.rglob("*.html")) + list(site.rglob("*.js")), [])
        self.assertTrue((site / "index.md").is_file() and (site / "note.txt").is_file() and victim.is_file())

    def test_the_same_reference_twice(self):
        again = self.path / "twice"
        run("docs", "-o", again, *self.places)
        for page in self.site.rglob("*"):
            if page.is_file():
                self.assertEqual(page.read_bytes(), (again / page.relative_to(self.site)).read_bytes(), page)
        texts = "".join(page.text for page in self.pages.values())
        self.assertNotIn(str(self.path), texts, "a path of this machine")

    def test_a_machine_that_does_not_link_has_a_page_that_says_so(self):
        folder = self.path / "machines"
        (folder / "bad").mkdir(parents=True)
        (folder / "bad/machine.xml").write_text(
            '<Machine xmlns="urn:isogloss:dialect:1" name="bad" title="A &lt;b&gt; machine" dialect="fanuc">'
            '<Dependencies><NoSuchTable/></Dependencies></Machine>')
        done = run("docs", "-o", self.path / "badsite", "--machines", folder, status=1)
        self.assertIn("NoSuchTable", done.stderr)
        text = (self.path / "badsite/machines/bad.html").read_text()
        self.assertIn("isogloss lint -m bad", text)
        self.assertIn("A &lt;b&gt; machine", text)

    def test_a_dialect_that_does_not_link_has_a_page_that_says_so(self):
        folder = self.path / "broken"
        folder.mkdir()
        (folder / "torn.xml").write_text(VENDOR.replace('name="vendor"', 'name="torn"').replace("VendorPress", "NoSuch"))
        done = run("docs", "-o", self.path / "torn", "--plugins", OPTIONS.plugins, "--dialects", folder, status=1)
        self.assertIn("NoSuchSyntax", done.stderr)
        self.assertIn("isogloss lint torn", (self.path / "torn/dialects/torn.html").read_text())


def main():
    global OPTIONS
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--isogloss", required=True)
    parser.add_argument("--plugins", required=True)
    OPTIONS, rest = parser.parse_known_args()
    unittest.main(argv=[sys.argv[0], *rest])


if __name__ == "__main__":
    main()
