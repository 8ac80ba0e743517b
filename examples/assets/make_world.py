#!/usr/bin/env python3
"""Makes world.svg, the scene that the `render` example draws, from Natural Earth's countries.

    npm pack world-atlas@2.0.2 && tar xzf world-atlas-2.0.2.tgz
    python3 examples/assets/make_world.py package/countries-50m.json > examples/assets/world.svg

Python 3 and its standard library are enough. The output depends on nothing but the input.

The input is TopoJSON: borders are stored once, as arcs, and countries name the arcs they consist of. Whatever
moves a point (densifying, projecting, rounding, simplifying) is therefore done to arcs, so that two neighbours keep
exactly the same border and no crack can open between them.
"""

import heapq
import json
import math
import sys

WIDTH, HEIGHT, MARGIN = 800, 424, 8

# The projection's plane is 2 * 2.7354 wide and 2 * 1.4224 high.
HALF_WIDTH_OF_PLANE = 0.870700 * math.pi
PIXELS_PER_UNIT = (WIDTH / 2 - MARGIN) / HALF_WIDTH_OF_PLANE

# A vertex goes when the triangle that it forms with its neighbours is smaller than this, in square pixels. One pixel
# in 300 of the picture changes by it, on coasts; the file shrinks from 760 to 430 kB.
NEGLIGIBLE_AREA = 0.012

# No edge is longer than this, in degrees: straight lines on the globe's grid are curves on the map.
LONGEST_EDGE = 2.0

PAGE, FRAME, SHADOW = "#16293f", "#c9a45c", "#0d1a2a"
OCEAN, GRATICULE, RIM, BORDER = "#a8d1e7", "#86b5d3", "#f3e9d2", "#7b685c"
PALETTE = ["#f2c879", "#e89a7b", "#a9c77d", "#c7a3c9", "#f3e3a3", "#83b79f", "#dba9a0"]
ICE = "#f6f8f8"

CITIES = [
    ("Anchorage", 61.22, -149.90), ("Auckland", -36.85, 174.76), ("Beijing", 39.90, 116.41),
    ("Berlin", 52.52, 13.40), ("Bogota", 4.71, -74.07), ("Buenos Aires", -34.60, -58.38),
    ("Cairo", 30.04, 31.24), ("Cape Town", -33.92, 18.42), ("Dakar", 14.72, -17.47),
    ("Delhi", 28.61, 77.21), ("Honolulu", 21.31, -157.86), ("Istanbul", 41.01, 28.98),
    ("Jakarta", -6.21, 106.85), ("Lagos", 6.52, 3.38), ("Lima", -12.05, -77.04),
    ("London", 51.51, -0.13), ("Los Angeles", 34.05, -118.24), ("Mexico City", 19.43, -99.13),
    ("Moscow", 55.76, 37.62), ("Mumbai", 19.08, 72.88), ("Nairobi", -1.29, 36.82),
    ("New York", 40.71, -74.01), ("Novosibirsk", 55.03, 82.92), ("Nuuk", 64.18, -51.69),
    ("Perth", -31.95, 115.86), ("Reykjavik", 64.15, -21.94), ("Riyadh", 24.71, 46.68),
    ("Sao Paulo", -23.55, -46.63), ("Shanghai", 31.23, 121.47), ("Singapore", 1.35, 103.82),
    ("Sydney", -33.87, 151.21), ("Tokyo", 35.68, 139.69), ("Vancouver", 49.28, -123.12),
]


def project(longitude, latitude):
    """Natural Earth projection (Patterson; polynomials by Savric et al.), in the SVG's user units."""
    l, p = math.radians(longitude), math.radians(latitude)
    p2 = p * p
    p4 = p2 * p2
    x = l * (0.870700 - 0.131979 * p2 + p4 * (-0.013791 + p4 * (0.003971 * p2 - 0.001529 * p4)))
    y = p * (1.007226 + p2 * (0.015085 + p4 * (-0.044475 + 0.028874 * p2 - 0.005916 * p4)))
    return WIDTH / 2 + PIXELS_PER_UNIT * x, HEIGHT / 2 - PIXELS_PER_UNIT * y


