"""The report holds every row, fetches nothing, and stays small with thousands of them."""

import csv
import io
import json
import re

import pyarrow.parquet as pq
import pytest

from scegen.campaign.analysis.coverage import coverage
from scegen.campaign.report.page import campaign_page, outlook
from scegen.campaign.report.write import write_report
from scegen.campaign.rows import SCHEMA
from scegen.campaign.store import Store
from scegen.campaign.table import query
from scegen.errors import InputError


@pytest.fixture(scope="module")
def report(first, tmp_path_factory):
    folder = tmp_path_factory.mktemp("report")
    write_report(Store(first[0]), folder, 1, lambda _: None)
    return folder


def rows_in(page):
    (data,) = re.findall(
        r'<script type="application/json" id="data">(.*?)</script>', page, re.DOTALL
    )
    return json.loads(data)["rows"]


def test_every_scenario_is_in_the_page_and_in_the_tables(first, report):
    page = (report / "index.html").read_text("utf-8")
    made = first[1].counted.rows - first[1].counted.failed
    assert len(rows_in(page)) == made
    assert pq.read_table(report / "table.parquet").schema.names == SCHEMA.names
    listed = list(csv.reader(io.StringIO((report / "table.csv").read_text("utf-8"))))
    assert listed[0] == SCHEMA.names
    assert len(listed) == first[1].counted.rows + 1
    assert "does not describe a traffic situation" in page


def test_nothing_is_fetched_and_links_lead_somewhere(report):
    page = (report / "index.html").read_text("utf-8")
    assert not re.search(r'(?:src|href)="(?:https?:)?//', page)
    links = set(re.findall(r'href="([^"#]+)"', page))
    assert links
    for link in links:
        shown = (report / link).read_text("utf-8")
        for file in re.findall(r'href="(scenarios/[^"]+)"', shown):
            assert (report / file).exists()


def test_thousands_of_rows_stay_data(first):
    store = Store(first[0])
    some = query(store, "SELECT * FROM rows WHERE status = 'made'").to_pylist()
    many = (some * (5000 // len(some) + 1))[:5000]
    page = campaign_page(many, coverage(store, many), outlook(many, 5), {}, store.manifest())
    assert len(rows_in(page)) == 5000
    assert page.count("<tr>") < 500
    assert len(page) < 3_000_000


def test_only_good_ones_stand_out_and_every_logical_scenario_first(first):
    rows = query(Store(first[0]), "SELECT * FROM rows WHERE status = 'made'").to_pylist()
    logical = len({(row["description"], row["logical_name"]) for row in rows})
    twice = [*rows, *rows]  # as two concretizations
    found = outlook(twice, len(twice))
    assert {*found.critical} == {*range(len(twice))}
    shown = [twice[n] for n in found.critical]
    assert len({(r["description"], r["logical_name"]) for r in shown[:logical]}) == logical
    worst = found.critical[0]
    twice[worst] = twice[worst] | {"claims_held": 0}
    fewer = outlook(twice, len(twice))
    assert worst not in {*fewer.critical, *fewer.different}
    bad = [row | {"checks": {"schema": "failed"}} for row in rows]
    assert not outlook(bad, 3).critical


def test_what_is_no_campaign_is_told(tmp_path):
    with pytest.raises(InputError, match="no campaign"):
        write_report(Store(tmp_path), tmp_path / "report", 1, lambda _: None)


def test_a_broken_file_is_not_shown(copied, tmp_path):
    for name in [n for n in copied.objects() if n.endswith("yaml")]:
        copied.object_path(name).write_text("level: concrete")
    with pytest.raises(InputError, match="not what was written"):
        write_report(copied, tmp_path / "report", 1, lambda _: None)
