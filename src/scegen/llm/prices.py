"""What tokens cost, by the list prices that ship with the library; nothing is looked up online."""

from __future__ import annotations

from genai_prices import Usage as PricedUsage
from genai_prices import calc_price

from scegen.llm.naming import COMPATIBLE, PROVIDERS, ModelName


def cost_usd(name: ModelName, input_tokens: int, output_tokens: int) -> float | None:
    """List price in US dollars, None if it is not known; local models are free.

    Prompt caches and discounts by the hour are left out: the real price is at most this.
    """
    if name.provider == COMPATIBLE:
        return None
    if PROVIDERS[name.provider].local:
        return 0.0
    usage = PricedUsage(input_tokens=input_tokens, output_tokens=output_tokens)
    try:
        price = calc_price(usage, name.model, provider_id=name.provider)
    except LookupError:
        return None
    return float(price.total_price)
