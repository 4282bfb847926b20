// The grammars colour what they should, and leave little of real programs without a colour.
//   node grammar_test.mjs ISOGLOSS SOURCE
import assert from "node:assert/strict";
import { readdirSync, readFileSync, statSync } from "node:fs";
import path from "node:path";
import { createRequire } from "node:module";

const require = createRequire(import.meta.url);
const oniguruma = require("vscode-oniguruma");
const textmate = require("vscode-textmate");
const source = process.argv[3];

const wasm = readFileSync(require.resolve("vscode-oniguruma/release/onig.wasm"));
await oniguruma.loadWASM(wasm.buffer.slice(wasm.byteOffset, wasm.byteOffset + wasm.byteLength));
const registry = new textmate.Registry({
  onigLib: Promise.resolve({
    createOnigScanner: (patterns) => new oniguruma.OnigScanner(patterns),
    createOnigString: (text) => new oniguruma.OnigString(text),
  }),
  loadGrammar: async (scope) => {
    const file = `syntaxes/${scope.replace("source.isogloss.", "")}.tmLanguage.json`;
    return textmate.parseRawGrammar(readFileSync(file, "utf8"), file);
  },
});

const grammars = {};
for (const name of ["iso", "siemens", "klartext"]) grammars[name] = await registry.loadGrammar(`source.isogloss.${name}`);

// [grammar, line, piece, scope]
const pieces = [
  ["iso", "N10 G01 X1.5 Y-2. F500 (a comment)", "N10", "entity.name.label.sequence"],
  ["iso", "N10 G01 X1.5 Y-2. F500 (a comment)", "G01", "keyword.other.motion"],
  ["iso", "N10 G01 X1.5 Y-2. F500 (a comment)", "X", "variable.parameter.address"],
  ["iso", "N10 G01 X1.5 Y-2. F500 (a comment)", "1.5", "constant.numeric"],
  ["iso", "N10 G01 X1.5 Y-2. F500 (a comment)", "(a comment)", "comment.block"],
  ["iso", "O0100 (DRILL)", "O0100", "entity.name.function.program"],
  ["iso", "G54.1 P2 M98P100", "G54.1", "keyword.other.gcode"],
  ["iso", "G54.1 P2 M98P100", "M98", "keyword.other.mcode"],
  ["iso", "IF [#101 LT 5.] GOTO 100", "IF", "keyword.control"],
  ["iso", "IF [#101 LT 5.] GOTO 100", "#101", "variable.other"],
  ["iso", "IF [#101 LT 5.] GOTO 100", "LT", "keyword.operator.word"],
  ["iso", "#<_depth>=SQRT[4.]", "#<_depth>", "variable.other"],
  ["iso", "#<_depth>=SQRT[4.]", "SQRT", "support.function"],
  ["iso", "T12 M06", "T12", "entity.name.tag.tool"],
  ["iso", "/2 G00 Z50.", "/2", "keyword.control.skip"],
  ["iso", "%", "%", "punctuation.definition.tape"],
  ["siemens", "N10 G1 X=R1+5 F200 ; cut", "G1", "keyword.other.motion"],
  ["siemens", "N10 G1 X=R1+5 F200 ; cut", "R1", "variable.other"],
  ["siemens", "N10 G1 X=R1+5 F200 ; cut", "; cut", "comment.line"],
  ["siemens", "DEF REAL DEPTH=-10.5", "REAL", "storage.type"],
  ["siemens", "START: R2=R2+1", "START", "entity.name.label"],
  ["siemens", "IF R1<5 GOTOF END_OF", "GOTOF", "keyword.control"],
  ["siemens", "MSG(\"drill\")", "\"drill\"", "string.quoted"],
  ["siemens", "CYCLE81(50,0,2,-10)", "CYCLE81", "keyword.other.mode"],
  ["siemens", "X=$P_UIFR[1,X,TR]", "$P_UIFR", "variable.language"],
  ["siemens", "MY_SUB(3)", "MY_SUB", "entity.name.function"],
  ["klartext", "5 L X+10 Y-2,5 R0 FMAX M3", "L", "keyword.other.motion"],
  ["klartext", "5 L X+10 Y-2,5 R0 FMAX M3", "5", "entity.name.label.sequence"],
  ["klartext", "5 L X+10 Y-2,5 R0 FMAX M3", "R0", "storage.modifier.compensation"],
  ["klartext", "5 L X+10 Y-2,5 R0 FMAX M3", "FMAX", "keyword.other.mode"],
  ["klartext", "0 BEGIN PGM PART MM", "BEGIN PGM", "keyword.control"],
  ["klartext", "0 BEGIN PGM PART MM", "PART", "entity.name.function.program"],
  ["klartext", "7 TOOL CALL 3 Z S4000", "TOOL CALL", "keyword.other.mode"],
  ["klartext", "9 CALL LBL 2 REP3", "CALL LBL", "keyword.control"],
  ["klartext", "10 Q1 = Q2 + SIN Q3 ; angle", "Q1", "variable.other"],
  ["klartext", "10 Q1 = Q2 + SIN Q3 ; angle", "SIN", "support.function"],
  ["klartext", "11 CC X+0 Y+0", "CC", "keyword.other.motion"],
];

