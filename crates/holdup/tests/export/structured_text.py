"""Runs Structured Text from the syntax tree that blark makes of it.

    structured_text.py FIELDS SOURCE... < TRACE > ANSWERS

blark (an independent parser of IEC 61131-3) reads each source; the tree is checked for types and turned into Python,
function by function. LREAL is Python's float, IEEE double; REAL is rounded to single after each operation, which
gives the bits of single precision (53 digits are more than twice 24 and two). A division by zero, an index out of its
array, a type that does not fit and a variable that is not declared are faults, as in a PLC. FIELDS holds the names of
the settings in the order of the trace; the trace is that of trace.rs.
"""

import concurrent.futures
import ctypes
import re
import struct
import sys

from blark import transform as tree
from blark.parse import parse_source_code

SCALARS = {"BOOL": "False", "INT": "0", "DINT": "0", "REAL": "0.0", "LREAL": "0.0"}
INTEGERS = ("INT", "DINT", "ANY_INT")
REALS = ("REAL", "LREAL", "ANY_REAL")
OPERATORS = {"=": "==", "<>": "!=", "<": "<", ">": ">", "<=": "<=", ">=": ">="}


END = re.compile(r"(?<=\nEND_TYPE\n)|(?<=\nEND_FUNCTION\n)")


def parsed(text):
    """The declarations of a text."""
    result = parse_source_code(text)
    if result.exception is not None:
        raise result.exception
    return result.transform().items


def all_parsed(sources):
    """The declarations of several sources, and whether each computes in REAL.

    blark takes about 15 s for a whole source. So it is given one declaration at a time, each only once, on two cores;
    and a declaration in REAL is read as the one in LREAL: the type's name is all that differs.
    """
    parts = [[part for part in END.split(source) if part.strip()] for source in sources]
    single = [not re.search(r"\bLREAL\b", source) for source in sources]
    parts = [[re.sub(r"\bREAL\b", "LREAL", part) for part in some] for some in parts]
    different = list(dict.fromkeys(part for some in parts for part in some))
    with concurrent.futures.ProcessPoolExecutor(2) as pool:
        trees = dict(zip(different, pool.map(parsed, different)))
    return [([item for part in some for item in trees[part]], real) for some, real in zip(parts, single)]


class Fault(Exception):
    """What a compiler of Structured Text would refuse."""


def single(value):
    """The nearest number of single precision."""
    return ctypes.c_float(value).value


class Reference:
    """A scalar of the caller, given as VAR_IN_OUT."""

    __slots__ = ("owner", "name")

    def __init__(self, owner, name):
        self.owner, self.name = owner, name

    @property
    def value(self):
        return getattr(self.owner, self.name)

    @value.setter
    def value(self, new):
        setattr(self.owner, self.name, new)


class Array(list):
    """An array whose indices are checked, those below zero too."""

    def at(self, index):
        if index < 0:
            raise IndexError(index)
        return self[index]

    def assign(self, other):
        for mine, its in zip(self, other):
            mine.assign(its)


class Program:
    """The types, functions and function blocks of one source."""

    def __init__(self, items, is_single):
        self.is_single = is_single
        self.structures = {}
        self.functions = {}
        self.globals = {"single": single, "Reference": Reference, "Array": Array}
        units = [item for item in items if isinstance(item, (tree.Function, tree.FunctionBlock))]
        for item in items:
            if isinstance(item, tree.DataTypeDeclaration):
                self.structure(item.declaration)
            elif item not in units:
                raise Fault(f"{type(item).__name__} is not expected here")
        for unit in units:
            self.functions[str(unit.name).lower()] = Unit(self, unit)
        for unit in self.functions.values():
            unit.compile()

    def structure(self, declaration):
        fields = {}
        for element in declaration.declarations:
            for variable in element.variables:
                name = str(variable.variable.name).lower()
                if name in fields:
                    raise Fault(f"{declaration.name}.{name} is declared twice")
                fields[name] = self.declared(element.init)
        name = str(declaration.name).lower()
        self.structures[name] = {field: kind for field, (kind, _) in fields.items()}
        copies = [
            f"  self.{field} = other.{field}" if kind in SCALARS else f"  self.{field}.assign(other.{field})"
            for field, (kind, _) in fields.items()
        ]
        made = [f"  self.{field} = {initial}" for field, (_, initial) in fields.items()]
        code = [f"class {name}:", f" __slots__ = {tuple(fields)!r}", " def __init__(self):", *made]
        code += [" def assign(self, other):", *copies]
        exec("\n".join(code), self.globals)

    def declared(self, init):
        """Type of a declaration, and the Python that makes its initial value."""
        if isinstance(init, tree.ArrayTypeInitialization):
            (subrange,) = init.spec.subranges
            if str(subrange.start.value) != "0":
                raise Fault("an array does not begin at 0")
            kind, initial = self.initial(str(init.spec.type.type_name).lower(), None)
            length = int(subrange.stop.value) + 1
            return ("array", kind), f"Array({initial} for _ in range({length}))"
        spec = init.spec if hasattr(init, "spec") else init
        return self.initial(str(spec.type), getattr(init, "value", None))

    def initial(self, name, value):
        if name.upper() in SCALARS:
            kind = "REAL" if self.is_single and name.upper() == "LREAL" else name.upper()
            return kind, SCALARS[kind] if value is None else constant(value, kind)
        if name.lower() not in self.structures:
            raise Fault(f"the type {name} is not declared before it is used")
        return name.lower(), f"{name.lower()}()"


