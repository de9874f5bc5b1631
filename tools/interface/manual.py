"""The manual's tables."""
BEGIN, END = "<!-- statuses: begin -->\n", "<!-- statuses: end -->\n"


def with_statuses(interface, page):
    """The page with its table of statuses renewed."""
    before, rest = page.split(BEGIN)
    after = rest.split(END)[1]
    lines = ["| value | status | meaning |", "|---:|---|---|"]
    lines += [f"| {value} | `{name}` | {text} |" for name, value, text in interface.statuses]
    return before + BEGIN + "\n".join(lines) + "\n" + END + after
