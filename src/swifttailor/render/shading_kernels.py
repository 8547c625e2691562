"""Compiled loops that light what is seen, and put it before its backdrop. All arrays are C-contiguous."""

from __future__ import annotations

import math

import numpy as np
from numba import njit

from swifttailor.render.compile_options import FAST, HELPER
from swifttailor.render.raster_kernels import NOTHING, weigh

_STEP = 0.6
"""Distance between the points that make a line, pixels."""
_F = np.float32


@njit(**FAST)
def light_samples(
    light,
    coverage,
    keys,
    front,
    points,
    faces,
    normals,
    perspective,
    surface,
    materials,
    places,
    painted,
    paint,
    bumps,
    kept,
    middle,
    shadow,
    room,
    view,
    lights,
    samples,
    once,
    shade,
):
    """Adds up the light that the samples of each pixel send (`lighting` says from where).

    Args:
        light: (h, w, 3) float32 linear light, zeros before.
        coverage: (h, w, 1) float32 share of samples that show something, zeros before.
        keys: (H, W) int64, see `raster_kernels.fill`.
        front: (m,), see there.
        points: (n, 3), see `scene.Projection`.
        faces: (m, 3) int32.
        normals: (n, 3) float32 unit normals in the world.
        perspective: Whether near things look larger.
        surface: (m,) int16 of each face.
        materials: (r, 8) float32, see `scene.Materials`.
        places: (2, surfaces) int32, see `scene.Materials`.
        painted: (surfaces,) 0 without a print, 1 with a print, 2 with one that has folds.
        paint: (H, W, 3) float32 colours of right sides with a print; or (0, 0, 3).
        bumps: (H, W, 3) float32 by which folds tilt normals; or (0, 0, 3).
        kept: (H, W) float32 share of light that lines leave; or (0, 0).
        middle: (h, w, 3) float32, see `raster_kernels.find_middles`.
        shadow: (h, w) float32 share of the key light, once per pixel.
        room: (h, w) float32 share of the room's light.
        view: (3,) float32 towards the camera, in the world.
        lights: (9, 4) float32, see `lighting.Lighting.table`, directions in the world.
        samples: Samples along each side of a pixel.
        once: Pixels whose samples all show one side of one surface, too, are lit once, by their middle's
            normal; else only those that show one triangle.
        shade: (2, 3) float32 to work with.
    """
    height, width = light.shape[:2]
    gain, base = shade[0], shade[1]
    share = _F(1) / _F(samples * samples)
    half, one, zero = _F(0.5), _F(1), _F(0)
    for j in range(height):
        for i in range(width):
            top, side = j * samples, i * samples
            first_key = keys[top, side]
            before = np.int32(first_key)
            same = first_key != NOTHING
            for row in range(top, top + samples):
                for column in range(side, side + samples):
                    key = keys[row, column]
                    t = np.int32(key)
                    if t != before:
                        same = same and once and key != NOTHING
                        same = same and surface[t] == surface[before] and front[t] == front[before]
            row, column = top, side - 1
            for sample in range(samples * samples):
                column += 1
                if column == side + samples:
                    row, column = row + 1, side
                if keys[row, column] == NOTHING:
                    continue
                t = np.int32(keys[row, column])
                s = surface[t]
                place = places[0, s] + places[1, s] * t
                printed = painted[s] if front[t] else 0
                if sample == 0 or not same:
                    if same:
                        r, q = top + samples // 2, side + samples // 2
                        nx, ny, nz = middle[j, i, 0], middle[j, i, 1], middle[j, i, 2]
                    else:
                        r, q = row, column
                        w0, w1, w2 = weigh(t, column + 0.5, row + 0.5, points, faces, perspective)
                        turn = one if front[t] else -one
                        v0, v1, v2 = _F(w0) * turn, _F(w1) * turn, _F(w2) * turn
                        a, b, c = faces[t, 0], faces[t, 1], faces[t, 2]
                        nx = v0 * normals[a, 0] + v1 * normals[b, 0] + v2 * normals[c, 0]
                        ny = v0 * normals[a, 1] + v1 * normals[b, 1] + v2 * normals[c, 1]
                        nz = v0 * normals[a, 2] + v1 * normals[b, 2] + v2 * normals[c, 2]
                    if printed == 2:
                        nx, ny, nz = nx + bumps[r, q, 0], ny + bumps[r, q, 1], nz + bumps[r, q, 2]
                    size = one / max(_F(math.sqrt(nx * nx + ny * ny + nz * nz)), _F(1e-6))
                    nx, ny, nz = nx * size, ny * size, nz * size
                    open_sky, arriving = room[j, i], shadow[j, i]
                    facing = min(max(nx * view[0] + ny * view[1] + nz * view[2], zero), one)
                    edge = (one - facing) * (one - facing)
                    key_part = _diffuse(nx, ny, nz, lights[0]) * arriving
                    fill = _diffuse(nx, ny, nz, lights[1]) * open_sky
                    rim = _diffuse(nx, ny, nz, lights[2]) * edge * open_sky
                    sky = (half + half * ny) * open_sky
                    glint = max(nx * lights[8, 0] + ny * lights[8, 1] + nz * lights[8, 2], zero)
                    glint *= glint
                    glint *= glint
                    glint *= glint  # to the 8th
                    highlight = glint * glint * glint * materials[place, 7] * arriving
                    velvet = edge * (one - facing) * materials[place, 6] * open_sky
                    for k in range(3):
                        lit = key_part * lights[3, k] + fill * lights[4, k]
                        lit += sky * (lights[6, k] - lights[7, k]) + open_sky * lights[7, k]
                        gain[k] = lit + _F(0.65) * rim * lights[5, k] + _F(0.7) * velvet
                        base[k] = highlight + _F(0.35) * rim * lights[5, k] + _F(0.3) * velvet
                coverage[j, i, 0] += share
                left = share if len(kept) == 0 else share * kept[row, column]
                first = 0 if front[t] else 3
                for k in range(3):
                    color = paint[row, column, k] if printed else materials[place, first + k]
                    light[j, i, k] += (color * gain[k] + base[k]) * left