# --- Geometry on the sphere: degrees ---------------------------------------------------------------------------


def decode_arcs(topology):
    scale_x, scale_y = topology["transform"]["scale"]
    origin_x, origin_y = topology["transform"]["translate"]
    for deltas in topology["arcs"]:
        x = y = 0
        arc = []
        for dx, dy in deltas:
            x, y = x + dx, y + dy
            arc.append((x * scale_x + origin_x, y * scale_y + origin_y))
        yield arc


def unwrapped(points):
    """The same points, each at most 180 degrees from the one before: longitudes may leave -180..180."""
    result = points[:1]
    for longitude, latitude in points[1:]:
        turns = round((result[-1][0] - longitude) / 360)
        result.append((longitude + 360 * turns, latitude))
    return result


def densified(points):
    result = points[:1]
    for (x0, y0), (x1, y1) in zip(points, points[1:]):
        pieces = max(1, math.ceil(max(abs(x1 - x0), abs(y1 - y0)) / LONGEST_EDGE))
        for i in range(1, pieces):
            t = i / pieces
            result.append((x0 + (x1 - x0) * t, y0 + (y1 - y0) * t))
        result.append((x1, y1))
    return result


def simplified(points):
    """Visvalingam and Whyatt: the vertex that spans the smallest triangle goes first. Ends stay."""
    plane = [project(*point) for point in points]
    before = list(range(-1, len(points) - 1))
    after = list(range(1, len(points) + 1))

    def area(i):
        (ax, ay), (bx, by), (cx, cy) = plane[before[i]], plane[i], plane[after[i]]
        return abs((bx - ax) * (cy - ay) - (cx - ax) * (by - ay)) / 2

    current = {i: area(i) for i in range(1, len(points) - 1)}
    queue = [(value, i) for i, value in current.items()]
    heapq.heapify(queue)
    # A ring made of one arc must keep an area.
    fewest = 4 if points[0] == points[-1] else 2
    kept = len(points)
    while queue and kept > fewest:
        value, i = heapq.heappop(queue)
        if current.get(i) != value:
            continue
        if value >= NEGLIGIBLE_AREA:
            break
        del current[i]
        kept -= 1
        after[before[i]], before[after[i]] = after[i], before[i]
        for neighbour in (before[i], after[i]):
            if neighbour in current:
                # Never less than what has gone already: else a whole bay unravels.
                current[neighbour] = max(value, area(neighbour))
                heapq.heappush(queue, (current[neighbour], neighbour))
    ends = (0, len(points) - 1)
    return [point for i, point in enumerate(points) if i in ends or i in current]


def clip_half_plane(ring, limit, keep_greater):
    """Sutherland and Hodgman against one meridian. Stretches along the meridian may run twice: no area, no harm."""
    inside = (lambda p: p[0] >= limit) if keep_greater else (lambda p: p[0] <= limit)
    result = []
    for a, b in zip(ring[-1:] + ring[:-1], ring):
        if inside(a) != inside(b):
            t = (limit - a[0]) / (b[0] - a[0])
            result.append((limit, a[1] + (b[1] - a[1]) * t))
        if inside(b):
            result.append(b)
    return result


def rings_on_map(ring):
    """Cuts one closed ring at the antimeridian; a ring around a pole is closed through it."""
    ring = unwrapped(ring)
    winding = ring[-1][0] - ring[0][0]
    if abs(winding) > 180:
        # Only Antarctica winds around a pole. The source also has an inner ring at 89.999 degrees: a hole of no size.
        if max(latitude for _, latitude in ring) < -89.9:
            return
        ring = densified(ring + [(ring[-1][0], -90.0), (ring[0][0], -90.0)])
    else:
        ring = ring[:-1]
    for turn in (-1, 0, 1):
        strip = clip_half_plane(ring, 360 * turn - 180, True)
        strip = strip and clip_half_plane(strip, 360 * turn + 180, False)
        if len(strip) >= 3:
            closed = densified(strip + strip[:1])[:-1]
            yield [(longitude - 360 * turn, latitude) for longitude, latitude in closed]


# --- Colours: neighbours differ --------------------------------------------------------------------------------