for (const [name, line, piece, scope] of pieces) {
  const begin = line.indexOf(piece);
  const at = begin + Math.floor((piece.length - 1) / 2);
  const token = grammars[name].tokenizeLine(line, textmate.INITIAL).tokens.find((t) => t.startIndex <= at && at < t.endIndex);
  assert.ok(
    token.scopes.some((s) => s.startsWith(scope)),
    `${name}: '${piece}' of '${line}' should be ${scope}, and is ${token.scopes.join(" ")}`,
  );
}

function* files(folder) {
  for (const entry of readdirSync(folder).sort()) {
    const file = path.join(folder, entry);
    if (statSync(file).isDirectory()) yield* files(file);
    else yield file;
  }
}

/** Share of what is not blank that has a scope of its own. */
function coloured(grammar, text) {
  let all = 0;
  let named = 0;
  let stack = textmate.INITIAL;
  for (const line of text.split(/\r\n|\r|\n/).slice(0, 400)) {
    const result = grammar.tokenizeLine(line, stack, 500);
    assert.ok(!result.stoppedEarly, `too slow: ${line.slice(0, 80)}`);
    stack = result.ruleStack;
    for (const token of result.tokens) {
      const size = line.slice(token.startIndex, token.endIndex).replace(/\s/g, "").length;
      all += size;
      if (token.scopes.length > 1) named += size;
    }
  }
  return { all, named };
}

const kinds = { siemens: "siemens", heidenhain: "klartext" };
const least = { iso: 0.97, siemens: 0.97, klartext: 0.97 };
const sums = {};
let count = 0;
for (const folder of ["fanuc", "haas", "iso", "mazak", "okuma", "syntec", "siemens", "heidenhain"]) {
  const kind = kinds[folder] ?? "iso";
  const root = path.join(source, "tests/programs", folder);
  try {
    statSync(root);
  } catch {
    continue;
  }
  const programs = [...files(root)].filter((f) => /\.(nc|mpf|spf|h|min|eia|tap|ngc)$/i.test(f));
  for (const file of programs.filter((_, i) => i % Math.ceil(programs.length / 12) === 0)) {
    const { all, named } = coloured(grammars[kind], readFileSync(file, "latin1"));
    const sum = (sums[kind] ??= { all: 0, named: 0 });
    sum.all += all;
    sum.named += named;
    ++count;
  }
}
assert.ok(count > 20, `only ${count} programs`);
for (const [kind, { all, named }] of Object.entries(sums)) {
  const share = named / all;
  console.log(`  ${kind}: ${(share * 100).toFixed(1)} % of the text is coloured`);
  assert.ok(share >= least[kind], `${kind}: only ${(share * 100).toFixed(1)} %`);
}
