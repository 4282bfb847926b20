// The host's own diagnostics: of chains that are put together, and of plugins.
#include "report/diagnostic_tables.hpp"

namespace isogloss {

std::vector<DiagnosticInfo> link_diagnostics() {
  using enum Severity;
  return {
      // links: 0200-0299
      {error, "IG-0201", "no plugin '{0}' in the folders searched",
       "The dialect names a plugin that no plugin folder holds, or that could not be loaded. `isogloss doctor` lists "
       "the folders and says of each file why it was not loaded.",
       R"(<Plugin name="isso"/>)"},
      {error, "IG-0202", "no syntax '{0}' in the dialect's plugins",
       "An element of the chain must be the id of a syntax that one of the dialect's plugins contributes.",
       "<DrilingCycleSyntax/>"},
      {error, "IG-0203", "no dependency '{0}' in the dialect's plugins",
       "An element of <Dependencies> must be the id of a dependency that one of the dialect's plugins contributes.",
       "<IsoCordinateTable/>"},
      {error, "IG-0204", "{0} has no option '{1}'",
       "The attributes of a syntax or dependency are its options; `isogloss inspect` lists them.",
       R"(<BoringCycleSyntax retrakt="feed-to-r"/>)"},
      {error, "IG-0205", "option '{0}' of {1} must be {2}, not '{3}'",
       "The value is not of the option's type, or lies outside its range or choices.",
       R"(<DwellSyntax p-unit="hours"/>)"},
      {error, "IG-0206", "{0} must stand after {1} ({2})",
       "The written order of a chain is the order in which it runs, and this syntax needs what the other one writes. "
       "Nothing is re-sorted; `isogloss lint --suggest` prints an order that satisfies every syntax.",
       "<IncrementalResolveSyntax/> <PositioningModeSyntax/>"},
      {error, "IG-0207", "{0} must stand before {1} ({2})",
       "The written order of a chain is the order in which it runs, and this syntax has to act first. Nothing is "
       "re-sorted; `isogloss lint --suggest` prints an order that satisfies every syntax.",
       "<LinearMotionSyntax/> <CircularMotionSyntax/>"},
      {error, "IG-0208", "{0} needs {1}, and nothing in the chain or the initial state writes it",
       "The syntax declares the field as required. Add the syntax that writes it, or an initial value.",
       "<McXyzSyntax/> alone"},
      {error, "IG-0209", "{0} declares {1} as {2}, {3} declares it as {4}",
       "A field has one type and one life. Two plugins that disagree about it cannot stand in one chain.",
       "Feedrate.FeedrateValue as number and as symbol"},
      {error, "IG-0210", "{0} claims the slot '{1}', which {2} holds already ({3})",
       "Only one syntax of a chain may claim an exclusive slot. Remove one, or write override=\"true\" where both are "
       "meant.",
       "two work offset syntaxes"},
      {error, "IG-0211", "{0} needs the service {1}, and no dependency provides it",
       "Add a dependency that provides the service; `isogloss list dependencies` says which do.",
       "<ToolHeightOffsetSyntax/> without <ToolOffsetTable/>"},
      {note, "IG-0212", "{0} writes {1}, which nothing reads",
       "No syntax of the chain, no exporter and no standard section reads the field. A modal field that only its "
       "writer reads is not reported: the writer remembers a value in it.",
       "Acme.Counter"},
      {error, "IG-0213", "option '{1}' of {0} has no default, and the dialect gives no value",
       "The dialect must give every option that has no default.", "<AcmeSyntax/>"},
      {error, "IG-0214", "no field '{0}' in this chain",
       "An initial value, a pattern or a setting names a field that no syntax of the chain and no standard section "
       "declares.",
       R"(<Field path="PlaneSelct.Term" value="…"/>)"},
      {error, "IG-0215", "'{0}' is not a valid {1} for {2}", "The text is not of the field's type.",
       R"(<Field path="SpindleSpeed.SpindleSpeed_rpm" value="fast"/>)"},
      {error, "IG-0216", "the chain has {0} syntaxes; {1} is the most",
       "A chain is limited so that its wake lists "
       "stay short.",
       "a generated dialect"},
      {error, "IG-0217", "{0} has no row of the element '{1}'; its rows are <{2}>",
       "The rows of a dependency's table are elements of one name with a key attribute.",
       R"(<IsoCoordinateTable><Ofset id="…"/></IsoCoordinateTable>)"},
      {error, "IG-0218", "a row of {0} needs the attribute '{1}'", "The attribute names the row.",
       R"(<Offset X="10"/>)"},
      {error, "IG-0219", "{0} has no column '{1}'", "A row's attributes are its key and the table's columns.",
       R"(<Offset id="…" Q="10"/>)"},
      {error, "IG-0220", "'{1}' is not a valid value for column '{0}'{2}",
       "A column's values are numbers within its range, or text where it says so.", R"(<Offset id="…" X="ten"/>)"},
      {error, "IG-0221", "{0} looks ahead but does not stand in the stage PostLogic: move it to <PostLogic>",
       "Only post-logic syntaxes see the window of executed blocks.", "a radius compensation under <Logic>"},
      {error, "IG-0222", "{0} declares the text field {1} as modal",
       "Text lives for one block; modal fields hold "
       "numbers and names.",
       "Acme.Message"},
      {error, "IG-0223", "{0} is inspecting, but does not stand in the stage Inspection: move it to <Inspection>",
       "Leftovers are known only when every other syntax has run.", "UnconsumedCheckSyntax under <Logic>"},
      {error, "IG-0224", "{0} fields are read as they were before the block; a chain keeps {1} at most",
       "A syntax that declares a field as `previous` makes the host keep a copy of it. Leave out syntaxes that the "
       "machine does not need.",
       "a generated dialect"},
      {warning, "IG-0235", "no diagnostic has the code '{0}', so its severity changes nothing",
       "A severity belongs to a diagnostic of the host or of a plugin that is installed. `isogloss list diagnostics` "
       "names all of them.",
       R"(<Severity code="ISO-301" is="note"/>)"},
      {warning, "IG-0242", "{0} wakes while {1} has a value, and no block begins with one: declare its life as modal",
       "A block begins with the modal fields of the block before it and with its words. A field of another life has no "
       "value then, so the syntax is never called for it.",
       "ig::Field<bool> {\"Acme.IsOn\", ig::wake_while}"},
      {error, "IG-0241", "{0} and {1} both answer {2}, and neither says which of them comes first",
       "Two syntaxes that take one code both act on it: a hole is drilled twice, or gets one rapid move too many. "
       "Remove one of them from the chain. Where both must stand, declare the order with after and before, or write "
       "override=\"true\" on the second element.",
       "a vendor's drilling cycle for G81 beside DrillingCycleSyntax"},
      {error, "IG-0243", "{0}: '{1}' is not the path of a code: write Parsing.Flags.{1}",
       "The paths of codes begin with Parsing.Flags. or Parsing.; scanners fill no other fields.", "codes=\"M201\""},
      {warning, "IG-0244", "{0}: the pattern '{2}' of the option {1} matches no field of this chain",
       "Nothing of the option's kind in the chain has such a path, so the pattern is ignored. `isogloss list fields` "
       "prints the paths that exist.",
       R"(lengths="Parsing.G81.?{inch}")"},
      {error, "IG-0240",
       "{0} acts in this block, though nothing that it declares wakes it: its build() must check the block",
       "Found by run --checked --call-all, which calls every syntax in every block: a syntax that depends on not being "
       "called gives another result as soon as another declaration wakes it. This is a fault of the plugin.",
       "a syntax that reads a word without asking whether the block holds it"},
      // libraries and plugins: 0300-0399
      {error, "IG-0301", "{0}: not a shared library ({1})",
       "The file in a plugin folder ends in .so but cannot be read as a shared library of this machine, or it is "
       "damaged: copy it again, or build it anew. Its tables are looked at before it is loaded.",
       "notes.so"},
      {error, "IG-0302", "{0}: no symbol ig_plugin_v1",
       "A plugin exports the function ig_plugin_v1. Build it with isogloss_add_plugin().", "libfoo.so"},
      {error, "IG-0303", "{0}: cannot be loaded ({1})",
       "The dynamic linker refused the library: most often a symbol or a library that it needs is missing.",
       "a plugin linked against a missing library"},
      {error, "IG-0304", "{0}: contract version {1}, this host speaks {2}",
       "The plugin was built for another major version of the contract. Ask its vendor for a build for this one.",
       "an old plugin"},
      {error, "IG-0305", "{0}: bad descriptor: {1}",
       "What ig_plugin_v1() returned breaks the contract, so nothing of the plugin is used.", "a null id"},
      {error, "IG-0306", "{0}: the name '{1}' is already used by {2}",
       "Two plugins of one name lie in the folders; the first one found is used.", "two copies of iso.so"},
      {error, "IG-0307", "{0} contributes {1}, which {2} contributes already",
       "The ids of syntaxes and dependencies are unique over all plugins of a dialect.", "two DrillingCycleSyntax"},
      {error, "IG-0308", "{0} could not be created: {1}", "The syntax or dependency refused to start.",
       "an option that the plugin cannot use"},
      {warning, "IG-0309", "{0} exports {1} symbols besides ig_plugin_v1, {2} for instance",
       "Another plugin may bind to a symbol that leaks from this one. Build with isogloss_add_plugin().",
       "a plugin built by hand"},
      {warning, "IG-0310", "{0} declares the diagnostic {1}, which {2} declares already",
       "Codes of diagnostics are unique, so that `isogloss explain CODE` and the severities of a dialect mean one of "
       "them. Each plugin has a prefix of its own.",
       "two plugins with ACM-0001"},
      {error, "IG-0311", "{0} is not loaded, because {2} can write {1}: {3}",
       "Whoever can write a plugin, or the folder that holds it or a link to it, chooses what runs as you. A group may "
       "write where you are one of it; others may write a folder with the sticky bit where the entry in it is yours or "
       "root's. --any-plugins, or ISOGLOSS_ANY_PLUGINS=1, loads such plugins all the same.",
       "a plugin folder with the mode 0777"},
      {error, "IG-0350", "{0} of plugin {1} threw an exception out of {2}(), whose result cannot be trusted: {3}",
       "No exception may leave a function of the contract, which is plain C. The host caught it and goes on where that "
       "is possible. This is a fault of the plugin; the SDK catches what its syntaxes throw.",
       "a plugin built without the SDK that throws in build()"},
  };
}

}  // namespace isogloss
