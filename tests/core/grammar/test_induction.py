"""Learning grammars: the paper's basketball strings, section 5.1, and properties that hold for any sentences."""

from __future__ import annotations

import itertools

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from core.grammar.alignment import Hypotheses, align, align_contexts, align_pairs, links, ways
from core.grammar.constituents import Description, grammar_of, read_off, renamed
from core.grammar.induction import induce
from core.grammar.neighbours import END, Neighbours
from core.grammar.selection import select
from core.grammar.trees import leaves

LETTERS = "rdpsfm"
BASKETBALL = ("rfdpm", "rfdsm", "rdfsm", "rdpm", "rdsm", "rpm")
SOURCE = {
    "r" + "".join(x) + e + "m" for x in itertools.product(("f", ""), ("d", ""), ("f", "")) for e in "ps"
}  # of section 7
SENTENCES = st.lists(st.lists(st.integers(0, 3), min_size=1, max_size=6).map(tuple), min_size=1, max_size=7)


def spelled(word: str) -> tuple[int, ...]:
    return tuple(LETTERS.index(letter) for letter in word)


@pytest.fixture(scope="module")
def basketball():
    return induce(map(spelled, BASKETBALL))


def test_the_paper_s_basketball_strings(basketball) -> None:
    grammar = basketball.grammar
    assert len(grammar.rules) <= 11 and len(grammar.nonterminals) > 1
    assert all(grammar.accepts(spelled(word)) for word in BASKETBALL)
    unseen = SOURCE - set(BASKETBALL)
    assert len(unseen) == 8 and sum(grammar.accepts(spelled(word)) for word in unseen) >= 3


def test_no_wrong_basketball_string_of_up_to_six_letters_is_accepted_or_written(basketball) -> None:
    words = {"".join(word) for n in range(1, 7) for word in itertools.product(LETTERS, repeat=n)}
    assert {word for word in words if basketball.grammar.accepts(spelled(word))} <= SOURCE
    grammar = basketball.grammar
    written = {grammar.reconstruct(grammar.rule_indices(grammar.generate(seed))) for seed in range(100)}
    assert written <= set(map(spelled, SOURCE))


@settings(max_examples=40)
@given(SENTENCES, st.sampled_from(["side", "rules"]))
def test_merging_makes_no_kind_that_holds_itself(sentences, merge) -> None:
    def holding_themselves(trees):
        return {kind for kind, inside in Description(trees).inside.items() if kind in inside}

    before = induce(sentences, merge="no", align_by="pairs")
    if not holding_themselves(before.trees):
        assert not holding_themselves(induce(sentences, merge=merge, align_by="pairs").trees)


def test_basketball_shuffles_that_begin_or_end_otherwise_are_rejected(basketball) -> None:
    for word in SOURCE:
        for shuffled in set(itertools.permutations(word)):
            if shuffled[0] != "r" or shuffled[-1] != "m":
                assert not basketball.grammar.accepts(spelled("".join(shuffled)))


def test_section_5_1_is_learned() -> None:
    learned = induce([(0, 1, 4, 2, 3), (0, 1, 5, 2, 3), (0, 1, 4, 2, 3)])
    bits = learned.grammar.bits(learned.trees)
    assert bits.sentences == 3 and bits.grammar == pytest.approx(38.04, abs=0.005)
    assert learned.bits == bits.total


def longest_common(a, b) -> int:
    """Of subsequences, by recursion."""
    if not a or not b:
        return 0
    if a[0] == b[0]:
        return 1 + longest_common(a[1:], b[1:])
    return max(longest_common(a[1:], b), longest_common(a, b[1:]))


def spans_of(hypotheses: Hypotheses) -> dict[tuple[int, int, int], int]:
    rows = list(zip(*(column.tolist() for column in hypotheses), strict=True))
    assert len({row[:3] for row in rows}) == len(rows)
    return {row[:3]: row[3] for row in rows}


@settings(max_examples=60, deadline=None)
@given(SENTENCES)
def test_alignment_links_as_much_as_can_be_and_exchanges_what_is_between(sentences) -> None:
    different = list(dict.fromkeys(sentences))
    groups: dict[tuple[int, int, int], set] = {}
    for k, m in itertools.combinations(range(len(different)), 2):
        a, b = different[k], different[m]
        found = links(a, b)
        assert all(a[i] == b[j] for i, j in found)
        assert all(x[0] < y[0] and x[1] < y[1] for x, y in itertools.pairwise(found))
        assert len(found) == longest_common(a, b)
        for (i, j), (p, q) in itertools.pairwise([(-1, -1), *found, (len(a), len(b))]):
            if found and (p - i > 1 or q - j > 1):
                one, other = (k, i + 1, p), (m, j + 1, q)
                joined = groups.get(one, {one}) | groups.get(other, {other})
                groups.update(dict.fromkeys(joined, joined))
    spans = spans_of(align_pairs(different))
    assert set(spans) == set(groups)
    for one, other in itertools.combinations(spans, 2):
        assert (spans[one] == spans[other]) == (other in groups[one])


@settings(max_examples=40, deadline=None)
@given(SENTENCES)
def test_hypotheses_of_a_kind_have_one_context(sentences) -> None:
    different = list(dict.fromkeys(sentences))
    for hypotheses in (align_pairs(different), align_contexts(different)):
        contexts, words = {}, {}
        for (k, i, j), kind in spans_of(hypotheses).items():
            framed = (END, *different[k], END)
            contexts.setdefault(kind, set()).add((framed[i], framed[j + 1]))
            words.setdefault(kind, set()).add(different[k][i:j])
        assert all(len(own) == 1 for own in contexts.values())
        assert all(len(own) > 1 for own in words.values())


