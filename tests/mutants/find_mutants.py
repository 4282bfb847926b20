"""Finds the places of a source where a mutant can stand, with libclang: each is an expression or a statement of ours."""
import collections
import dataclasses
import pathlib
import re

from clang import cindex
from clang.cindex import CursorKind, TypeKind

NEGATED = {"<": ">=", "<=": ">", ">": "<=", ">=": "<", "==": "!=", "!=": "=="}
RELATIONAL = {"<": ("<=", ">="), "<=": ("<", ">"), ">": (">=", "<="), ">=": (">", "<"), "==": ("!=",), "!=": ("==",)}
ARITHMETIC = {"+": "-", "-": "+", "*": "/", "/": "*", "%": "*"}
LOGICAL = {"&&": "||", "||": "&&"}
COMPOUND = {"+=": "-=", "-=": "+=", "*=": "/=", "/=": "*="}
SWAPPED = {"min": "max", "max": "min", "fmin": "fmax", "fmax": "fmin", "sin": "cos", "cos": "sin", "floor": "ceil",
           "ceil": "floor"}
AXES = {a: b for group in ("XYZ", "ABC", "IJK", "UVW", "RQ") for a, b in zip(group, group[1:] + group[0])}
MEMBERS = {"Vec3": {"x": "y", "y": "z", "z": "x"}, "PlaneAxes": {"first": "second", "second": "tool", "tool": "first"}}
FUNCTIONS = (CursorKind.FUNCTION_DECL, CursorKind.CXX_METHOD, CursorKind.CONSTRUCTOR, CursorKind.CONVERSION_FUNCTION,
             CursorKind.DESTRUCTOR)
TEMPLATES = (CursorKind.FUNCTION_TEMPLATE, CursorKind.CLASS_TEMPLATE, CursorKind.CLASS_TEMPLATE_PARTIAL_SPECIALIZATION)
CLASSES = (CursorKind.NAMESPACE, CursorKind.STRUCT_DECL, CursorKind.CLASS_DECL)


@dataclasses.dataclass(frozen=True)
class Mutant:
    """`form`: "value" takes the place of the expression, "condition" negates it, "statement" leaves it out."""
    file: str
    start: int
    end: int
    operator: str
    form: str
    text: str  # what stands there instead; nothing for a condition and a statement

    def replaces(self, source):
        return one_line(source[self.start:self.end])

    def change(self, source):
        before = self.replaces(source)
        after = {"value": self.text, "condition": f"!({before})", "statement": "(left out)"}[self.form]
        return f"{before} → {one_line(after)}"


def one_line(text):
    return re.sub(r"\s+", " ", text).strip()


def read_source(path):
    """As a string with a character for each byte, because libclang counts bytes."""
    return pathlib.Path(path).read_bytes().decode("latin-1")