def arcs_of(geometry):
    if not geometry.get("arcs"):
        return []
    return [geometry["arcs"]] if geometry["type"] == "Polygon" else geometry["arcs"]


def colour_countries(geometries, size_of):
    """Most constrained country first; among the colours left, the one that covers the smallest area so far."""
    owners = {}
    for index, geometry in enumerate(geometries):
        for polygon in arcs_of(geometry):
            for ring in polygon:
                for arc in ring:
                    owners.setdefault(arc if arc >= 0 else ~arc, set()).add(index)
    neighbours = [set() for _ in geometries]
    for sharing in owners.values():
        for index in sharing:
            neighbours[index] |= sharing - {index}

    colours = {}
    covered = [0.0] * len(PALETTE)
    while len(colours) < len(geometries):
        def urgency(i):
            return (len({colours[n] for n in neighbours[i] if n in colours}), len(neighbours[i]), size_of[i], -i)
        index = max((i for i in range(len(geometries)) if i not in colours), key=urgency)
        taken = {colours[n] for n in neighbours[index] if n in colours}
        free = [c for c in range(len(PALETTE)) if c not in taken]
        colours[index] = min(free, key=lambda c: covered[c])
        covered[colours[index]] += size_of[index]
    return colours


# --- Writing ----------------------------------------------------------------------------------------------------


def number(hundredths):
    """The shortest text of a whole number of hundredths."""
    sign = "-" if hundredths < 0 else ""
    whole, rest = divmod(abs(hundredths), 100)
    fraction = f".{rest:02d}".rstrip("0") if rest else ""
    return sign + (str(whole) if whole or not fraction else "") + fraction


def joined(numbers):
    """SVG lets a minus sign or a second decimal point separate two numbers."""
    text = ""
    for part in map(number, numbers):
        if text and not part.startswith("-") and not (part.startswith(".") and "." in text.split("-")[-1].split(" ")[-1]):
            text += " "
        text += part
    return text


def path_data(rings):
    """Relative moves in whole hundredths: they add up without error."""
    data = []
    for ring in rings:
        points = []
        for longitude, latitude in ring:
            x, y = project(longitude, latitude)
            point = (round(x * 100), round(y * 100))
            if not points or point != points[-1]:
                points.append(point)
        if len(points) > 1 and points[0] == points[-1]:
            points.pop()
        if len(points) < 3:
            continue
        steps = [joined((x1 - x0, y1 - y0)) for (x0, y0), (x1, y1) in zip(points, points[1:])]
        line = steps[0]
        for step in steps[1:]:
            line += ("" if step.startswith("-") else " ") + step
        data.append("M" + joined(points[0]) + "l" + line + "z")
    return "\n".join(data)


def area_on_map(rings):
    total = 0.0
    for ring in rings:
        plane = [project(*point) for point in ring]
        total += sum(ax * by - bx * ay for (ax, ay), (bx, by) in zip(plane, plane[1:] + plane[:1])) / 2
    return abs(total)


def text_of(values):
    return " ".join(number(round(value * 100)) for value in values)


def globe_outline():
    east = [(180, latitude) for latitude in range(90, -91, -2)]
    return [east + [(-longitude, latitude) for longitude, latitude in reversed(east)]]


def graticule():
    for longitude in range(-150, 180, 30):
        if longitude == 0:
            x, y0 = project(0, 90)
            yield f'<line x1="{x:.2f}" y1="{y0:.2f}" x2="{x:.2f}" y2="{project(0, -90)[1]:.2f}"/>'
            continue
        points = [value for latitude in range(90, -91, -3) for value in project(longitude, latitude)]
        yield f'<polyline points="{text_of(points)}"/>'
    # Parallels are straight in this projection.
    for latitude in range(-60, 90, 30):
        (x0, y0), (x1, _) = project(-180, latitude), project(180, latitude)
        yield f'<line x1="{x0:.2f}" y1="{y0:.2f}" x2="{x1:.2f}" y2="{y0:.2f}"/>'
    # Tropics and polar circles.
    for latitude in (-66.56, -23.44, 23.44, 66.56):
        (x0, y0), (x1, _) = project(-180, latitude), project(180, latitude)
        yield f'<line x1="{x0:.2f}" y1="{y0:.2f}" x2="{x1:.2f}" y2="{y0:.2f}" stroke-dasharray="4 4"/>'


