"""The SHA-256 of every file a document rests on."""

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterable


def file_hashes(names: "Iterable[str]") -> "list[dict[str, str]]":
    """Name and hash of each file, in the order first read."""
    import hashlib

    made = []
    for name in dict.fromkeys(names):
        with open(name, "rb") as file:
            made.append({"name": name, "sha256": hashlib.file_digest(file, "sha256").hexdigest()})
    return made