@njit(**HELPER)
def _diffuse(nx, ny, nz, light):
    facing = nx * light[0] + ny * light[1] + nz * light[2]
    return max((facing + light[3]) / (_F(1) + light[3]), _F(0))


@njit(**FAST)
def arriving_key_light(key, distance, normal, geometry, to_map, out, origin, depth, fade):
    """Finds the share of the key light that arrives at the middle of each pixel.

    Args:
        key: (h, w) float32 share of the light, ones before.
        distance: (h, w) float32 from the camera, cm, infinite where nothing is seen.
        normal: (h, w, 3) float32, in the world.
        geometry: Four numbers: cm a pixel at the target's distance; that distance, or 0 for an
            orthographic camera; which part of a pixel is its middle; how far behind the occluder shadow
            begins, cm.
        to_map: (3, 3) from the camera's frame (right, up, towards the camera, from the camera) to cells of
            the map and to the depth towards the light, cm.
        out: (3, 3) from the normal to how far out receivers are taken, in the map.
        origin: (3,) where the camera itself lies there.
        depth: (rows, columns) float32 depth in the shadow map, cm.
        fade: Over how many cm shadow becomes full.
    """
    height, width = key.shape
    rows, columns = depth.shape
    scale, perspective, middle, bias = geometry
    for j in range(height):
        for i in range(width):
            away = distance[j, i]
            if away == np.inf:
                continue
            spread = scale * away / perspective if perspective > 0.0 else scale
            px, py, pz = (i + middle - width / 2) * spread, (height / 2 - j - middle) * spread, -away
            nx, ny, nz = normal[j, i, 0], normal[j, i, 1], normal[j, i, 2]
            mx = to_map[0, 0] * px + to_map[0, 1] * py + to_map[0, 2] * pz + origin[0]
            my = to_map[1, 0] * px + to_map[1, 1] * py + to_map[1, 2] * pz + origin[1]
            mz = to_map[2, 0] * px + to_map[2, 1] * py + to_map[2, 2] * pz + origin[2]
            mx += out[0, 0] * nx + out[0, 1] * ny + out[0, 2] * nz
            my += out[1, 0] * nx + out[1, 1] * ny + out[1, 2] * nz
            mz += out[2, 0] * nx + out[2, 1] * ny + out[2, 2] * nz
            mx, my = min(max(mx - 0.5, 1.0), columns - 2.001), min(max(my - 0.5, 1.0), rows - 2.001)
            u, v = int(mx), int(my)
            across, down = mx - u, my - v
            # Sixteen comparisons around the point, weighted so that the sum changes smoothly between cells.
            total = 0.0
            for b in range(4):
                line = 0.0
                for a in range(4):
                    ahead = (depth[v - 1 + b, u - 1 + a] + mz + bias) / fade
                    tent = (1.0 - across) if a == 0 else (across if a == 3 else 1.0)
                    line += tent * min(max(1.0 + ahead, 0.0), 1.0)
                total += line * ((1.0 - down) if b == 0 else (down if b == 3 else 1.0))
            key[j, i] = total / 9.0


