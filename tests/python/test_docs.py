"""Pages that are made of what the library says."""

import importlib.util


def test_the_body_s_names(root):
    spec = importlib.util.spec_from_file_location("make_body", root / "docs" / "make_body.py")
    make_body = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(make_body)
    assert make_body.PAGE.read_text() == make_body.page(), "python docs/make_body.py writes it anew"