def constant(value, kind):
    if isinstance(value, tree.UnaryOperation) and str(value.op) == "-":
        return "-" + constant(value.expr, kind)
    if isinstance(value, tree.Boolean) and kind == "BOOL":
        return str(str(value.value).upper() == "TRUE")
    if isinstance(value, tree.Integer) and kind in INTEGERS:
        return str(int(value.value))
    if isinstance(value, tree.Real) and kind in REALS:
        number = float(value.value)
        return repr(single(number) if kind == "REAL" else number)
    raise Fault(f"{value} is no {kind}")


class Unit:
    """A function or a function block."""

    def __init__(self, program, unit):
        self.program, self.unit = program, unit
        self.name = str(unit.name).lower()
        self.inputs, self.in_outs, self.kinds, self.constants = {}, {}, {}, set()
        self.is_block = isinstance(unit, tree.FunctionBlock)
        self.result = None
        if not self.is_block:
            self.result, _ = program.initial(str(unit.return_type.type.type), None)
            self.kinds[self.name] = self.result
        made = [] if self.is_block else [f"  self.{self.name} = {SCALARS[self.result]}"]
        for block in unit.declarations:
            for item in block.items:
                for variable in item.variables:
                    made += self.declare(block, item, str(variable.variable.name).lower())
        slots = f" __slots__ = {tuple(self.kinds)!r}"
        code = [f"class frame_{self.name}:", slots, " def __init__(self):", *(made or ["  pass"])]
        exec("\n".join(code), program.globals)

    def declare(self, block, item, name):
        kind, initial = self.program.declared(item.init)
        if name in self.kinds:
            raise Fault(f"{self.name}.{name} is declared twice")
        self.kinds[name] = kind
        if isinstance(block, tree.InputOutputDeclarations):
            self.in_outs[name] = kind
            return []
        if isinstance(block, tree.InputDeclarations):
            self.inputs[name] = kind
        if str(getattr(block, "attrs", "")).lower().endswith("constant"):
            self.constants.add(name)
        return [f"  self.{name} = {initial}"]

    def compile(self):
        parameters = "".join(f", {name}" for name in [*self.in_outs, *([] if self.is_block else self.inputs)])
        code = [f"def run_{self.name}(f{parameters}):"]
        if not self.is_block:
            code.append(f" f = frame_{self.name}()")
            code += [f" f.{name} = {name}" for name in [*self.in_outs, *self.inputs]]
            code[0] = code[0].replace("(f, ", "(").replace("(f)", "()")
        code += self.statements(self.unit.body.statements, " ")
        code.append(" return f" if self.is_block else f" return f.{self.name}")
        exec("\n".join(code), self.program.globals)

    def statements(self, statements, indent):
        code = []
        for statement in statements:
            code += self.statement(statement, indent)
        return code or [indent + "pass"]

    def statement(self, statement, indent):
        inner = indent + " "
        if isinstance(statement, tree.AssignmentStatement):
            (variable,) = statement.variables
            target, kind = self.place(variable)
            if isinstance(variable, tree.SimpleVariable) and str(variable.name).lower() in self.constants:
                raise Fault(f"{self.name}: {variable.name} is constant")
            value = self.expression(statement.expression, kind)
            if isinstance(kind, str) and kind in SCALARS:
                return [f"{indent}{target} = {value}"]
            return [f"{indent}{target}.assign({value})"]
        if isinstance(statement, tree.IfStatement):
            code = [f"{indent}if {self.expression(statement.if_expression, 'BOOL')}:"]
            code += self.statements(statement.statements.statements, inner)
            for clause in statement.else_ifs:
                code.append(f"{indent}elif {self.expression(clause.if_expression, 'BOOL')}:")
                code += self.statements(clause.statements.statements, inner)
            if statement.else_clause is not None:
                code.append(f"{indent}else:")
                code += self.statements(statement.else_clause.statements.statements, inner)
            return code
        if isinstance(statement, tree.WhileStatement):
            head = f"{indent}while {self.expression(statement.expression, 'BOOL')}:"
            return [head, *self.statements(statement.statements.statements, inner)]
        if isinstance(statement, tree.ForStatement) and statement.step is None:
            control, kind = self.place(statement.control)
            first, last = (self.expression(end, kind) for end in (statement.from_, statement.to))
            head = f"{indent}for {control} in range({first}, {last} + 1):"
            return [head, *self.statements(statement.statements.statements, inner)]
        raise Fault(f"{type(statement).__name__} is not expected here")

    def place(self, variable):
        """Python for a variable, and its type."""
        simple = variable if isinstance(variable, tree.SimpleVariable) else variable.name
        name = str(simple.name).lower()
        if name not in self.kinds:
            raise Fault(f"{self.name}: {name} is not declared")
        code, kind = f"f.{name}", self.kinds[name]
        if name in self.in_outs and kind in SCALARS:
            code += ".value"
        for element in getattr(variable, "elements", ()):
            if isinstance(element, tree.FieldSelector):
                field = str(element.field.name).lower()
                fields = self.program.structures.get(kind, {}) if isinstance(kind, str) else {}
                if field not in fields:
                    raise Fault(f"{self.name}: {kind} has no field {field}")
                code, kind = f"{code}.{field}", fields[field]
            else:
                (subscript,) = element.subscripts
                if not (isinstance(kind, tuple) and kind[0] == "array"):
                    raise Fault(f"{self.name}: {code} is no array")
                code, kind = f"{code}.at({self.expression(subscript, 'DINT')})", kind[1]
        return code, kind

    def expression(self, expression, wanted):
        """Python for an expression that must have this type."""
        code, kind = self.typed(expression)
        return code if joined(kind, wanted, self.name) == wanted else code

    def typed(self, expression):
        """Python for an expression, and its type."""
        if isinstance(expression, tree.ParenthesizedExpression):
            code, kind = self.typed(expression.expr)
            return f"({code})", kind
        if isinstance(expression, (tree.SimpleVariable, tree.MultiElementVariable)):
            return self.place(expression)
        if isinstance(expression, tree.Boolean):
            return constant(expression, "BOOL"), "BOOL"
        if isinstance(expression, tree.Integer):
            return constant(expression, "DINT"), "ANY_INT"
        if isinstance(expression, tree.Real):
            return constant(expression, "REAL" if self.program.is_single else "LREAL"), "ANY_REAL"
        if isinstance(expression, tree.FunctionCall):
            return self.call(expression)
        if isinstance(expression, tree.UnaryOperation):
            code, kind = self.typed(expression.expr)
            if str(expression.op).upper() == "NOT" and kind == "BOOL":
                return f"(not {code})", "BOOL"
            if str(expression.op) == "-" and kind in REALS + INTEGERS:
                return f"(-{code})", kind
        if isinstance(expression, tree.BinaryOperation):
            return self.binary(expression)
        raise Fault(f"{self.name}: {expression} is not expected here")

    def binary(self, expression):
        left, left_kind = self.typed(expression.left)
        right, right_kind = self.typed(expression.right)
        kind = joined(left_kind, right_kind, self.name)
        op = str(expression.op).upper()
        if op in OPERATORS:
            # Standing beside AND and OR a comparison would be read differently by different compilers.
            for side in (expression.left, expression.right):
                if isinstance(side, tree.BinaryOperation):
                    raise Fault(f"{self.name}: {expression} needs parentheses")
            return f"({left} {OPERATORS[op]} {right})", "BOOL"
        if op in ("AND", "OR") and kind == "BOOL":
            # Both sides are computed, as IEC 61131-3 allows: none may be a fault where the other decides.
            return f"({left} {'&' if op == 'AND' else '|'} {right})", "BOOL"
        if op in "+-*" and kind in INTEGERS or op in "+-*/" and kind in REALS:
            code = f"({left} {op} {right})"
            return (f"single{code}" if kind == "REAL" else code), kind
        raise Fault(f"{self.name}: {op} of {kind} is not expected here")

    def call(self, call):
        unit = self.program.functions.get(str(call.name.name).lower())
        if unit is None or unit.is_block:
            raise Fault(f"{self.name}: there is no function {call.name.name} before it")
        given = {str(parameter.name.name).lower(): parameter.value for parameter in call.parameters}
        if set(given) != set(unit.in_outs) | set(unit.inputs):
            raise Fault(f"{self.name}: {unit.name} is called with {sorted(given)}")
        words = []
        for name, kind in unit.in_outs.items():
            place, its = self.place(given[name])
            if its != kind:
                raise Fault(f"{self.name}: {unit.name}.{name} is {kind}, not {its}")
            if kind not in SCALARS:
                words.append(place)
            elif place.endswith(".value"):
                words.append(place.removesuffix(".value"))
            else:
                owner, _, field = place.rpartition(".")
                words.append(f"Reference({owner}, {field!r})")
        words += [self.expression(given[name], kind) for name, kind in unit.inputs.items()]
        return f"run_{unit.name}({', '.join(words)})", unit.result


