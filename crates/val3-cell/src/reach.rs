//! Upper bounds for the movement of bodies, from the largest distances between consecutive axes of the arm.

use val3_kinematics::{Arm, Joints};

/// Largest distances between consecutive axes.
#[derive(Debug, Clone)]
pub(crate) struct Reach {
    /// For each link from 1: the largest distance in mm from its frame to the next link's frame, and whether its axis
    /// is linear.
    links: Vec<(f64, bool)>,
}

impl Reach {
    pub(crate) fn of(arm: &Arm) -> Self {
        let ends = arm.limits().iter().map(|limits| [limits.min, limits.max]);
        let mut positions = vec![Joints::default()];
        for (axis, ends) in ends.enumerate().filter(|(axis, _)| arm.is_stroke(*axis)) {
            positions.extend(ends.map(|end| std::array::from_fn(|other| if other == axis { end } else { 0.0 })));
        }
        let parts: Vec<_> = positions.iter().map(|joints| arm.parts(joints)).collect();
        let links = (1..=arm.axes()).map(|link| {
            let distances = parts.iter().filter_map(|parts| {
                let (here, next) = (parts.get(link)?, parts.get(link + 1)?);
                Some((next.translation.vector - here.translation.vector).norm())
            });
            (distances.fold(0.0, f64::max), arm.is_stroke(link - 1))
        });
        Self { links: links.collect() }
    }

    /// Returns an upper bound in mm for the movement of a point within `radius` of a link's frame, while each axis
    /// moves by `moved` degrees or mm.
    pub(crate) fn way(&self, link: usize, radius: f64, moved: &Joints) -> f64 {
        let mut arm = radius;
        let mut way = 0.0;
        for (number, (distance, is_stroke)) in self.links.iter().enumerate().take(link).rev() {
            arm += if number + 1 == link { 0.0 } else { *distance };
            let moved = moved.get(number).copied().unwrap_or_default().abs();
            way += if *is_stroke { moved } else { moved.to_radians() * arm };
        }
        way
    }
}