class Finder:
    """The mutants of the files of a folder, of all translation units that are read; those of a header once."""

    def __init__(self, root, files):
        self.root = pathlib.Path(root)
        self.sources = {str(self.root / name): (name, read_source(self.root / name)) for name in files}
        self.found = {}
        self.left_out = collections.Counter()
        self._left_out_places = set()

    def read(self, unit, arguments):
        tree = cindex.Index.create().parse(unit, args=arguments)
        errors = [d for d in tree.diagnostics if d.severity >= cindex.Diagnostic.Error]
        if errors:
            raise RuntimeError(f"libclang cannot read {unit}: {errors[0]}")
        for child in tree.cursor.get_children():
            self._declaration(child, None)

    def mutants(self):
        return sorted(self.found.values(), key=lambda m: (m.file, m.start, m.end, m.form, m.operator, m.text))

    # Declarations

    def _declaration(self, cursor, reason):
        where = cursor.location.file
        if where is None or where.name not in self.sources:
            return
        if cursor.kind in CLASSES:
            for child in cursor.get_children():
                self._declaration(child, reason)
        elif cursor.kind in TEMPLATES:
            for child in cursor.get_children():
                if child.kind == CursorKind.COMPOUND_STMT:
                    self._body(child, "a template")
                else:
                    self._declaration(child, "a template")
        elif cursor.kind in FUNCTIONS:
            self._function(cursor, reason)
        elif cursor.kind in (CursorKind.VAR_DECL, CursorKind.FIELD_DECL):
            self._initialiser(cursor, reason or "an initialiser of a constant or a member")

    def _function(self, cursor, reason):
        body = [c for c in cursor.get_children() if c.kind == CursorKind.COMPOUND_STMT]
        if not body:
            return
        head = self._text(cursor.extent.start.offset, body[0].extent.start.offset, cursor)
        if re.search(r"\b(constexpr|consteval)\b", head or ""):
            reason = reason or "a constexpr function"
        # Of a constructor, its initialisers of members as well.
        for child in cursor.get_children():
            if child.kind == CursorKind.COMPOUND_STMT:
                self._body(child, reason)
            elif cursor.kind == CursorKind.CONSTRUCTOR and child.kind.is_expression():
                self._visit(child, reason)

    def _initialiser(self, cursor, reason):
        """Behind the name: what stands before it, and in brackets after it, is the type, in which a number is no value."""
        for child in cursor.get_children():
            if not child.kind.is_expression() or child.extent.start.offset < cursor.location.offset:
                continue
            if "[" not in self._text(cursor.location.offset, child.extent.start.offset, cursor).split("=")[0].split("{")[0]:
                self._visit(child, reason)

    # Statements and expressions

    def _body(self, cursor, reason):
        for child in cursor.get_children():
            self._statement(child, reason)

    def _statement(self, cursor, reason):
        if cursor.kind == CursorKind.COMPOUND_STMT:
            self._body(cursor, reason)
            return
        if cursor.kind.is_expression():
            self._add(cursor, "removed statement", "statement", "", reason)
        self._visit(cursor, reason)

    def _visit(self, cursor, reason):
        kind = cursor.kind
        children = list(cursor.get_children())
        if kind == CursorKind.COMPOUND_STMT:
            self._body(cursor, reason)
        elif kind == CursorKind.LAMBDA_EXPR:
            for child in children:
                if child.kind == CursorKind.COMPOUND_STMT:
                    self._body(child, reason)
        elif kind in (CursorKind.IF_STMT, CursorKind.WHILE_STMT, CursorKind.FOR_STMT, CursorKind.CXX_FOR_RANGE_STMT,
                      CursorKind.SWITCH_STMT):
            self._controlled(cursor, children, reason)
        elif kind == CursorKind.CASE_STMT:
            for child in children[1:]:
                self._statement(child, reason)
        elif kind == CursorKind.DEFAULT_STMT:
            for child in children:
                self._statement(child, reason)
        elif kind == CursorKind.VAR_DECL:
            head = self._text(cursor.extent.start.offset, cursor.location.offset, cursor)
            constant = re.search(r"\b(constexpr|static)\b", head or "")
            self._initialiser(cursor, reason or ("an initialiser of a constant or a member" if constant else None))
        elif kind in CLASSES or kind in TEMPLATES or kind in FUNCTIONS:
            self._declaration(cursor, reason)
        elif kind not in (CursorKind.TYPE_ALIAS_DECL, CursorKind.TYPEDEF_DECL, CursorKind.STATIC_ASSERT,
                          CursorKind.ENUM_DECL, CursorKind.PARM_DECL):
            self._expression(cursor, children, reason)
            for child in children:
                self._visit(child, reason)

    def _controlled(self, cursor, children, reason):
        """if, while, for and switch: the head in parentheses, and the statements behind it."""
        path = cursor.location.file.name
        source = self.sources[path][1]
        start = source.index("(", cursor.extent.start.offset)
        is_constant = "constexpr" in source[cursor.extent.start.offset:start]
        close, semicolons = closing(source, start)
        declarations = [c for c in children if not c.kind.is_expression() and c.extent.start.offset < close]
        for child in children:
            if child.extent.start.offset > close:
                self._statement(child, reason)
                continue
            self._visit(child, reason or ("a constexpr condition" if is_constant else None))
            if not child.kind.is_expression() or is_constant:
                continue
            inside = any(d.extent.start.offset <= child.extent.start.offset < d.extent.end.offset for d in declarations)
            condition = {CursorKind.IF_STMT: not semicolons or child.extent.start.offset > semicolons[-1],
                         CursorKind.WHILE_STMT: True,
                         CursorKind.FOR_STMT: len(semicolons) == 2
                         and semicolons[0] < child.extent.start.offset < semicolons[1]}.get(cursor.kind, False)
            if condition and not inside:
                self._negate(child, reason)

    def _negate(self, cursor, reason):
        """Unless a mutant of its operator says the same."""
        inner = bare(cursor)
        negates_itself = operator_of(self, inner) in NEGATED or (
            inner.kind == CursorKind.UNARY_OPERATOR and self._own_text(inner).startswith("!")) or (
            inner.kind == CursorKind.CALL_EXPR and inner.spelling in ("operator==", "operator!="))
        if not negates_itself:
            self._add(cursor, "negated condition", "condition", "", reason)

    def _expression(self, cursor, children, reason):
        kind = cursor.kind
        if kind in (CursorKind.BINARY_OPERATOR, CursorKind.COMPOUND_ASSIGNMENT_OPERATOR):
            self._binary(cursor, children, reason)
        elif kind == CursorKind.UNARY_OPERATOR and children:
            text, operand = self._own_text(cursor), self._own_text(children[0])
            if text and text[0] == "-" and not text.startswith("--"):
                self._add(cursor, "sign", "value", operand, reason)
            elif text and text[0] == "!" and not text.startswith("!="):  # so C++20 writes a != of others
                self._add(cursor, "logical", "value", f"static_cast<bool>({operand})", reason)
        elif kind == CursorKind.CONDITIONAL_OPERATOR:
            self._negate(children[0], reason)
        elif kind in (CursorKind.INTEGER_LITERAL, CursorKind.FLOATING_LITERAL, CursorKind.CHARACTER_LITERAL,
                      CursorKind.CXX_BOOL_LITERAL_EXPR):
            self._literal(cursor, reason)
        elif kind == CursorKind.CALL_EXPR:
            self._call(cursor, reason)
        elif kind == CursorKind.MEMBER_REF_EXPR and children:
            self._member(cursor, children, reason)
        elif kind == CursorKind.DECL_REF_EXPR:
            self._enumerator(cursor, reason)

    def _binary(self, cursor, children, reason):
        if len(children) != 2:
            return
        op = operator_of(self, cursor)
        numbers = is_number(cursor.type)
        if op in RELATIONAL:
            for other in RELATIONAL[op]:
                self._replace_operator(cursor, children, op, other, "relational", reason)
        elif op in LOGICAL:
            self._replace_operator(cursor, children, op, LOGICAL[op], "logical", reason)
        elif op in ARITHMETIC and numbers:
            self._replace_operator(cursor, children, op, ARITHMETIC[op], "arithmetic", reason)
        elif op in COMPOUND and numbers:
            self._replace_operator(cursor, children, op, COMPOUND[op], "arithmetic", reason)

    def _replace_operator(self, cursor, children, op, other, operator, reason):
        left, right = children[0].extent, children[1].extent
        between = self._text(left.end.offset, right.start.offset, cursor)
        self._add(cursor, operator, "value",
                  self._text(cursor.extent.start.offset, left.end.offset, cursor) + between.replace(op, other, 1) +
                  self._text(right.start.offset, cursor.extent.end.offset, cursor), reason)

    def _literal(self, cursor, reason):
        text = self._own_text(cursor)
        if text in ("true", "false"):
            self._add(cursor, "constant", "value", "false" if text == "true" else "true", reason)
        elif re.fullmatch(r"'[A-Z]'", text):
            if text[1] in AXES:
                self._add(cursor, "axis", "value", f"'{AXES[text[1]]}'", reason)
        elif found := re.fullmatch(r"([\d']+)([uUlL]*)", text):
            number = int(found[1].replace("'", ""))
            self._add(cursor, "constant", "value", f"{0 if number == 1 else number + 1}{found[2]}", reason)
            if number > 1:
                self._add(cursor, "constant", "value", f"0{found[2]}", reason)
        elif re.fullmatch(r"[\d.][\d.eE'+-]*", text):
            number = float(text.replace("'", ""))
            self._add(cursor, "constant", "value", "0.0" if number == 1 else f"({text} + 1)", reason)
            if number:
                self._add(cursor, "sign", "value", f"(-{text})", reason)

    def _call(self, cursor, reason):
        arguments = list(cursor.get_arguments())
        name = cursor.spelling
        if name in ("operator==", "operator!="):
            self._add(cursor, "relational", "value", f"!({self._own_text(cursor)})", reason)
        elif name in ("operator+", "operator-") and len(arguments) == 2 and cursor.type.spelling.endswith("Vec3"):
            op = name[-1]
            self._replace_operator(cursor, arguments, op, ARITHMETIC[op], "arithmetic", reason)
        elif name in SWAPPED and arguments:
            text = self._own_text(cursor)
            self._add(cursor, "min/max, sin/cos", "value",
                      re.sub(rf"\b{name}\b(?=\s*[(<])", SWAPPED[name], text, count=1), reason)
        elif name in ("fabs", "abs") and len(arguments) == 1:
            self._add(cursor, "sign", "value", f"({self._own_text(arguments[0])})", reason)

    def _member(self, cursor, children, reason):
        holder = children[0].type.get_canonical().spelling.removeprefix("const ").split("::")[-1].rstrip(" &*")
        other = MEMBERS.get(holder, {}).get(cursor.spelling)
        text = self._own_text(cursor)
        if other and text.endswith(cursor.spelling):
            self._add(cursor, "axis", "value", text[:-len(cursor.spelling)] + other, reason)

    def _enumerator(self, cursor, reason):
        named = cursor.referenced
        if named is None or named.kind != CursorKind.ENUM_CONSTANT_DECL or named.semantic_parent.spelling != "Address":
            return
        names = [c.spelling for c in named.semantic_parent.get_children() if len(c.spelling) == 1]
        if cursor.spelling in names and len(names) > 1:
            other = names[(names.index(cursor.spelling) + 1) % len(names)]
            self._add(cursor, "axis", "value", self._own_text(cursor)[:-1] + other, reason)

    # Places

    def _add(self, cursor, operator, form, text, reason):
        where = cursor.extent.start.file
        if where is None or where.name not in self.sources:
            return
        name, source = self.sources[where.name]
        start, end = cursor.extent.start.offset, cursor.extent.end.offset
        own = source[start:end]
        if not own or "//" in own or "/*" in own or "#" in own:
            return
        if reason is None and cursor.type.kind == TypeKind.DEPENDENT:
            reason = "a template"
        key = (name, start, end, form, text)
        if reason is not None:
            if key not in self._left_out_places:
                self._left_out_places.add(key)
                self.left_out[reason] += 1
            return
        self.found.setdefault(key, Mutant(name, start, end, operator, form, text))

    def _text(self, start, end, cursor):
        where = cursor.location.file
        return self.sources[where.name][1][start:end] if where and where.name in self.sources else ""

    def _own_text(self, cursor):
        return self._text(cursor.extent.start.offset, cursor.extent.end.offset, cursor)