@njit(**FAST)
def add_blocks(sums, counts, depth, step):
    """Adds up the depth of what is seen in square blocks of pixels.

    Args:
        sums: (rows, columns) float32 depth, zeros before.
        counts: (rows, columns) float32 pixels that show something, zeros before.
        depth: (h, w) float32, infinite where nothing is.
        step: Pixels along a side of a block.
    """
    for j in range(depth.shape[0]):
        for i in range(depth.shape[1]):
            if depth[j, i] < np.inf:
                sums[j // step, i // step] += depth[j, i]
                counts[j // step, i // step] += _F(1)


@njit(**FAST)
def darken_deep(sky, depth, step, sums, counts, reach, strength):
    """Takes light from what lies deeper than the mean of its neighbourhood.

    Args:
        sky: (h, w) float32 share of light, lowered in place.
        depth: (h, w) float32, infinite where nothing is.
        step: Pixels along a side of a block.
        sums: (rows, columns) float32 of `add_blocks`, blurred.
        counts: (rows, columns) float32 of `add_blocks`, blurred in the same way.
        reach: Depth at which it is darkest.
        strength: How much light is then taken.
    """
    rows, columns = sums.shape
    inverse, half = _F(1) / _F(step), _F(0.5)
    for j in range(depth.shape[0]):
        down = min(max((j + half) * inverse - half, _F(0)), _F(rows - 1))
        b = min(int(down), max(rows - 2, 0))
        below, t = min(b + 1, rows - 1), down - b
        for i in range(depth.shape[1]):
            if depth[j, i] < np.inf:
                across = min(max((i + half) * inverse - half, _F(0)), _F(columns - 1))
                a = min(int(across), max(columns - 2, 0))
                beside, s = min(a + 1, columns - 1), across - a
                w0, w1, w2, w3 = (1 - t) * (1 - s), (1 - t) * s, t * (1 - s), t * s
                total = w0 * sums[b, a] + w1 * sums[b, beside]
                total += w2 * sums[below, a] + w3 * sums[below, beside]
                weight = w0 * counts[b, a] + w1 * counts[b, beside]
                weight += w2 * counts[below, a] + w3 * counts[below, beside]
                deeper = (depth[j, i] - total / max(weight, _F(1e-6))) / _F(reach)
                sky[j, i] -= _F(strength) * min(max(deeper, _F(0)), _F(1))


@njit(**FAST)
def dim_along(kept, edges, points, keys, depths, strength, radius, lift):
    """Lowers `kept` (H, W) to 1 - `strength` where edges of vertices are seen.

    Args:
        kept: (H, W) float32 share of light.
        edges: (e, 2) int32 vertices.
        points: (n, 3), see `scene.Projection`.
        keys: (H, W) int64, see `raster_kernels.fill`.
        depths: (6,) depth where its steps begin; steps in a unit; 1 in perspective, else 0; how much nearer
            the surface is drawn than it is, cm; its first face, and the one behind its last: what lightens
            does so on these alone, as skin beside a neckline would be white.
        strength: Share of light that is taken; below 0, that is added.
        radius: Of the line, in samples.
        lift: A line is seen when it lies less than this behind what the sample shows, cm.
    """
    height, width = keys.shape
    left = np.float32(1.0 - strength)
    reach = math.ceil(radius)
    for edge in range(len(edges)):
        a, b = edges[edge, 0], edges[edge, 1]
        x0, y0, z0 = points[a, 0], points[a, 1], points[a, 2]
        x1, y1, z1 = points[b, 0] - x0, points[b, 1] - y0, points[b, 2] - z0
        if z0 <= 0 or z0 + z1 <= 0 or max(x0, x0 + x1) < 0 or max(y0, y0 + y1) < 0:
            continue
        if min(x0, x0 + x1) >= width or min(y0, y0 + y1) >= height:
            continue
        count = min(math.ceil(math.hypot(x1, y1) / _STEP), 4 * (width + height)) + 1
        for point in range(count):
            t = (point + 0.5) / count
            x, y, z = x0 + t * x1, y0 + t * y1, z0 + t * z1 - lift - depths[3]
            # Farther than this, a sample's depth is behind the line.
            limit = -1.0 / max(z, 1e-9) if depths[2] else z
            limit = (limit - depths[0]) * depths[1]
            for dy in range(-reach, reach + 1):
                for dx in range(-reach, reach + 1):
                    column, row = int(x + dx), int(y + dy)
                    if dx * dx + dy * dy > radius * radius or not (0 <= column < width and 0 <= row < height):
                        continue
                    if limit <= keys[row, column] >> 32:
                        face = np.int32(keys[row, column])
                        if left > _F(1) and not depths[4] <= face < depths[5]:
                            continue
                        now = kept[row, column]
                        kept[row, column] = min(now, left) if left < _F(1) else max(now, left)


@njit(**FAST)
def put_before(picture, first, light, coverage, floor, fade):
    """Puts a view into the columns of a picture (h, W, 3) from `first` on, in place; `fade` (w,) of it."""
    height, width = coverage.shape[:2]
    for j in range(height):
        for i in range(width):
            share = fade[i]
            behind = (_F(1) - share * (_F(1) - floor[j, i, 0])) * (_F(1) - coverage[j, i, 0] * share)
            for k in range(3):
                picture[j, first + i, k] = picture[j, first + i, k] * behind + light[j, i, k] * share