def compass(x, y, radius):
    """A rose of eight points: every half of a point is one triangle."""
    yield f'<circle cx="{x}" cy="{y}" r="{radius * 0.62:.2f}" fill="none" stroke="{FRAME}" stroke-width="2"/>'
    for diagonal in (True, False):
        length = radius * (0.66 if diagonal else 1)
        waist = radius * (0.20 if diagonal else 0.24)
        for quarter in range(4):
            angle = math.pi / 2 * quarter + (math.pi / 4 if diagonal else 0)
            tip = (x + length * math.sin(angle), y - length * math.cos(angle))
            for side, fill in ((-1, "#f3e9d2"), (1, "#a5824a")):
                if not diagonal and quarter == 0:
                    fill = "#e0533d" if side < 0 else "#a83222"
                bend = angle + side * math.pi / 4
                corner = (x + waist * math.sin(bend), y - waist * math.cos(bend))
                yield f'<polygon points="{text_of((x, y, *corner, *tip))}" fill="{fill}"/>'
    yield f'<circle cx="{x}" cy="{y}" r="2.5" fill="{PAGE}"/>'


def main():
    with open(sys.argv[1], encoding="utf-8") as source:
        topology = json.load(source)
    arcs = [simplified(densified(unwrapped(arc))) for arc in decode_arcs(topology)]

    def ring_points(indices):
        points = []
        for index in indices:
            arc = arcs[index] if index >= 0 else arcs[~index][::-1]
            points += arc[1:] if points else arc
        return points

    geometries = [g for g in topology["objects"]["countries"]["geometries"] if arcs_of(g)]
    shapes = [
        [part for polygon in arcs_of(g) for ring in polygon for part in rings_on_map(ring_points(ring))]
        for g in geometries
    ]
    colours = colour_countries(geometries, [area_on_map(rings) for rings in shapes])
    # Largest first, so that a country inside another one is seen even where the source has no hole for it.
    order = sorted(range(len(geometries)), key=lambda i: -area_on_map(shapes[i]))
    globe = path_data(globe_outline())

    out = [
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" height="{HEIGHT}" viewBox="0 0 {WIDTH} {HEIGHT}">',
        "<title>The world, after Natural Earth</title>",
        "<!-- Made by make_world.py: edit that, not this. -->",
        f'<rect width="{WIDTH}" height="{HEIGHT}" fill="{PAGE}"/>',
        f'<rect x="2.5" y="2.5" width="{WIDTH - 5}" height="{HEIGHT - 5}" rx="10" fill="none" stroke="{FRAME}"/>',
        f'<path d="{globe}" fill="{SHADOW}" transform="translate(3 4)"/>',
        f'<path d="{globe}" fill="{OCEAN}"/>',
        f'<g fill="none" stroke="{GRATICULE}" stroke-width=".75">',
        *graticule(),
        "</g>",
        f'<g fill-rule="evenodd" stroke="{BORDER}" stroke-width=".5" stroke-linejoin="round">',
    ]
    for index in order:
        name = geometries[index]["properties"]["name"]
        data = path_data(shapes[index])
        if data:
            fill = ICE if name == "Antarctica" else PALETTE[colours[index]]
            title = name.replace("&", "&amp;").replace("<", "&lt;")
            out.append(f'<path fill="{fill}" d="{data}"><title>{title}</title></path>')
    out += ["</g>", f'<path d="{globe}" fill="none" stroke="{RIM}" stroke-width="1.5"/>', "<g>"]
    for name, latitude, longitude in CITIES:
        x, y = project(longitude, latitude)
        at = f'cx="{x:.2f}" cy="{y:.2f}"'
        out.append(f'<circle {at} r="3.25" fill="#fff"/><circle {at} r="2" fill="#c0282d"><title>{name}</title></circle>')
    out += ["</g>", "<g>", *compass(46, HEIGHT - 48, 34), "</g>", "</svg>"]
    print("\n".join(out))


main()