@settings(max_examples=40, deadline=None)
@given(SENTENCES, st.sampled_from(["saving", "branch", "leaf"]), st.booleans())
def test_constituents_do_not_cross_and_none_was_left_out_without_need(sentences, by, touching) -> None:
    different = list(dict.fromkeys(sentences))
    hypotheses = align_pairs(different)
    chosen = select(different, hypotheses, None, by, touching)
    for (k, i, j), kind in spans_of(hypotheses).items():
        clash = []
        for b in chosen[k]:
            if (b.start, b.end) == (i, j):
                assert b.kind == kind
                continue
            crossing = i < b.start < j < b.end or b.start < i < b.end < j
            meeting = not touching and i < j and b.start < b.end and (b.end == i or j == b.start)
            edge = (i == j and i in (b.start, b.end)) or (b.start == b.end and b.start in (i, j))
            clash.append(crossing or meeting or edge)
        assert any(clash) != any((b.start, b.end) == (i, j) for b in chosen[k])


OPTIONS = [
    {"align_by": align_by, "select_by": select_by, "touching": touching, "merge": merge}
    for align_by, select_by, touching, merge in (
        ("pairs", "saving", False, "side"),
        ("pairs", "branch", True, "no"),
        ("contexts", "leaf", True, "rules"),
        ("contexts", "saving", False, "no"),
    )
]


@pytest.mark.parametrize("options", OPTIONS)
@settings(max_examples=25, deadline=None)
@given(SENTENCES)
def test_every_training_sentence_is_reconstructed_and_accepted(options, sentences) -> None:
    grammar, trees = induce(sentences, **options)
    assert [leaves(tree) for tree in trees] == sentences
    assert [grammar.reconstruct(grammar.rule_indices(tree)) for tree in trees] == sentences
    assert all(grammar.accepts(sentence) for sentence in sentences)
    assert sum(rule.count for rule in grammar.rules if rule.left == "S") >= len(sentences)
    assert grammar.bits(trees).sentences == pytest.approx(sum(map(grammar.sentence_bits, trees)))


@settings(max_examples=30, deadline=None)
@given(SENTENCES, st.sampled_from(["pairs", "contexts"]))
def test_without_merging_no_new_neighbours_are_ever_made(sentences, align_by) -> None:
    grammar, _ = induce(sentences, align_by=align_by, merge="no", touching=False)
    seen = {pair for s in sentences for pair in itertools.pairwise((END, *s, END))}
    for word in itertools.chain.from_iterable(itertools.product(range(4), repeat=n) for n in range(1, 5)):
        if grammar.accepts(word):
            assert set(itertools.pairwise((END, *word, END))) <= seen


@settings(max_examples=40, deadline=None)
@given(SENTENCES)
def test_what_merging_kinds_would_gain_is_what_it_gains(sentences) -> None:
    different = list(dict.fromkeys(sentences))
    trees = read_off(different, select(different, align(different), None, "saving", True))
    grammar, numbered = grammar_of(trees)
    before = grammar.bits(numbered).total
    kinds = [name for name in grammar.nonterminals if name != "S"]
    for a, b in itertools.combinations(kinds, 2):
        merged, numbered = grammar_of([renamed(tree, {b: a}) for tree in trees])
        description = Description(trees)
        assert description.gain(a, b) == pytest.approx(merged.bits(numbered).total - before)
        description.merge(a, b)
        assert description.rules == {(rule.left, rule.right) for rule in merged.rules}


def test_new_neighbours_are_plausible_where_much_is_new() -> None:
    often, rare = [(0, 1)] * 20, [(2, 3), (2, 4), (5, 4)]
    neighbours = Neighbours([*often, *rare])
    assert neighbours.plausible(0, 1) and neighbours.plausible(END, 0)
    assert not neighbours.plausible(0, 0) and not neighbours.plausible(1, 0), "all that follows 0 and 1 is well known"
    assert neighbours.plausible(5, 3) and neighbours.plausible(2, 1)
    assert neighbours.allow({(END, 1)}, {(0,), (2, 2)}) and not neighbours.allow({(0, 1)}, {(), (0, 0)})
    assert neighbours.allow({(0, 1)}, {()})


@given(SENTENCES)
@settings(max_examples=30)
def test_auto_is_the_way_with_the_shorter_description(sentences) -> None:
    both = [induce(sentences, align_by=way).bits for way in ("pairs", "contexts")]
    assert induce(sentences).bits == min(both)


def test_ways_that_would_take_long_are_left_out() -> None:
    assert ways([(1, 2, 3)] * 5) == ("pairs", "contexts")
    assert ways([(0,) * 2000] * 2) == ("pairs",), "four million spans"
    assert ways([(0,) * 10] * 10_000) == ("contexts",), "five thousand million cells of tables"
    assert ways([(0,) * 2000] * 1000) == ("pairs",), "too many of both"


def test_nothing_to_learn_from() -> None:
    for nothing in ([], [(1, 2), ()]):
        with pytest.raises(ValueError, match="at least one terminal"):
            induce(nothing)
    with pytest.raises(ValueError, match="pairs, contexts"):
        induce([(1, 2)], align_by="words")