def joined(one, other, where):
    """The type of both, where they fit."""
    for literal, fitting in (("ANY_INT", INTEGERS), ("ANY_REAL", REALS)):
        if one == literal and other in fitting:
            return other
        if other == literal and one in fitting:
            return one
    if one == other:
        return one
    raise Fault(f"{where}: {one} does not fit {other}")


class Loop:
    """An instance of the function block, told the lines of a trace."""

    def __init__(self, program, fields):
        self.program, self.fields = program, [field.split(".") for field in fields]
        (self.unit,) = [unit for unit in program.functions.values() if unit.is_block]
        self.instance = program.globals[f"frame_{self.unit.name}"]()
        self.update = program.globals[f"run_{self.unit.name}"]
        self.fits = program.globals[f"run_{self.unit.name}_line_is_long_enough"]
        self.is_single = program.is_single

    def number(self, word):
        form, bits = (">f", int(word, 16).to_bytes(4, "big")) if self.is_single else (">d", bytes.fromhex(word))
        return struct.unpack(form, bits)[0]

    def bits(self, value):
        return struct.pack(">f" if self.is_single else ">d", value).hex()

    def tell_settings(self, words):
        for (*path, last), word in zip(self.fields, words, strict=True):
            owner = self.instance.settings
            for name in path:
                owner = getattr(owner, name)
            flag = isinstance(getattr(owner, last), bool)
            setattr(owner, last, word == "1" if flag else self.number(word))

    def answer(self, words):
        f = self.instance
        (f.sample_period, f.setpoint, f.controlled_variable, f.feed_forward, f.applied, f.manual_output) = (
            self.number(words[place]) for place in (0, 1, 3, 4, 6, 8)
        )
        f.measured, f.applied_known, f.mode = words[2] == "1", words[5] == "1", int(words[7])
        self.update(f)
        f.restart = False
        numbers = (f.manipulated_variable, f.wanted, f.load_estimate)
        output, wanted, estimate = (self.bits(number) for number in numbers)
        return f"{output} {wanted} {f.limited} {estimate} {f.status}"

    def switch_on(self, word):
        """What `o` answers; the block is switched on by its next call."""
        self.instance.restart, self.instance.start_output = True, self.number(word)
        return "1" if self.fits(self.instance.settings.law) else "0"


def main(fields, *sources):
    with open(fields, encoding="ascii") as file:
        fields = file.read().split()
    texts = []
    for source in sources:
        with open(source, encoding="ascii") as file:
            texts.append(file.read())
    programs = [Program(items, is_single) for items, is_single in all_parsed(texts)]
    loop = None
    for line in sys.stdin:
        kind, *words = line.split()
        if kind == "d":
            loop = Loop(programs[int(words[0])], fields)
        elif kind == "s":
            loop.tell_settings(words)
        elif kind == "o":
            print(loop.switch_on(words[0]))
        elif kind == "u":
            print(loop.answer(words))
        else:
            raise Fault(f"the trace has {kind}")


if __name__ == "__main__":
    main(*sys.argv[1:])
