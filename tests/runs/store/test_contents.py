from pathlib import Path

import pytest

from repro.runs.store.store import Store
from tests.small_stores import change, filled


@pytest.mark.parametrize(
    "what",
    [
        "update run set cost = cost + 1 where id = 2",
        "update run set x = x || x'00' where id = 2",
        "update run set seconds = 9 where id = 2",
        "update run set sha = '' where id = 2",
        "update curve set y = x'00' where id = 2",
        "delete from curve where id = 2",
        "update env set json = '{}'",
    ],
)
def test_digest_of_a_papers_rows_follows_all_that_is_stored_of_it(
    tmp_path: Path, what: str
) -> None:
    filled(tmp_path)
    with Store(tmp_path, writing=False) as store:
        before = store.contents()
        assert store.contents() == before
    change(tmp_path, what)
    with Store(tmp_path, writing=False) as store:
        assert store.contents().keys() == before.keys()
        assert store.contents() != before
