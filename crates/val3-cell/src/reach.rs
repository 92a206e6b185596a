//! Greatest distances from the axes of an arm to its bodies: they bound the movement of a body.

use val3_kinematics::{Arm, Joints};

/// Greatest distances between consecutive axes.
#[derive(Debug, Clone)]
pub(crate) struct Reach {
    /// For each link from 1: greatest distance of the next link's frame from its own, and whether its axis is a stroke.
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

    /// Greatest way in mm of a point within `radius` of the frame of a link, while each axis moves by these degrees or
    /// mm.
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
