"""Model names, addresses, keys and budgets: what is taken, and what is refused in which words."""

import pytest

from scegen.errors import InputError
from scegen.llm import Budget, Fault, LlmError, ModelName, Usage, parse_models
from scegen.llm.budget import Ledger, parse_budget
from scegen.llm.keys import NO_KEY, blot, key_for
from scegen.llm.naming import require_url

KEY = "sk-secret-0123456789"
URL = "http://127.0.0.1:9/v1"


@pytest.mark.parametrize(
    ("text", "url", "names"),
    [
        ("deepseek:deepseek-chat", None, ["deepseek:deepseek-chat"]),
        ("ollama:llama3:8b", None, ["ollama:llama3:8b"]),
        (" openai:a , anthropic:b ", None, ["openai:a", "anthropic:b"]),
        ("llama3:8b", URL, ["llama3:8b"]),
        ("my/model", URL, ["my/model"]),
        ("openai:a", URL, ["openai:a"]),
    ],
)
def test_models(text, url, names):
    assert [str(name) for name in parse_models(text, url=url)] == names


@pytest.mark.parametrize(
    ("text", "url", "words"),
    [
        ("gpt-4o", None, "known provider"),
        ("llama3:8b", None, "known provider"),
        ("openai:", None, "names no model"),
        ("openai:", URL, "names no model"),
        ("", None, "names no model"),
        (",", None, "names no model"),
    ],
)
def test_what_is_no_model(text, url, words):
    with pytest.raises(InputError, match=words):
        parse_models(text, url=url)


@pytest.mark.parametrize(
    "url", ["", "localhost:80", "ftp://x/v1", "http://", "http://x:99999/v1", "http://[::1"]
)
def test_what_is_no_address(url):
    with pytest.raises(InputError, match="not the address"):
        require_url(url)


@pytest.mark.parametrize(
    "url",
    [f"http://user:{KEY}@x/v1", f"http://{KEY}@x/v1", f"http://x/v1?key={KEY}", f"http://x/#{KEY}"],
)
def test_an_address_with_a_key_is_refused_without_showing_it(url):
    with pytest.raises(InputError) as refused:
        require_url(url)
    assert KEY not in refused.value.render()
    assert "SCEGEN_LLM_KEY" in refused.value.render()


def test_keys_come_from_the_environment():
    name = ModelName("deepseek", "deepseek-chat")
    assert key_for(name, {"DEEPSEEK_API_KEY": f" {KEY}\n"}, url=None) == KEY
    both = {"DEEPSEEK_API_KEY": "other-key", "SCEGEN_LLM_KEY": KEY}
    assert key_for(name, both, url=URL) == KEY
    # the key for another endpoint does not go to the provider
    assert key_for(name, both, url=None) == "other-key"


def test_where_no_key_is_needed():
    assert key_for(ModelName("ollama", "x"), {}, url=None) == NO_KEY
    assert key_for(ModelName("compatible", "x"), {}, url=URL) == NO_KEY
    # nobody's key goes to an endpoint that names no provider
    assert key_for(ModelName("compatible", "x"), {"OPENAI_API_KEY": KEY}, url=URL) == NO_KEY


def test_a_missing_key_names_its_variable():
    with pytest.raises(InputError, match="ANTHROPIC_API_KEY"):
        key_for(ModelName("anthropic", "x"), {}, url=None)


@pytest.mark.parametrize("key", ["sk-\n-injected: header", "sk-ключ-ключ", "two words here"])
def test_a_broken_key_is_refused_without_showing_it(key):
    with pytest.raises(InputError) as refused:
        key_for(ModelName("openai", "x"), {"OPENAI_API_KEY": key}, url=None)
    assert key not in refused.value.render()


def test_blotting():
    assert blot(f"a {KEY} b {KEY}", KEY) == "a [key] b [key]"
    assert blot("ollama serves ollama", "ollama") == "ollama serves ollama"


@pytest.mark.parametrize(
    ("text", "budget"),
    [
        ("20000", Budget(20_000)),
        ("20k", Budget(20_000)),
        ("1.5k tokens", Budget(1_500)),
        ("0.10usd", Budget(cost_usd=0.1)),
        ("$2", Budget(cost_usd=2.0)),
        ("20k, 0.10 USD", Budget(20_000, 0.1)),
    ],
)
def test_budgets(text, budget):
    assert parse_budget(text) == budget


@pytest.mark.parametrize("text", ["", "much", "1.5", "-3", "0", "0usd", "1e9", "nan", "20k,"])
def test_what_is_no_budget(text):
    with pytest.raises(InputError) as refused:
        parse_budget(text)
    assert "--llm-budget" in refused.value.render()


def test_requests_side_by_side_do_not_exceed_the_budget_together():
    ledger = Ledger(Budget(tokens=100))
    most = Usage(input_tokens=20, output_tokens=30)
    ledger.hold(most)
    ledger.hold(most)
    with pytest.raises(LlmError) as refused:
        ledger.hold(Usage(output_tokens=1))
    assert refused.value.fault.kind == "budget"
    ledger.settle(most, Usage(input_tokens=10, output_tokens=10))
    ledger.hold(Usage(output_tokens=30))
    with pytest.raises(LlmError):
        ledger.hold(Usage(output_tokens=1))


def test_a_budget_in_dollars():
    ledger = Ledger(Budget(cost_usd=1.0))
    ledger.hold(Usage(cost_usd=0.6))
    with pytest.raises(LlmError, match=r"0\.4000 of the budget's 1 USD"):
        ledger.hold(Usage(cost_usd=0.5))


def test_a_fault_says_who():
    fault = Fault(kind="timeout", message="gave no answer in time")
    named = fault.named(agent="road", model="openai:x")
    assert named.in_words() == "openai:x, agent road: gave no answer in time"
