//! Corners that nearly meet, and corners that are tiny.

use super::*;

/// The duration of three sides of a rectangle; the middle one has this length.
fn around(blend: Blend, middle: f64) -> f64 {
    let mut motion = motion();
    for (y, z) in [(200.0, 0.0), (200.0, middle), (0.0, middle)] {
        motion.record(&request(line(moved(0.0, y, z)), fast(), blend, 0.0)).unwrap();
    }
    motion.close().unwrap();
    motion.time_left().0
}

const SHAPES: [fn(f64) -> Blend; 2] = [
    |distance| Blend::Cartesian { leave: Millimetres(distance), reach: Millimetres(distance) },
    |distance| Blend::Joint { leave: Millimetres(distance), reach: Millimetres(distance) },
];

/// A blend that ends where the next one begins, up to rounding or a hair, costs no time.
#[test]
fn the_time_does_not_depend_on_whether_corners_just_meet() {
    for shape in SHAPES {
        let apart = around(shape(50.0), 100.1);
        for gap in [-1e-3, 0.0, 1e-12, 1e-9, 1e-6, 1e-4, 2e-3, 1e-2] {
            let time = around(shape(50.0), 100.0 + gap);
            assert!((time - apart).abs() < 2e-3, "{time} s with a gap of {gap} mm instead of {apart} s");
        }
    }
}

/// The smaller a corner, the nearer is the time to that of a stop.
#[test]
fn tiny_corners_take_the_time_of_stops() {
    let stops = around(Blend::Off, 100.0);
    for shape in SHAPES {
        for distance in [1e-12, 1e-9, 1e-6, 1e-4, 1e-3, 1e-2, 0.1] {
            let time = around(shape(distance), 100.0);
            assert!(
                time <= stops + 2e-3 && time > stops - 0.1,
                "{time} s with corners of {distance} mm instead of {stops} s"
            );
        }
    }
}

/// Short moves share their length between large corners.
#[test]
fn short_moves_between_large_corners_take_a_time() {
    for shape in SHAPES {
        let short = around(shape(50.0), 0.1);
        for middle in [2e-3, 4e-3, 1e-2] {
            let time = around(shape(50.0), middle);
            assert!((time - short).abs() < 0.05, "{time} s with a middle of {middle} mm instead of {short} s");
        }
    }
}
