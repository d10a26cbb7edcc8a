"""Names that strangers give, and paths that must stay inside."""

import unicodedata

import pytest
from hypothesis import given
from hypothesis import strategies as st

from core.workspace import NameRefused, check_name, clean_name, safe_parts
from core.workspace.names import MAX_LENGTH, inside

BAD = [
    "",
    "  ",
    "..",
    ".",
    ".hidden",
    "a/b",
    "a\\b",
    "../x",
    "/etc/passwd",
    "C:\\x",
    "nul\0l",
    "a\nb",
    "con",
    "COM1.bvh",
]
BAD += ["x" * 101, "\u202egnp.exe", "zero\u200bwidth", "a|b", "\ud800", "漢" * 90, 7, None]


@pytest.mark.parametrize("name", BAD)
def test_bad_names_are_refused_with_a_reason(name):
    with pytest.raises(NameRefused) as refusal:
        check_name(name)
    assert "dataset" in str(refusal.value)
    assert str(refusal.value).isprintable()


@pytest.mark.parametrize("name", ["walks", "Läufe und Sprünge", "歩行", "a b (2)", "14_20.take", "конь"])
def test_ordinary_names_in_any_script_are_kept(name):
    assert check_name(f" {name} ") == unicodedata.normalize("NFC", name)


@given(st.text(max_size=300))
def test_a_cleaned_name_is_always_accepted_and_stays_as_it_is(text):
    name = clean_name(text)
    assert check_name(name) == name
    assert clean_name(name) == name


@given(st.text(max_size=300))
def test_file_names_of_uploads_never_leave_the_folder(tmp_path_factory, text):
    root = tmp_path_factory.getbasetemp()
    try:
        parts = safe_parts(text)
    except NameRefused:
        return
    assert inside(root, *parts).resolve().is_relative_to(root.resolve())


@pytest.mark.parametrize(
    "name", ["../x.bvh", "a/../../x", "/etc/x.bvh", "\\\\host\\x", "C:\\x.bvh", "c:x", "a\0b", "", "."]
)
def test_upload_names_that_climb_are_refused(name):
    with pytest.raises(NameRefused):
        safe_parts(name)


def test_upload_names_keep_their_folders_and_suffix():
    assert safe_parts("walks/fast/a.bvh") == ["walks", "fast", "a.bvh"]
    assert safe_parts("walks\\a.bvh") == ["walks", "a.bvh"]
    long = safe_parts("n" * 300 + ".bvh.gz")[0]
    assert long.endswith(".bvh.gz") and len(long) <= MAX_LENGTH


def test_paths_through_symbolic_links_are_refused(tmp_path):
    (tmp_path / "root").mkdir()
    (tmp_path / "root" / "link").symlink_to(tmp_path)
    with pytest.raises(NameRefused):
        inside(tmp_path / "root", "link", "x")
    for part in ("..", "/etc/passwd", "a/../..", "nul\0"):
        with pytest.raises(NameRefused):
            inside(tmp_path / "root", part)
    assert inside(tmp_path / "root", "a", "b") == (tmp_path / "root").resolve() / "a" / "b"
