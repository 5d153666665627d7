"""The methods of JavaScript's classes that follow from a function's parameters; others are written by hand."""

from __future__ import annotations

import re

import notes
from targets._javascript_words import (
    CLASSES,
    FLOATS,
    INTEGERS,
    NOTICE,
    base,
    camel,
    class_of,
    comment,
    number,
    pascal,
)

# What the classes of src/*.js do by hand: they own memory, keep arrays, or give functions of JavaScript away.
BY_HAND = (
    r"mimo_[a-z]+_(create|make|destroy|clone|layout|reset|step|send|receive|observe|state_\w+|render|mesh)"
    r"|mimo_env_(get|get_float|set|width|poses|texture|project|look_angles|follow|random|spontaneous)"
    r"|mimo_batch_(get|get_float|set|world|world_error|size|spontaneous)"
    r"|mimo_(recorder|recording)_.*"
    r"|mimo_scene_(name|xml|set_task|add_field|set_maturity|default_agent|add_agents?)|mimo_layout_.*"
    r"|mimo_stage_(update|draw)"
)
# Lengths of arrays that come without one.
FIXED = {"pose": 7, "place": 3, "axis": 3, "point": 3, "errors": 2}
MODULE = """{notice}import {{ Handle }} from "../handle.js";
import {{ check, integer, number, wasm, within }} from "../memory.js";

/** The methods of {name} that follow from the C interface's functions alone. */
export class {name}Calls extends Handle {{
{methods}}}
"""


def unreached(function: str) -> bool:
    return any(
        "JavaScript" in one["languages"] and re.fullmatch(one["functions"], function)
        for one in notes.read()["unreached"]
    )


def files(words) -> dict[str, str]:
    methods = {name: [] for name in CLASSES.values()}
    for function in words.api.functions:
        found = class_of(function.name)
        if found is None or re.fullmatch(BY_HAND, function.name) or function.name.endswith("_init"):
            continue
        if not unreached(function.name):
            methods[found[0]].append(Method(words, function, found[1]).text())
    return {
        f"{name.lower()}_calls": MODULE.format(notice=NOTICE, name=name, methods="\n".join(texts))
        for name, texts in methods.items()
        if texts
    }


class Method:
    """A method: what it takes, how each argument reaches the library, and what it returns."""

    def __init__(self, words, function, name):
        self.words, self.function, self.name = words, function, name
        self.takes, self.tags, self.before, self.passed, self.results = [], [], [], ["this.pointer"], []
        self.doc = [words.of_thing(function)]
        parameters = function.parameters[1:]
        lengths = set()
        for index, one in enumerate(parameters):
            following = parameters[index + 1] if index + 1 < len(parameters) else None
            if one.name in lengths:
                continue
            if following is not None and following.type == "size_t" and "*" in one.type:
                lengths.add(following.name)
            self.parameter(one, following)

    def parameter(self, one, following):
        api, name, kind = self.words.api, camel(one.name), number(self.words.api, base(one.type))
        constant, stars = one.type.startswith("const"), one.type.count("*")
        if stars == 0 and kind in INTEGERS.values():
            self.take(name, "number", one)
            self.passed.append(f'integer("{name}", {name})')
        elif stars == 0 and kind in FLOATS.values():
            self.take(name, "number", one)
            self.passed.append(f'number("{name}", {name})')
        elif one.type == "const char *":
            optional = "NULL" in one.doc
            self.take(name, "string | null" if optional else "string", one, optional)
            self.passed.append(f'frame.{"textOrNull" if optional else "text"}("{name}", {name})')
        elif one.type == "const char **":
            self.result(name, "string", f"frame.textAt({name}At)", "frame.place(4)")
        elif api.is_a("structs", base(one.type)) and constant:
            self.take(name, pascal(base(one.type)), one, True)
            null = " === undefined ? 0 : " if "NULL" in one.doc else ""
            self.passed.append(f'{name + null if null else ""}frame.struct("{base(one.type)}", {name})')
        elif api.is_a("structs", base(one.type)):
            struct = base(one.type)
            self.result(name, pascal(struct), f'frame.record("{struct}", {name}At)', f'frame.empty("{struct}")')
            if following is not None and following.type == "size_t":
                self.passed.append(f'frame.size("{struct}")')
        elif constant and kind and following is not None and following.type == "size_t":
            self.take(name, "ArrayLike<number>", one)
            self.passed.append(f'frame.array("{kind}", "{name}", {name})')
            self.passed.append(f"{name}.length")
        elif constant and kind and one.name in FIXED:
            optional = "NULL" in one.doc
            self.take(name, "ArrayLike<number>" + " | null" * optional, one, optional)
            given = f'frame.array("{kind}", "{name}", {name}, {FIXED[one.name]})'
            self.passed.append(f"{name} == null ? 0 : {given}" if optional else given)
        elif kind and not constant and one.name in FIXED:
            count = FIXED[one.name]
            read = f'[...frame.view("{kind}", {name}At, {count})]'
            self.result(name, "number[]", read, f"frame.place({8 * count})")
        elif kind and not constant:
            self.result(name, "number", f'frame.numberAt("{kind}", {name}At)', "frame.place(8)")
        else:
            raise notes.Undescribable(
                f"{self.function.name}: no rule of _javascript_methods.py for {one.type} {one.name}; by hand?"
            )

    def take(self, name, kind, one, optional=False):
        self.takes.append((name, optional))
        told = " ".join(self.words.text(one.doc, one.enum).split())
        self.tags.append((kind, name, told))

    def parameter_tags(self):
        """What it takes; only the last arguments can be left out."""
        required = max((index for index, (_, optional) in enumerate(self.takes) if not optional), default=-1)
        tags = []
        for index, (kind, name, told) in enumerate(self.tags):
            typed = re.sub(r"^(?=[A-Z])(?!Array)", 'import("./types.js").', kind)
            tags.append(f"@param {{{typed}}} {f'[{name}]' if index > required else name} {told}".rstrip())
        return tags

    def result(self, name, kind, read, place):
        self.before.append(f"const {name}At = {place};")
        self.passed.append(f"{name}At")
        self.results.append((name, kind, read))

    def returned(self):
        if not self.results:
            return "void", ""
        if len(self.results) == 1:
            return self.results[0][1], self.results[0][2]
        kinds = ", ".join(f"{name}: {kind}" for name, kind, _ in self.results)
        return f"{{{kinds}}}", "({ " + ", ".join(f"{name}: {read}" for name, _, read in self.results) + " })"

    def text(self):
        kind, read = self.returned()
        kind = re.sub(r"\b(?=[A-Z]\w+)", 'import("./types.js").', kind)
        tags = self.parameter_tags() + ([f"@returns {{{kind}}}"] if read else [])
        call = f"wasm().{self.function.name}({', '.join(self.passed)})"
        checked = self.function.returns == "mimo_status"
        lines = [*self.before, f"check({call});" if checked else f"{call};"] + [f"return {read};"] * bool(read)
        body = "".join(f"      {line}\n" for line in lines)
        head = f"  {self.name}({', '.join(name for name, _ in self.takes)}) {{\n"
        uses = "frame" if "frame." in body else ""
        inner = f"    {'return ' if read else ''}within(({uses}) => {{\n{body}    }});\n" if uses else dedented(body)
        return f"{comment(self.doc[0], '  ', tags)}{head}{inner}  }}\n"


def dedented(body):
    return re.sub(r"^  ", "", body, flags=re.MULTILINE)
