"""The table of docs/abi.md: what is promised, and what is experimental."""

from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PAGE = "docs/abi.md"
BEGIN, END = "<!-- what is promised, by ./dev interface -->", "<!-- end -->"


def files(api):
    before, rest = (ROOT / PAGE).read_text(encoding="utf-8").split(BEGIN)
    return {PAGE: f"{before}{BEGIN}\n\n{table(api)}\n\n{END}{rest.split(END, 1)[1]}"}


def table(api):
    lines = ["| header | | functions | structs and their members | constants |", "|---|---|---|---|---|"]
    for header in api.headers:
        for stability in ("stable", "experimental"):
            cells = [[one.name for one in of(api.functions, header, stability)], structs(api, header, stability)]
            cells.append([one.name for one in of(api.constants, header, stability)])
            if any(cells):
                named = " | ".join(", ".join(f"`{name}`" for name in cell) for cell in cells)
                lines.append(f"| `{header.name}` | {stability} | {named} |")
    return "\n".join(lines)


def of(things, header, stability):
    return [one for one in things if one.header == header.name and one.stability == stability]


def structs(api, header, stability):
    """The structs, and members of stable ones that are experimental."""
    found = [one.name for one in of(api.structs, header, stability)]
    if stability == "experimental":
        for struct in of(api.structs, header, "stable"):
            found += [f"{struct.name}.{one.name}" for one in struct.members if one.stability == "experimental"]
    return found
