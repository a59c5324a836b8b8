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

/// A horned animal: horse's trunk, legs and tail, a short neck, and two horns on the head. Looks to the right.
inline Polygon horned() {
    return {{0, 0},      {1, 0},     {1.5, 6},     {2.4, 0.2},   {3.3, 0.2},   {3.6, 6.2}, {10.4, 6.2},  {10.6, 0.1},
            {11.5, 0.1}, {12, 6},    {12.6, 0},    {13.5, 0},    {14, 8},      {15, 9.8},  {18.4, 8.8},  {18.8, 10.2},
            {16.6, 12},  {18.4, 16}, {17.6, 16.2}, {15.6, 12.6}, {14.6, 12.8}, {15, 16.8}, {14.1, 16.8}, {13, 12.4},
            {11.4, 11},  {2, 10.8},  {-1.4, 8},    {-2.6, 3},    {-1.7, 3},    {-0.2, 7.4}};
}

/// A horse with a rider's trunk, head and two arms where its neck is. Looks to the right.
inline Polygon centaur() {
    return {{0, 0},       {1, 0},       {1.5, 6},     {2.4, 0.2},   {3.3, 0.2},   {3.6, 6.5},   {10.4, 6.5},
            {10.6, 0.1},  {11.5, 0.1},  {12, 6},      {12.6, 0},    {13.5, 0},    {14.2, 9},    {14.4, 13.4},
            {18.2, 12},   {18.8, 13},   {14.6, 15.6}, {13.8, 15.8}, {13.7, 16.4}, {14.6, 17.2}, {14.7, 18.6},
            {13.8, 19.6}, {12.4, 19.6}, {11.6, 18.6}, {11.7, 17.2}, {12.4, 16.4}, {12.2, 15.8}, {10.8, 15.2},
            {8.4, 12.2},  {9.2, 11.5},  {11.6, 13.4}, {11.4, 10.6}, {2, 10.6},    {-1.4, 8},    {-2.6, 3},
            {-1.7, 3},    {-0.2, 7.4}};
}

/// From above: nose to the right, two swept wings and a tail of two fins.
inline Polygon airplane() {
    return {{10, 0},      {8.6, 0.8}, {3, 1},    {-1.5, 8},  {-3, 8},    {-1.4, 1},
            {-6.2, 0.8},  {-8, 3.4},  {-9, 3.4}, {-8.2, 0},  {-9, -3.4}, {-8, -3.4},
            {-6.2, -0.8}, {-1.4, -1}, {-3, -8},  {-1.5, -8}, {3, -1},    {8.6, -0.8}};
}

/// A round body with six legs, and a head with two feelers to the right.
inline Polygon bug() {
    const auto leg = [](double from_deg, double to_deg, double reach) {
        const double a = from_deg * std::numbers::pi / 180, b = to_deg * std::numbers::pi / 180;
        const double c = (a + b) / 2;
        const double half = 0.35 / reach;
        return Polygon{{4.6 * std::cos(a), 3.4 * std::sin(a)},
                       {reach * std::cos(c - half), reach * std::sin(c - half)},
                       {reach * std::cos(c + half), reach * std::sin(c + half)},
                       {4.6 * std::cos(b), 3.4 * std::sin(b)}};
    };
    Polygon ring{{4.9, -1.2}, {6.4, -1.4}, {7.2, -0.9}, {10.4, -2.6}, {10.7, -2}, {7.6, 0},
                 {10.7, 2},   {10.4, 2.6}, {7.2, 0.9},  {6.4, 1.4},   {4.9, 1.2}};
    for (const double at : {50.0, 90.0, 130.0}) {
        const Polygon part = leg(at - 6, at + 6, 8);
        ring.insert(ring.end(), part.begin(), part.end());
    }
    for (const double at : {155.0, 180.0, 205.0}) {
        const double a = at * std::numbers::pi / 180;
        ring.push_back({4.8 * std::cos(a), 3.6 * std::sin(a)});
    }
    for (const double at : {230.0, 270.0, 310.0}) {
        const Polygon part = leg(at - 6, at + 6, 8);
        ring.insert(ring.end(), part.begin(), part.end());
    }
    return ring;
}

/// A band of this width wound so many times about the origin, with half its width of space between the turns.
inline Polygon spiral(double turns, double width) {
    const int n = static_cast<int>(24 * turns);
    const auto at = [&](int k, double more) {
        const double angle = 2 * std::numbers::pi * k / 24;
        const double radius = width + 1.5 * width * angle / (2 * std::numbers::pi) + more;
        return Point{radius * std::cos(angle), radius * std::sin(angle)};
    };
    Polygon ring;
    for (int k = 0; k <= n; ++k) ring.push_back(at(k, width / 2));
    for (int k = n; k >= 0; --k) ring.push_back(at(k, -width / 2));
    return ring;
}

/// An island: a triangle each of whose sides is broken `times` times, its middle moved across by a share that an
/// arithmetic sequence takes from about a quarter inwards to a quarter outwards. 3 * 2^times points.
inline Polygon coastline(int times) {
    Polygon ring{{0, 0}, {100, 0}, {50, 87}};
    unsigned state = 12345;
    for (int k = 0; k < times; ++k) {
        Polygon finer;
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Point a = ring[i], b = ring[(i + 1) % ring.size()];
            state = state * 1103515245U + 12345U;
            const double share = 0.22 * (static_cast<double>(state >> 16 & 0x7fffU) / 16384.0 - 1.0);
            finer.push_back(a);
            finer.push_back(Point{(a.x + b.x) / 2, (a.y + b.y) / 2} + Point{a.y - b.y, b.x - a.x} * share);
        }
        ring = finer;
    }
    return ring;
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
