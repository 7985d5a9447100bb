# SPDX-License-Identifier: LGPL-2.1-or-later
"""Small plots as SVG files, with nothing but the standard library."""
import math

WIDTH, HEIGHT = 560, 400
LEFT, RIGHT, TOP, BOTTOM = 70, 15, 34, 48
COLOURS = ("#1f5fa8", "#b3402a", "#3c8031", "#7a4a9c", "#b8860b", "#444444")


def ticks(low, high, logarithmic):
    """Round numbers between the two."""
    if logarithmic:
        first, last = math.floor(math.log10(low)), math.ceil(math.log10(high))
        stride = max(1, (last - first) // 7)
        return [10.0 ** k for k in range(first, last + 1, stride)]
    step = 10 ** math.floor(math.log10((high - low) / 4))
    step *= next(f for f in (1, 2, 5, 10) if (high - low) / (f * step) <= 6)
    return [k * step for k in range(math.ceil(low / step - 1e-9), math.floor(high / step + 1e-9) + 1)]


class Axis:
    """Maps numbers to pixels."""

    def __init__(self, values, begin, end, logarithmic):
        self.scale = math.log10 if logarithmic else float
        marks = ticks(min(values), max(values), logarithmic)
        low, high = min(min(values), *marks[:1]), max(max(values), *marks[-1:])
        self.ticks = [t for t in marks if low <= t <= high]
        self.begin, self.end = begin, end
        self.low, self.high = self.scale(low), self.scale(high)

    def __call__(self, value):
        part = (self.scale(value) - self.low) / (self.high - self.low)
        return self.begin + part * (self.end - self.begin)


def write_svg(path, title, x_label, y_label, series, logarithmic=False, labels_right=False):
    """Write a plot. series: (label, [(x, y)], whether to draw marks in place of a line)."""
    x = Axis([p[0] for _, points, _ in series for p in points], LEFT, WIDTH - RIGHT, logarithmic)
    y = Axis([p[1] for _, points, _ in series for p in points], HEIGHT - BOTTOM, TOP, logarithmic)
    out = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" height="{HEIGHT}" '
           'font-family="sans-serif" font-size="12">',
           f'<rect width="{WIDTH}" height="{HEIGHT}" fill="white"/>',
           f'<text x="{WIDTH / 2}" y="20" text-anchor="middle" font-size="14">{title}</text>',
           f'<text x="{(LEFT + WIDTH) / 2}" y="{HEIGHT - 10}" text-anchor="middle">{x_label}</text>',
           f'<text transform="translate(16 {HEIGHT / 2}) rotate(-90)" '
           f'text-anchor="middle">{y_label}</text>']
    for t in x.ticks:
        out.append(f'<path d="M{x(t):.1f} {TOP}V{HEIGHT - BOTTOM}" stroke="#ddd"/>'
                   f'<text x="{x(t):.1f}" y="{HEIGHT - BOTTOM + 16}" text-anchor="middle">{t:g}</text>')
    for t in y.ticks:
        out.append(f'<path d="M{LEFT} {y(t):.1f}H{WIDTH - RIGHT}" stroke="#ddd"/>'
                   f'<text x="{LEFT - 6}" y="{y(t) + 4:.1f}" text-anchor="end">{t:g}</text>')
    out.append(f'<rect x="{LEFT}" y="{TOP}" width="{WIDTH - LEFT - RIGHT}" '
               f'height="{HEIGHT - TOP - BOTTOM}" fill="none" stroke="#888"/>')
    for k, (label, points, marks) in enumerate(series):
        colour = COLOURS[k % len(COLOURS)]
        if marks:
            out += [f'<circle cx="{x(a):.1f}" cy="{y(b):.1f}" r="2.6" fill="none" '
                    f'stroke="{colour}"/>' for a, b in points]
        else:
            out.append('<polyline fill="none" stroke-width="1.5" stroke="' + colour + '" points="' +
                       " ".join(f"{x(a):.1f},{y(b):.1f}" for a, b in points) + '"/>')
        where = (f'x="{WIDTH - RIGHT - 12}" text-anchor="end"' if labels_right
                 else f'x="{LEFT + 12}"')
        out.append(f'<text {where} y="{TOP + 18 + 16 * k}" fill="{colour}">'
                   f'{"o" if marks else "-"} {label}</text>')
    path.write_text("\n".join(out + ["</svg>"]) + "\n")
