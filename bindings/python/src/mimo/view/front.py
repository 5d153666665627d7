"""The page: viser's, with another name, and with more room for the infant on narrow screens."""

from __future__ import annotations

from pathlib import Path

NAME = "MIMo"
SCRIPT = Path(__file__).with_name("front.js")


def front_page() -> bytes:
    """The served page."""
    import viser

    page = (Path(viser.__file__).parent / "client" / "build" / "index.html").read_text("utf-8")
    page = page.replace("<title>Viser</title>", f"<title>{NAME}</title>", 1)
    page = page.replace('content="Viser client"', f'content="{NAME}, the multimodal infant model"', 1)
    return page.replace("</head>", f"<script>{SCRIPT.read_text('utf-8')}</script></head>", 1).encode()
