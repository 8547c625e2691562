"""Compiled loops that light what is seen, and put it before its backdrop. All arrays are C-contiguous."""

from __future__ import annotations

import math

import numpy as np
from numba import njit

from swifttailor.render.compile_options import FAST

_STEP = 0.6
"""Distance between the points that make a line, pixels."""
_F = np.float32


@njit(**FAST)
def light_samples(
    light,
    coverage,
    face,
    normal,
    materials,
    front,
    printed,
    kept,
    shadow,
    room,
    up_axis,
    lights,
    samples,
    color,
):
    """Adds up the light that the samples of each pixel send (`lighting` says from where).

    Args:
        light: (h, w, 3) float32 linear light, zeros before.
        coverage: (h, w, 1) float32 share of samples that show something, zeros before.
        face: (H, W) triangle of each sample, -1 for none.
        normal: (H, W, 3) float32, in the camera's frame.
        materials: (k, 8) float32, see `Scene.materials`.
        front: (k,) whether the right side of a triangle is seen.
        printed: (H, W, 3) float32 colours of right sides, negative where there is no print; or (0, 0, 3).
        kept: (H, W) float32 share of light that lines leave; or (0, 0).
        shadow: (h, w) float32 share of the key light, once per pixel.
        room: (h, w) float32 share of the room's light.
        up_axis: (3,) float32, the world's up in the camera's frame.
        lights: (9, 4) float32, see `lighting.Lighting.table`.
        samples: Samples along each side of a pixel.
        color: (3,) float32 to work with.
    """
    height, width = light.shape[:2]
    share = _F(1) / _F(samples * samples)
    half, one, zero = _F(0.5), _F(1), _F(0)
    for j in range(height):
        for i in range(width):
            for sample in range(samples * samples):
                row, column = j * samples + sample // samples, i * samples + sample % samples
                t = face[row, column]
                if t < 0:
                    continue
                coverage[j, i, 0] += share
                nx, ny, nz = normal[row, column, 0], normal[row, column, 1], normal[row, column, 2]
                sheen, gloss, open_sky, arriving = materials[t, 6], materials[t, 7], room[j, i], shadow[j, i]
                first = 0 if front[t] else 3
                for k in range(3):
                    color[k] = materials[t, first + k]
                if len(printed) and printed[row, column, 0] >= zero:
                    for k in range(3):
                        color[k] = printed[row, column, k]
                facing = min(max(nz, zero), one)
                edge = (one - facing) * (one - facing)
                key = _diffuse(nx, ny, nz, lights[0]) * arriving
                fill = _diffuse(nx, ny, nz, lights[1]) * open_sky
                rim = _diffuse(nx, ny, nz, lights[2]) * edge * open_sky
                up = nx * up_axis[0] + ny * up_axis[1] + nz * up_axis[2]
                sky = (half + half * up) * open_sky
                glint = max(nx * lights[8, 0] + ny * lights[8, 1] + nz * lights[8, 2], zero)
                glint *= glint
                glint *= glint
                glint *= glint  # to the 8th
                highlight = glint * glint * glint * gloss * arriving
                velvet = edge * (one - facing) * sheen * open_sky
                left = share if len(kept) == 0 else share * kept[row, column]
                for k in range(3):
                    shade = key * lights[3, k] + fill * lights[4, k]
                    shade += sky * (lights[6, k] - lights[7, k]) + open_sky * lights[7, k]
                    lit = color[k] * shade + rim * lights[5, k] * (_F(0.35) + _F(0.65) * color[k])
                    lit += highlight + velvet * (_F(0.3) + _F(0.7) * color[k])
                    light[j, i, k] += lit * left


@njit(inline="always")
def _diffuse(nx, ny, nz, light):
    facing = nx * light[0] + ny * light[1] + nz * light[2]
    return max((facing + light[3]) / (_F(1) + light[3]), _F(0))


@njit(**FAST)
def arriving_key_light(key, distance, normal, samples, geometry, to_map, origin, depth, fade):
    """Finds the share of the key light that arrives at the middle of each pixel.

    Args:
        key: (h, w) float32 share of the light, ones before.
        distance: (H, W) float32 of each sample from the camera, cm.
        normal: (H, W, 3) float32, in the camera's frame.
        samples: Samples along each side of a pixel.
        geometry: Four numbers: cm a sample at the target's distance; that distance, or 0 for an
            orthographic camera; how far out receivers are taken; how far behind the occluder shadow
            begins, cm.
        to_map: (3, 3) from the camera's frame (right, up, towards the camera, from the camera) to cells of
            the map and to the depth towards the light, cm.
        origin: (3,) where the camera itself lies there.
        depth: (rows, columns) float32 depth in the shadow map, cm.
        fade: Over how many cm shadow becomes full.
    """
    height, width = key.shape
    rows, columns = depth.shape
    scale, perspective, out, bias = geometry
    middle = samples // 2
    for j in range(height):
        for i in range(width):
            row, column = j * samples + middle, i * samples + middle
            away = distance[row, column]
            if away == np.inf:
                continue
            spread = scale * away / perspective if perspective > 0.0 else scale
            px = (column + 0.5 - distance.shape[1] / 2) * spread + out * normal[row, column, 0]
            py = (distance.shape[0] / 2 - row - 0.5) * spread + out * normal[row, column, 1]
            pz = out * normal[row, column, 2] - away
            mx = to_map[0, 0] * px + to_map[0, 1] * py + to_map[0, 2] * pz + origin[0]
            my = to_map[1, 0] * px + to_map[1, 1] * py + to_map[1, 2] * pz + origin[1]
            mz = to_map[2, 0] * px + to_map[2, 1] * py + to_map[2, 2] * pz + origin[2]
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
def dim_along(kept, start, end, distance, strength, radius, lift):
    """Lowers `kept` (H, W) to 1 - `strength` where edges from `start` to `end`, both (n, 3), are seen."""
    height, width = distance.shape
    left = np.float32(1.0 - strength)
    reach = math.ceil(radius)
    for edge in range(len(start)):
        x0, y0, z0 = start[edge, 0], start[edge, 1], start[edge, 2]
        x1, y1, z1 = end[edge, 0] - x0, end[edge, 1] - y0, end[edge, 2] - z0
        count = min(math.ceil(math.hypot(x1, y1) / _STEP), 4 * (width + height)) + 1
        for point in range(count):
            t = (point + 0.5) / count
            x, y, z = x0 + t * x1, y0 + t * y1, z0 + t * z1
            for dy in range(-reach, reach + 1):
                for dx in range(-reach, reach + 1):
                    column, row = int(x + dx), int(y + dy)
                    if dx * dx + dy * dy > radius * radius or not (0 <= column < width and 0 <= row < height):
                        continue
                    if z - lift <= distance[row, column]:
                        kept[row, column] = min(kept[row, column], left)


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