def bare(cursor):
    """Without parentheses and conversions that are not written."""
    while cursor.kind in (CursorKind.UNEXPOSED_EXPR, CursorKind.PAREN_EXPR):
        children = list(cursor.get_children())
        if len(children) != 1:
            break
        cursor = children[0]
    return cursor


def operator_of(finder, cursor):
    """libclang does not tell the operator: it is what stands between the operands."""
    if cursor.kind not in (CursorKind.BINARY_OPERATOR, CursorKind.COMPOUND_ASSIGNMENT_OPERATOR):
        return {"operator==": "==", "operator!=": "!="}.get(cursor.spelling) if cursor.kind == CursorKind.CALL_EXPR else None
    children = list(cursor.get_children())
    if len(children) != 2:
        return None
    return finder._text(children[0].extent.end.offset, children[1].extent.start.offset, cursor).strip()


def is_number(kind):
    canonical = kind.get_canonical().kind
    return TypeKind.UCHAR.value <= canonical.value <= TypeKind.LONGDOUBLE.value and canonical != TypeKind.BOOL


# A literal, or the mark between the digits of a number.
QUOTED = re.compile(r"\"(\\.|[^\"\\])*\"|'(\\.|[^'\\])'|'", re.S)


def closing(source, start):
    """Where the parenthesis that opens at `start` closes, and the semicolons inside."""
    depth, semicolons, i = 0, [], start
    while i < len(source):
        c = source[i]
        if c in "\"'":
            i = QUOTED.match(source, i).end()
            continue
        if source.startswith("//", i):
            i = source.index("\n", i)
        if c in "({[":
            depth += 1
        elif c in ")}]":
            depth -= 1
            if depth == 0:
                return i, semicolons
        elif c == ";" and depth == 1:
            semicolons.append(i)
        i += 1
    raise ValueError("a parenthesis does not close")
