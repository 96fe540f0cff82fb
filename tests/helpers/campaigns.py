"""A small campaign, and whoever watches it."""

from scegen.campaign.engines import Workforce
from scegen.campaign.order import Campaign, Described
from scegen.campaign.running import run_campaign

TEXTS = {
    "left": "A car comes from the left while the ego goes straight over the intersection.",
    "lead": "The ego follows a car at 50 km/h, which brakes with 6 m/s2.",
    "weather": "It rains in the mountains.",
}


class Notes:
    """Whoever watches."""

    def __init__(self):
        self.told = []

    def planning(self, done, total):
        pass

    def making(self, done, failed, total):
        pass

    def note(self, text):
        self.told.append(text)


def campaign(texts=None, **options):
    texts = TEXTS if texts is None else texts
    described = tuple(Described(id=name, text=text) for name, text in texts.items())
    return Campaign(descriptions=described, **{"count": 3, **options})


def make(order, folder, workforce=None, notes=None):
    return run_campaign(order, folder, workforce or Workforce(), notes or Notes())
