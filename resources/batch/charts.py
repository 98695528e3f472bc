# SPDX-License-Identifier: GPL-3.0-or-later
"""Charts of records, as SVG in HTML."""
import html
import math

from records import Of, Record, numbers, quantile, shown

WIDTH, HEIGHT = 440, 210
LEFT, RIGHT, BELOW, ABOVE = 44, 12, 40, 14  # margins of a chart
LEAST_POWER = -16  # of ten; what is less counts there
LEAST_POWERS, MOST_TICKS = 4, 9  # of a chart of powers
ROUNDING = 1e-6


def nice_step(span: float, parts: int) -> float:
    """1, 2 or 5 times a power of ten, so that `span` has at most so many."""
    rough = span / parts
    power = 10 ** math.floor(math.log10(rough))
    return next(power * factor for factor in (1, 2, 5, 10) if power * factor >= rough * 0.999999)


def chart(
    title: str,
    caption: str,
    bars: list[tuple[int, str]],
    ticks: list[tuple[float, str]],
    axis: str,
    last_is_open: bool = False,
) -> str:
    """Bars beside each other. A bar is a height and what it counts, a tick a place and its text."""
    most = max(height for height, _ in bars)
    across = (WIDTH - LEFT - RIGHT) / len(bars)
    up = (HEIGHT - BELOW - ABOVE) / most
    ground = HEIGHT - BELOW
    parts = [f'<svg viewBox="0 0 {WIDTH} {HEIGHT}" role="img" aria-label="{html.escape(title)}">']
    for height in range(0, most + 1, max(1, round(nice_step(most, 4)))):
        y = ground - height * up
        parts.append(
            f'<line class="axis" x1="{LEFT}" x2="{WIDTH - RIGHT}" y1="{y:.1f}" y2="{y:.1f}"/>'
            f'<text x="{LEFT - 6}" y="{y + 4:.1f}" text-anchor="end">{height}</text>'
        )
    for k, (height, label) in enumerate(bars):
        kind = "bad" if last_is_open and k == len(bars) - 1 else "bar"
        parts.append(
            f'<rect class="{kind}" x="{LEFT + k * across + 1:.1f}" width="{across - 2:.1f}" '
            f'y="{ground - height * up:.1f}" height="{height * up:.1f}" rx="1">'
            f"<title>{html.escape(label)}: {height}</title></rect>"
        )
    for place, text in ticks:
        parts.append(
            f'<text x="{LEFT + place * across:.1f}" y="{ground + 16}" text-anchor="middle">{text}'
            "</text>"
        )
    parts.append(
        f'<text x="{(LEFT + WIDTH - RIGHT) / 2:.0f}" y="{HEIGHT - 6}" text-anchor="middle">{axis}'
        "</text></svg>"
    )
    return (
        f"<figure><h2>{html.escape(title)}</h2><figcaption>{caption}</figcaption>{''.join(parts)}"
        "</figure>"
    )


def largest(records: list[Record], of: Of) -> str:
    """The name of the garment that one would want to look at."""
    having = [record for record in records if of(record) is not None]
    return f"<b>{html.escape(max(having, key=of)['name'])}</b>"


def histogram(title: str, unit: str, records: list[Record], of: Of) -> str:
    """Bars of even width up to the value that a hundredth exceeds; the rest is one bar more."""
    values = numbers(records, of)
    if not values:
        return ""
    top = quantile(values, 0.99) or values[-1] or 1.0
    step = nice_step(top, 24)
    count = max(1, math.ceil(top / step - 1e-9))
    bins = [0] * (count + 1)
    for value in values:
        bins[min(count, int(value / step))] += 1
    is_open = bins[count] > 0
    bars = [(n, f"{shown(k * step)} to {shown((k + 1) * step)} {unit}") for k, n in enumerate(bins)]
    bars[count] = (bins[count], f"{shown(count * step)} {unit} and more")
    ticks = [(k, shown(k * step)) for k in range(0, count + 1, max(1, math.ceil(count / 6)))]
    axis = f"{unit}; the last bar is all beyond" if is_open else unit
    half, most = (shown(quantile(values, share)) for share in (0.5, 0.9))
    caption = (
        f"half below {half} {unit}, nine tenths below {most} {unit}, "
        f"largest {shown(values[-1])} {unit}: {largest(records, of)}"
    )
    return chart(title, caption, bars if is_open else bars[:count], ticks, axis, is_open)


def histogram_of_powers(title: str, unit: str, records: list[Record], of: Of) -> str:
    """A bar for each power of ten, for what is rounding here and a fault there."""
    values = numbers(records, of)
    if not values:
        return ""
    powers = [LEAST_POWER if v < 10**LEAST_POWER else math.floor(math.log10(v)) for v in values]
    low = min(powers)
    top = max(*powers, low + LEAST_POWERS - 1)
    bars = []
    for power in range(low, top + 1):
        label = f"below 10^{power + 1} {unit}"
        label = label if power == LEAST_POWER else f"10^{power} and more, {label}"
        bars.append((powers.count(power), label))
    ticks = [
        (power - low, f'10<tspan dy="-4" font-size="8">{power}</tspan>')
        for power in range(low + 1, top + 1, 1 if top - low < MOST_TICKS else 2)
    ]
    exact = sum(value < ROUNDING for value in values)
    caption = (
        f"{exact} of {len(values)} below a millionth {unit}, "
        f"largest {values[-1]:.2g} {unit}: {largest(records, of)}"
    )
    return chart(title, caption, bars, ticks, unit)
