"""The tool's messages."""
import re

ERROR = re.compile(r"^(?:\S*/)?batch\.(?:c|cpp):(\d+):\d+: error: (.*?)(?: \[(SYM\d+)\])?$")


def calls_as_errors(text):
    """An error in a header of the system is that of the kernel from which it is called."""
    lines, why = [], None
    for line in text.splitlines():
        lines.append(line)
        if ": error: " in line:
            own, why = ERROR.match(line), re.search(r" \[SYM\d+\]$", line)
            why = None if own else why
        elif why and (note := re.match(r"(?:\S*/)?(batch\.(?:c|cpp):\d+:\d+): note: called from", line)):
            lines.append(f"{note.group(1)}: error: {why.group(0)}")
    return "\n".join(lines)
