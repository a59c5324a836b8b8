#pragma once
// Outlines with known parts, anti-clockwise and y up, and ways to move them.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/geometry/point.hpp"

namespace support {

using core::Point;
using core::Polygon;

/// n points on a circle about the origin, the first on the x axis.
inline Polygon disc(int n, double radius) {
    Polygon ring;
    for (int i = 0; i < n; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / n;
        ring.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    }
    return ring;
}

inline Polygon rectangle(double width, double height) {
    return {{0, 0}, {width, 0}, {width, height}, {0, height}};
}

/// Tips at distance `outer`, valleys at `inner`.
inline Polygon star(int tips, double outer, double inner) {
    Polygon ring = disc(2 * tips, 1.0);
    for (std::size_t i = 0; i < ring.size(); ++i) ring[i] = ring[i] * (i % 2 == 0 ? outer : inner);
    return ring;
}

/// Four arms of `width` that reach `reach` from the centre.
inline Polygon cross(double reach, double width) {
    const double w = width / 2;
    return {{w, -reach}, {w, -w}, {reach, -w}, {reach, w},   {w, w},   {w, reach},
            {-w, reach}, {-w, w}, {-reach, w}, {-reach, -w}, {-w, -w}, {-w, -reach}};
}

inline Polygon l_shape(double reach, double width) {
    return {{0, 0}, {reach, 0}, {reach, width}, {width, width}, {width, reach}, {0, reach}};
}

/// A bar with teeth of width 1, gaps of 1 and the given length, upwards.
inline Polygon comb(int teeth, double tooth_length) {
    Polygon ring{{0, 0}, {2.0 * teeth - 1, 0}};
    for (int k = teeth; k-- > 0;) {
        const double x = 2.0 * k;
        const Polygon tooth{{x + 1, 2}, {x + 1, 2 + tooth_length}, {x, 2 + tooth_length}, {x, 2}};
        ring.insert(ring.end(), tooth.begin() + (k == teeth - 1 ? 1 : 0), tooth.end() - (k == 0 ? 1 : 0));
    }
    return ring;
}

/// A palm with four fingers of different lengths and a thumb.
inline Polygon hand() {
    return {{0, 0},    {8, 0},    {9, 4},   {14, 7},   {13, 9},   {8, 7},   {8.2, 16}, {6.4, 16}, {6, 8.5},
            {5.8, 18}, {4.2, 18}, {4, 8.5}, {3.4, 17}, {1.8, 17}, {2, 8.5}, {0.4, 14}, {-1, 14},  {0, 7}};
}

/// Trunk, four legs of two pairs, neck with head, and a tail.
inline Polygon horse() {
    return {{0, 0},      {1, 0},     {1.5, 6},   {2.4, 0.2}, {3.3, 0.2}, {3.6, 6.5}, {10.4, 6.5},  {10.6, 0.1},
            {11.5, 0.1}, {12, 6},    {12.6, 0},  {13.5, 0},  {14, 9},    {16.5, 13}, {19.5, 11.6}, {20, 12.8},
            {16.4, 16},  {15, 16.2}, {12, 10.6}, {2, 10.6},  {-1.4, 8},  {-2.6, 3},  {-1.7, 3},    {-0.2, 7.4}};
}

inline Polygon scaled(Polygon ring, double factor) {
    for (Point& p : ring) p = p * factor;
    return ring;
}

inline Polygon moved(Polygon ring, Point by) {
    for (Point& p : ring) p = p + by;
    return ring;
}

/// Anti-clockwise about the origin.
inline Polygon turned(Polygon ring, double angle_rad) {
    const double c = std::cos(angle_rad), s = std::sin(angle_rad);
    for (Point& p : ring) p = {c * p.x - s * p.y, s * p.x + c * p.y};
    return ring;
}

/// Left and right exchanged, and again anti-clockwise; the first point stays the first.
inline Polygon mirrored(Polygon ring) {
    for (Point& p : ring) p.x = -p.x;
    std::reverse(ring.begin() + 1, ring.end());
    return ring;
}

/// The same ring listed from another point.
inline Polygon started_at(Polygon ring, int first) {
    std::rotate(ring.begin(), ring.begin() + first, ring.end());
    return ring;
}

}  // namespace support
